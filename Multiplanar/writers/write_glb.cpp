// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Assembly_guide.h"
#include "Part_mesh.h"

#include <CGAL/Multiplanar/io/json_format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <ostream>

// The binary form of glTF 2.0: a header, a chunk of JSON, a chunk of numbers (little-endian).

using namespace CGAL::Multiplanar;
using internal::Json;

namespace {

constexpr int float_type = 5126, short_type = 5123, int_type = 5125; // names of OpenGL
constexpr int clamp = 33071;
constexpr int vertex_target = 34962, index_target = 34963;

/// Collects the numbers and describes where they lie.
class Buffer
{
public:
  explicit Buffer(Json& gltf) : gltf(gltf) {}

  /// \return the number of the accessor, as of the other functions
  int add_places(const std::vector<std::array<float, 2>>& places)
  {
    return add({{"bufferView", view(places.data(), 8 * places.size(), vertex_target)},
                {"componentType", float_type},
                {"count", places.size()},
                {"type", "VEC2"}});
  }

  int add_vectors(const std::vector<std::array<float, 3>>& vectors, bool with_range)
  {
    Json accessor = {{"bufferView", view(vectors.data(), 12 * vectors.size(), vertex_target)},
                     {"componentType", float_type},
                     {"count", vectors.size()},
                     {"type", "VEC3"}};
    if (with_range) {
      std::array<float, 3> low = vectors[0], high = low;
      for (const auto& v : vectors)
        for (int i = 0; i < 3; ++i) low[i] = (std::min)(low[i], v[i]), high[i] = (std::max)(high[i], v[i]);
      accessor["min"] = {double(low[0]), double(low[1]), double(low[2])};
      accessor["max"] = {double(high[0]), double(high[1]), double(high[2])};
    }
    return add(accessor);
  }

  int add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices)
  {
    Json accessor = {{"bufferView", 0}, {"componentType", 0}, {"count", indices.size()}, {"type", "SCALAR"}};
    if (vertices < 65535) {
      const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
      accessor["bufferView"] = view(narrow.data(), 2 * narrow.size(), index_target);
      accessor["componentType"] = short_type;
    } else {
      accessor["bufferView"] = view(indices.data(), 4 * indices.size(), index_target);
      accessor["componentType"] = int_type;
    }
    return add(accessor);
  }

  /// \return the number of the buffer view of a file put into the buffer
  int add_file(const std::string& bytes) { return view(bytes.data(), bytes.size(), 0); }

  std::string bytes;

private:
  int view(const void* data, std::size_t size, int target)
  {
    Json view = {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}};
    if (target) view["target"] = target;
    gltf["bufferViews"].push_back(view);
    bytes.append(static_cast<const char*>(data), size);
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    return int(gltf["bufferViews"].size()) - 1;
  }
  int add(const Json& accessor)
  {
    gltf["accessors"].push_back(accessor);
    return int(gltf["accessors"].size()) - 1;
  }

  Json& gltf;
};

std::array<float, 3> floats(double x, double y, double z) { return {float(x), float(y), float(z)}; }

std::vector<std::array<float, 3>> positions(const Mesh_faces& faces)
{
  std::vector<std::array<float, 3>> result;
  for (const Point_3& p : faces.points) result.push_back(floats(p.x(), p.y(), p.z()));
  return result;
}

std::vector<std::array<float, 3>> normals(const Mesh_faces& faces)
{
  std::vector<std::array<float, 3>> result;
  for (const Vector_3& n : faces.normals) {
    const double l = std::sqrt(n.squared_length());
    result.push_back(floats(n.x() / l, n.y() / l, n.z() / l));
  }
  return result;
}

class Glb
{
public:
  explicit Glb(const Assembly_guide& guide) : guide(guide), buffer(gltf)
  {
    gltf["asset"] = {{"version", "2.0"}, {"generator", "multiplanar"}};
    gltf["scene"] = 0;
    for (const char* list : {"scenes", "nodes", "meshes", "materials", "accessors", "bufferViews", "buffers"})
      gltf[list] = Json::array();
    gltf["scenes"].push_back({{"name", guide.title}, {"nodes", {0}}});
    add_root();
    for (int i = 0; i < int(guide.model.parts.size()); ++i) add_part(i);
  }

  void write(std::ostream& out)
  {
    gltf["buffers"].push_back({{"byteLength", buffer.bytes.size()}});
    std::string json = internal::one_line(gltf);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    put(out, 0x46546c67); // "glTF"
    put(out, 2);
    put(out, std::uint32_t(12 + 8 + json.size() + 8 + buffer.bytes.size()));
    chunk(out, 0x4e4f534a, json);
    chunk(out, 0x004e4942, buffer.bytes);
  }

private:
  static void put(std::ostream& out, std::uint32_t x)
  {
    for (int i = 0; i < 4; ++i) out.put(char(x >> (8 * i) & 255));
  }
  static void chunk(std::ostream& out, std::uint32_t type, const std::string& bytes)
  {
    put(out, std::uint32_t(bytes.size()));
    put(out, type);
    out.write(bytes.data(), std::streamsize(bytes.size()));
  }

