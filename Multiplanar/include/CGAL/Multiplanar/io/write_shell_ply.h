// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_IO_WRITE_SHELL_PLY_H
#define CGAL_MULTIPLANAR_IO_WRITE_SHELL_PLY_H

#include <CGAL/assertions.h>
#include <CGAL/Multiplanar/Texture.h>
#include <CGAL/Multiplanar/internal/kernel.h>

#include <boost/endian/buffers.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

namespace internal {

/// Numbers as the bytes of a PLY file.
class Ply_bytes
{
public:
  explicit Ply_bytes(std::ostream& out) : out(out) {}

  void put(int value) { write(boost::endian::little_int32_buf_t(value)); }
  void put(float value)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    write(boost::endian::little_uint32_buf_t(bits));
  }
  void put(double value)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    write(boost::endian::little_uint64_buf_t(bits));
  }
  void put_byte(char value) { out.put(value); }

private:
  template <class Buffer>
  void write(const Buffer& little_endian)
  {
    out.write(reinterpret_cast<const char*>(little_endian.data()), sizeof little_endian);
  }
  std::ostream& out;
};

/// By vertex, if all corners there agree; empty if some do not.
inline std::vector<Texture_point> vertex_texture_points(std::size_t vertices,
                                                        const std::vector<std::array<int, 3>>& triangles,
                                                        const std::vector<std::array<Texture_point, 3>>& corners)
{
  std::vector<Texture_point> result(vertices);
  std::vector<bool> known(vertices, false);
  for (std::size_t f = 0; f < corners.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const std::size_t v = std::size_t(triangles[f][i]);
      if (known[v] && result[v] != corners[f][i]) return {};
      result[v] = corners[f][i];
      known[v] = true;
    }
  return corners.empty() ? std::vector<Texture_point>() : result;
}

} // namespace internal

/*!
\ingroup PkgMultiplanarIO

Writes the flattened mesh and its panels as binary PLY, in the units and the order of the input: vertices as doubles, so
that they read back as the same numbers, and a property `int panel` for every face. The stream must be open in binary
mode; the caller checks its state afterwards.

Texture points, if there are any, are written as `float s, t` of the vertices where the texture has no seams. Where it
has, they belong to the corners of faces: as `s0 t0 s1 t1 s2 t2`, numbers of the face that CGAL keeps as properties, and
once more as the list `texcoord` that viewers know.

\param out the stream, in binary mode
\param points positions of the vertices
\param triangles vertices of each face
\param comments lines for the header, printable ASCII without line breaks
\param texture_points of the three corners of every triangle, or empty
\param panel_of_face the panel of every triangle; empty for a mesh that has none
\pre triangles refer to `points`
*/
inline void write_shell_ply(std::ostream& out, const Points& points, const std::vector<std::array<int, 3>>& triangles,
                            const std::vector<int>& panel_of_face, const std::vector<std::string>& comments = {},
                            const std::vector<std::array<Texture_point, 3>>& texture_points = {})
{
  CGAL_precondition(panel_of_face.empty() || panel_of_face.size() == triangles.size());
  CGAL_precondition(texture_points.empty() || texture_points.size() == triangles.size());
  const std::vector<Texture_point> of_vertices =
      internal::vertex_texture_points(points.size(), triangles, texture_points);
  const bool at_corners = !texture_points.empty() && of_vertices.empty();
  out << "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : comments) out << "comment " << comment << "\n";
  out << "element vertex " << points.size() << "\nproperty double x\nproperty double y\nproperty double z\n";
  if (!of_vertices.empty()) out << "property float s\nproperty float t\n";
  out << "element face " << triangles.size() << "\nproperty list uchar int vertex_indices\n";
  if (!panel_of_face.empty()) out << "property int panel\n";
  if (at_corners) {
    for (int i = 0; i < 3; ++i) out << "property float s" << i << "\nproperty float t" << i << "\n";
    out << "property list uchar float texcoord\n";
  }
  out << "end_header\n";
  internal::Ply_bytes bytes(out);
  for (std::size_t v = 0; v < points.size(); ++v) {
    for (int i = 0; i < 3; ++i) bytes.put(CGAL::to_double(points[v][i]));
    if (!of_vertices.empty()) bytes.put(of_vertices[v][0]), bytes.put(of_vertices[v][1]);
  }
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    bytes.put_byte(3);
    for (int v : triangles[f]) bytes.put(v);
    if (!panel_of_face.empty()) bytes.put(panel_of_face[f]);
    for (int time = 0; at_corners && time < 2; ++time) {
      if (time == 1) bytes.put_byte(6);
      for (const Texture_point& p : texture_points[f]) bytes.put(p[0]), bytes.put(p[1]);
    }
  }
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_IO_WRITE_SHELL_PLY_H
