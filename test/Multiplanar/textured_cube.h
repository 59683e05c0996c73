// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_TEXTURED_CUBE_H
#define MULTIPLANAR_TEST_TEXTURED_CUBE_H

#include <CGAL/Multiplanar/Image.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

// The cube [0, 1]^3 with a texture, as files of several formats. Each side has a strip of the texture of its own, so
// all edges are seams; a quarter of each side is white, which tells a turned or reversed picture.

namespace Multiplanar_test {

/// A side of the cube by its axis and end: corners counter-clockwise seen from outside, the first where a = b = 0; a
/// and b are the other two coordinates along the texture, s and t.
struct Cube_side
{
  Cube_side(int axis, int side) : axis(axis), side(side)
  {
    a = side ? (axis + 1) % 3 : (axis + 2) % 3;
    b = side ? (axis + 2) % 3 : (axis + 1) % 3;
  }
  std::array<int, 3> corner(int i) const
  {
    std::array<int, 3> p{};
    p[axis] = side;
    p[a] = i == 1 || i == 2;
    p[b] = i >= 2;
    return p;
  }
  int vertex(int i) const { return corner(i)[0] + 2 * corner(i)[1] + 4 * corner(i)[2]; }
  double s(int i) const { return (2 * axis + side + (i == 1 || i == 2 ? 1 : 0)) / 6.; }
  double t(int i) const { return i >= 2 ? 1 : 0; }

  int axis, side, a, b;
};

inline std::vector<Cube_side> cube_sides()
{
  std::vector<Cube_side> sides;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) sides.emplace_back(axis, side);
  return sides;
}

/// What the cube shows at a point of a side.
inline std::array<int, 3> cube_colour(const double* p, int axis, int side)
{
  const Cube_side s(axis, side);
  if (p[s.a] < 0.5 && p[s.b] > 0.5) return {255, 255, 255};
  return {40 + 100 * axis, 60 + 150 * side, 200 - 80 * axis};
}

inline CGAL::Multiplanar::Image cube_texture()
{
  const int n = 64;
  CGAL::Multiplanar::Image image(6 * n, n);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < 6 * n; ++x) {
      const Cube_side s(x / n / 2, x / n % 2);
      double p[3] = {0, 0, 0};
      p[s.a] = (x % n + 0.5) / n;
      p[s.b] = 1 - (y + 0.5) / n;
      const std::array<int, 3> colour = cube_colour(p, s.axis, s.side);
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = std::uint8_t(colour[c]);
      image.pixel(x, y)[3] = 255;
    }
  return image;
}

inline std::string format(const char* form, double a, double b)
{
  char text[96];
  std::snprintf(text, sizeof text, form, a, b);
  return text;
}

inline std::string cube_vertices(const std::string& before, bool colours = false)
{
  std::string text;
  for (int v = 0; v < 8; ++v) {
    text += before;
    for (int time = 0; time < (colours ? 2 : 1); ++time)
      for (int k = 0; k < 3; ++k) text += std::to_string(v >> k & 1) + (time == 0 ? ".0 " : "  ");
    text += "\n";
  }
  return text;
}

/// Quadrilaterals, numbers counted back from the last; \param library, material empty: none
inline std::string cube_obj(const std::string& library, const std::string& material)
{
  std::string text = cube_vertices("v ");
  if (!library.empty()) text = "mtllib " + library + "\n" + text + "usemtl " + material + "\n";
  for (const Cube_side& side : cube_sides()) {
    for (int i = 0; i < 4; ++i) text += format("vt %.9f %.9f\n", side.s(i), side.t(i));
    text += "f";
    for (int i = 0; i < 4; ++i) text += " " + std::to_string(side.vertex(i) - 8) + "/" + std::to_string(i - 4);
    text += "\n";
  }
  return text;
}

/// The second material on the sides across z.
inline std::string cube_obj_of_two_materials(const std::string& library, const std::string& a, const std::string& b)
{
  std::string text = "mtllib " + library + "\n" + cube_vertices("v ");
  for (const Cube_side& side : cube_sides()) {
    text += "usemtl " + (side.axis == 2 ? b : a) + "\nf";
    for (int i = 0; i < 4; ++i) text += " " + std::to_string(side.vertex(i) + 1);
    text += "\n";
  }
  return text;
}

inline std::string cube_faces(const std::string& before, int first)
{
  std::string text;
  for (const Cube_side& side : cube_sides())
    for (int half = 0; half < 2; ++half) {
      text += before;
      for (int i : {0, half + 1, half + 2}) text += " " + std::to_string(side.vertex(i) + first);
      text += "\n";
    }
  return text;
}

