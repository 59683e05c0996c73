// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "failure.h"
#include "read_mesh.h"
#include "texture_path.h"

#include <assimp/GltfMaterial.h>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>

using CGAL::Multiplanar::Linear_colour;
using CGAL::Multiplanar::Texture_wrap;

namespace {

/// Lets Assimp open the file itself and what lies beside or below it, nothing else.
class Folder_only : public Assimp::DefaultIOSystem
{
public:
  explicit Folder_only(std::string file) : file(std::move(file)) {}

  bool Exists(const char* name) const override { return !allowed(name).empty(); }
  Assimp::IOStream* Open(const char* name, const char* mode) override
  {
    const std::string path = allowed(name);
    return path.empty() || mode[0] != 'r' ? nullptr : Assimp::DefaultIOSystem::Open(path.c_str(), mode);
  }

private:
  std::string allowed(const std::string& name) const
  {
    if (name == file) return file;
    std::string reason;
    return file_below(folder_of(file), std::filesystem::path(name).lexically_relative(folder_of(file)).string(),
                      reason);
  }

  std::string file;
};

Texture_wrap wrap_of(int mode)
{
  if (mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal) return Texture_wrap::clamp;
  return mode == aiTextureMapMode_Mirror ? Texture_wrap::mirror : Texture_wrap::repeat;
}

/// A picture inside the file is named "*3"; others are files.
void take_texture(const aiScene& scene, const std::string& path, const std::string& name, Soup_material& result,
                  std::vector<std::string>& notes)
{
  const aiTexture* embedded = scene.GetEmbeddedTexture(path.c_str());
  if (embedded && embedded->mHeight == 0 && embedded->pcData) {
    result.texture_bytes.assign(reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth);
    return;
  }
  std::string reason = "it is in no form that can be read";
  if (!embedded) result.texture_file = file_below(folder_of(name), path, reason);
  if (result.texture_file.empty())
    notes.push_back("texture of material " + ::quoted(result.name) + ": " + reason + ": it stays plain");
}

/// Colours of glTF are linear; the base colour multiplies the texture.
Soup_material material_of(const aiScene& scene, const aiMaterial& material, const std::string& name,
                          std::vector<std::string>& notes)
{
  Soup_material result;
  aiString text;
  if (material.Get(AI_MATKEY_NAME, text) == aiReturn_SUCCESS) result.name = text.C_Str();
  aiColor4D base(1, 1, 1, 1);
  if (material.Get(AI_MATKEY_BASE_COLOR, base) != aiReturn_SUCCESS) material.Get(AI_MATKEY_COLOR_DIFFUSE, base);
  const float channels[3] = {base.r, base.g, base.b};
  for (int c = 0; c < 3; ++c)
    result.colour[c] = result.tint[c] = std::isfinite(channels[c]) ? std::min(1.f, std::max(0.f, channels[c])) : 1;
  if (material.Get(AI_MATKEY_GLTF_ALPHAMODE, text) != aiReturn_SUCCESS || std::strcmp(text.C_Str(), "OPAQUE") == 0)
    result.ignores_alpha = true;
  for (aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
    if (material.GetTexture(type, 0, &text) != aiReturn_SUCCESS) continue;
    int mode = aiTextureMapMode_Wrap;
    material.Get(AI_MATKEY_MAPPINGMODE_U(type, 0), mode);
    result.wrap_s = wrap_of(mode);
    mode = aiTextureMapMode_Wrap;
    material.Get(AI_MATKEY_MAPPINGMODE_V(type, 0), mode);
    result.wrap_t = wrap_of(mode);
    take_texture(scene, text.C_Str(), name, result, notes);
    break;
  }
  return result;
}

/// Puts the meshes of a scene, each as often as nodes show it, into one soup.
class Scene_reader
{
public:
  Scene_reader(const aiScene& scene, const std::string& name) : scene(scene), name(name) {}

