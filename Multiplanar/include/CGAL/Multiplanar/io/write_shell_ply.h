// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_IO_WRITE_SHELL_PLY_H
#define CGAL_MULTIPLANAR_IO_WRITE_SHELL_PLY_H

#include <CGAL/assertions.h>
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

/*!
\ingroup PkgMultiplanarIO

Writes the flattened mesh and its panels as binary PLY, in the units and the order of the input: vertices as doubles, so
that they read back as the same numbers, and a property `int panel` for every face. The stream must be open in binary
mode; the caller checks its state afterwards.

\param comments lines for the header, printable ASCII without line breaks
\pre one panel a triangle; triangles refer to `points`
*/
inline void write_shell_ply(std::ostream& out, const Points& points, const std::vector<std::array<int, 3>>& triangles,
                            const std::vector<int>& panel_of_face, const std::vector<std::string>& comments = {})
{
  CGAL_precondition(panel_of_face.size() == triangles.size());
  out << "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : comments) out << "comment " << comment << "\n";
  out << "element vertex " << points.size() << "\nproperty double x\nproperty double y\nproperty double z\n"
      << "element face " << triangles.size() << "\nproperty list uchar int vertex_indices\nproperty int panel\n"
      << "end_header\n";
  const auto put = [&out](const auto& little_endian) {
    out.write(reinterpret_cast<const char*>(little_endian.data()), sizeof little_endian);
  };
  for (const Point_3& p : points)
    for (int i = 0; i < 3; ++i) {
      const double x = p[i];
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      put(boost::endian::little_uint64_buf_t(bits));
    }
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    out.put(3);
    for (int v : triangles[f]) put(boost::endian::little_int32_buf_t(v));
    put(boost::endian::little_int32_buf_t(panel_of_face[f]));
  }
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_IO_WRITE_SHELL_PLY_H