inline std::string cube_obj_with_colours() { return cube_vertices("v ", true) + cube_faces("f", 1); }

inline std::string cube_off_with_colours()
{
  std::string text = "COFF\n8 12 0\n";
  for (int v = 0; v < 8; ++v) {
    char line[80];
    std::snprintf(line, sizeof line, "%d %d %d %d %d %d 255\n", v & 1, v >> 1 & 1, v >> 2 & 1, 255 * (v & 1),
                  255 * (v >> 1 & 1), 255 * (v >> 2 & 1));
    text += line;
  }
  return text + cube_faces("3", 0);
}

inline std::string cube_ply_with_colours()
{
  std::string text = "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
                     "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                     "element face 12\nproperty list uchar int vertex_indices\nend_header\n";
  for (int v = 0; v < 8; ++v) {
    char line[80];
    std::snprintf(line, sizeof line, "%d %d %d %d %d %d\n", v & 1, v >> 1 & 1, v >> 2 & 1, 255 * (v & 1),
                  255 * (v >> 1 & 1), 255 * (v >> 2 & 1));
    text += line;
  }
  return text + cube_faces("3", 0);
}

inline std::string cube_ply(const std::string& picture)
{
  std::string text = "ply\nformat ascii 1.0\ncomment TextureFile " + picture +
                     "\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement face 6\n"
                     "property list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n";
  text += cube_vertices("");
  for (const Cube_side& side : cube_sides()) {
    text += "4";
    for (int i = 0; i < 4; ++i) text += " " + std::to_string(side.vertex(i));
    text += " 8";
    for (int i = 0; i < 4; ++i) text += format(" %.9f %.9f", side.s(i), side.t(i));
    text += "\n";
  }
  return text;
}

/// Binary glTF: vertices of their own for each side, turned into place by a node, the picture inside.
inline std::string cube_glb(const std::string& picture, const std::string& type)
{
  std::string buffer;
  const auto put = [&](const auto& value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    buffer.append(bytes, sizeof value);
  };
  for (const Cube_side& side : cube_sides()) // moved by (-1, -2, -3); the node moves them back
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 3; ++k) put(float(side.corner(i)[std::size_t(k)] - k - 1));
  for (const Cube_side& side : cube_sides())
    for (int i = 0; i < 4; ++i) put(float(side.s(i))), put(float(1 - side.t(i))); // glTF counts from the top
  for (int side = 0; side < 6; ++side)
    for (int i : {0, 1, 2, 0, 2, 3}) put(std::uint16_t(4 * side + i));
  const std::size_t places = 6 * 4 * 12, indices = places + 6 * 4 * 8, image = indices + 6 * 6 * 2;
  buffer += picture;
  while (buffer.size() % 4 != 0) buffer += '\0';
  const auto view = [](std::size_t offset, std::size_t length) {
    return "{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) + ",\"byteLength\":" + std::to_string(length) + "}";
  };
  std::string json =
      "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
      "\"nodes\":[{\"mesh\":0,\"translation\":[1,2,3]}],"
      "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"indices\":2,\"material\":0}]}],"
      "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],"
      "\"textures\":[{\"source\":0,\"sampler\":0}],\"samplers\":[{\"wrapS\":33071,\"wrapT\":33071}],"
      "\"images\":[{\"bufferView\":3,\"mimeType\":\"" +
      type + "\"}],\"buffers\":[{\"byteLength\":" + std::to_string(buffer.size()) + "}],\"bufferViews\":[" +
      view(0, places) + "," + view(places, indices - places) + "," + view(indices, image - indices) + "," +
      view(image, picture.size()) +
      "],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":24,\"type\":\"VEC3\","
      "\"min\":[-1,-2,-3],\"max\":[0,-1,-2]},"
      "{\"bufferView\":1,\"componentType\":5126,\"count\":24,\"type\":\"VEC2\"},"
      "{\"bufferView\":2,\"componentType\":5123,\"count\":36,\"type\":\"SCALAR\"}]}";
  while (json.size() % 4 != 0) json += ' ';
  const std::string body = buffer;
  buffer.clear();
  buffer += "glTF";
  put(std::uint32_t(2));
  put(std::uint32_t(12 + 8 + json.size() + 8 + body.size()));
  put(std::uint32_t(json.size()));
  buffer += "JSON" + json;
  put(std::uint32_t(body.size()));
  buffer += std::string("BIN\0", 4) + body;
  return buffer;
}

} // namespace Multiplanar_test

#endif // MULTIPLANAR_TEST_TEXTURED_CUBE_H