  /// From millimetres in the model's axes to metres with y up.
  void add_root()
  {
    Json root = {{"name", guide.title}, {"scale", {0.001, 0.001, 0.001}}, {"children", Json::array()}};
    if (guide.up.z() > 0.5) root["rotation"] = {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)};
    gltf["nodes"].push_back(root);
  }

  int material(const Linear_colour& colour, double roughness)
  {
    return add_material({{"baseColorFactor", {double(colour[0]), double(colour[1]), double(colour[2]), 1.0}},
                         {"metallicFactor", 0.0},
                         {"roughnessFactor", roughness}});
  }

  int picture_material(const Part_picture& picture)
  {
    for (const char* list : {"images", "textures", "samplers"})
      if (!gltf.contains(list)) gltf[list] = Json::array();
    if (gltf["samplers"].empty()) gltf["samplers"].push_back({{"wrapS", clamp}, {"wrapT", clamp}});
    gltf["images"].push_back({{"bufferView", buffer.add_file(jpeg_of_picture(picture))}, {"mimeType", "image/jpeg"}});
    gltf["textures"].push_back({{"sampler", 0}, {"source", gltf["images"].size() - 1}});
    return add_material({{"baseColorTexture", {{"index", gltf["textures"].size() - 1}}},
                         {"metallicFactor", 0.0},
                         {"roughnessFactor", 0.8}});
  }

  int add_material(const Json& pbr)
  {
    const Json material = {{"pbrMetallicRoughness", pbr}};
    for (std::size_t i = 0; i < gltf["materials"].size(); ++i)
      if (gltf["materials"][i] == material) return int(i);
    gltf["materials"].push_back(material);
    return int(gltf["materials"].size()) - 1;
  }

  Json primitive(const Mesh_faces& faces, int material)
  {
    std::vector<std::uint32_t> indices;
    for (const auto& t : faces.triangles)
      for (const int i : t) indices.push_back(std::uint32_t(i));
    Json attributes = {{"POSITION", buffer.add_vectors(positions(faces), true)},
                       {"NORMAL", buffer.add_vectors(normals(faces), false)}};
    return {{"attributes", attributes},
            {"indices", buffer.add_indices(indices, faces.points.size())},
            {"material", material}};
  }

  Json outer_face(int i, const Mesh_faces& faces)
  {
    const auto picture = guide.pictures.find(guide.model.parts[i].id);
    if (picture == guide.pictures.end() || !picture->second.texture)
      return primitive(faces, material(guide.colour[i], 0.75));
    const Part_picture& p = picture->second;
    Json result = primitive(faces, picture_material(p));
    std::vector<std::array<float, 2>> places;
    for (const Point_2& q : faces.places)
      places.push_back({float((q.x() - p.origin.x()) / p.width), float(1 - (q.y() - p.origin.y()) / p.height)});
    result["attributes"]["TEXCOORD_0"] = buffer.add_places(places);
    return result;
  }

  void add_part(int i)
  {
    const Part& part = guide.model.parts[i];
    const Part_mesh mesh = part_mesh(part, guide.model.settings.thickness, part.frame.origin);
    Linear_colour cut = guide.colour[i]; // what the beam leaves is darker
    for (float& c : cut) c *= 0.6f;
    Json primitives = Json::array();
    if (!mesh.outer.triangles.empty()) primitives.push_back(outer_face(i, mesh.outer));
    primitives.push_back(primitive(mesh.rest, material(cut, 0.9)));
    gltf["meshes"].push_back({{"name", part.id}, {"primitives", primitives}});
    const Point_3& o = part.frame.origin;
    gltf["nodes"][0]["children"].push_back(gltf["nodes"].size());
    gltf["nodes"].push_back({{"name", part.id},
                             {"mesh", gltf["meshes"].size() - 1},
                             {"translation", {o.x(), o.y(), o.z()}},
                             {"extras", extras(i)}});
  }

  Json extras(int i) const
  {
    Json result = {{"kind", guide.is_panel(i) ? "panel" : "connector"},
                   {"explode", internal::to_json(explosion_of(guide, i))}};
    if (guide.sheet[i] >= 0) result["sheet"] = guide.sheet[i] + 1;
    if (guide.step[i] >= 0) {
      const Assembly_step& step = guide.model.assembly[guide.step[i]];
      result["step"] = guide.step[i] + 1;
      result["direction"] = internal::to_json(step.direction);
      result["travel"] = step.travel;
    }
    return result;
  }

  const Assembly_guide& guide;
  Json gltf = Json::object();
  Buffer buffer;
};

} // namespace

void write_glb(std::ostream& out, const Assembly_guide& guide) { Glb(guide).write(out); }