  Polygon_soup read()
  {
    Soup_appearance& looks = soup.appearance;
    for (unsigned m = 0; m < scene.mNumMaterials; ++m)
      looks.materials.push_back(material_of(scene, *scene.mMaterials[m], name, looks.notes));
    if (scene.mRootNode) add_node(*scene.mRootNode, aiMatrix4x4(), 0);
    looks.colours_multiply = true;
    if (!has_points) looks.texture_points.clear();
    if (!has_colours) looks.corner_colours.clear();
    return std::move(soup);
  }

private:
  void add_node(const aiNode& node, const aiMatrix4x4& parent, int depth)
  {
    if (depth > 1000) throw input_error(name + ": nodes are nested too deeply");
    const aiMatrix4x4 transform = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      if (node.mMeshes[i] < scene.mNumMeshes) add_mesh(*scene.mMeshes[node.mMeshes[i]], transform);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(*node.mChildren[i], transform, depth + 1);
  }

  void add_mesh(const aiMesh& mesh, const aiMatrix4x4& transform)
  {
    if (!(mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) && !(mesh.mPrimitiveTypes & aiPrimitiveType_POLYGON)) return;
    const std::size_t first = soup.points.size();
    if (first + mesh.mNumVertices > std::size_t(std::numeric_limits<int>::max()) || !mesh.HasPositions())
      throw input_error(name + ": a mesh has too many vertices, or none");
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) soup.points.push_back(placed(transform, mesh.mVertices[v]));
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) add_face(mesh, mesh.mFaces[f], int(first));
  }

  std::array<double, 3> placed(const aiMatrix4x4& m, const aiVector3D& p) const
  {
    const double x = p.x, y = p.y, z = p.z;
    const std::array<double, 3> result = {m.a1 * x + m.a2 * y + m.a3 * z + m.a4, m.b1 * x + m.b2 * y + m.b3 * z + m.b4,
                                          m.c1 * x + m.c2 * y + m.c3 * z + m.c4};
    for (double c : result)
      if (!std::isfinite(c))
        throw input_error(name + ": vertex " + std::to_string(soup.points.size()) +
                          ": a coordinate is not finite: repair the mesh first");
    return result;
  }

  void add_face(const aiMesh& mesh, const aiFace& face, int first)
  {
    if (face.mNumIndices < 3) return; // points and lines
    Soup_appearance& looks = soup.appearance;
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      const unsigned v = face.mIndices[i];
      if (v >= mesh.mNumVertices)
        throw input_error(name + ": face " + std::to_string(soup.number_of_faces()) +
                          " names a vertex that is not there");
      soup.indices.push_back(first + int(v));
      CGAL::Multiplanar::Texture_point place = no_texture_point();
      if (mesh.HasTextureCoords(0)) place = {mesh.mTextureCoords[0][v].x, mesh.mTextureCoords[0][v].y};
      looks.texture_points.push_back(place);
      Linear_colour colour{{1, 1, 1}};
      if (mesh.HasVertexColors(0)) colour = {mesh.mColors[0][v].r, mesh.mColors[0][v].g, mesh.mColors[0][v].b};
      looks.corner_colours.push_back(colour);
      has_points = has_points || mesh.HasTextureCoords(0);
      has_colours = has_colours || mesh.HasVertexColors(0);
    }
    soup.close_face();
    looks.face_materials.push_back(mesh.mMaterialIndex < scene.mNumMaterials ? int(mesh.mMaterialIndex) : -1);
  }

  const aiScene& scene;
  const std::string& name;
  Polygon_soup soup;
  bool has_points = false, has_colours = false;
};

} // namespace

Polygon_soup read_gltf(std::string_view, const std::string& name)
{
  Assimp::Importer importer;
  importer.SetIOHandler(new Folder_only(name)); // the importer deletes it
  const aiScene* scene = nullptr;
  try {
    scene = importer.ReadFile(name, 0); // no steps afterwards: nothing is joined, split or sorted
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw input_error(name + ": " + ::quoted(error.what()) + ": the file is damaged or not glTF");
  }
  if (!scene)
    throw input_error(name + ": " + ::quoted(importer.GetErrorString()) + ": the file is damaged or not glTF");
  return Scene_reader(*scene, name).read();
}
