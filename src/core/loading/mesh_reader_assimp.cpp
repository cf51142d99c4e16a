#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cstring>

#include "ice_ice_baby/errors.h"
#include "loading/in_own_process.h"
#include "loading/mesh_reader.h"

namespace ice_ice_baby {

namespace {

/// Processor time for reading a file: ten times what sound files of this size took.
int limit_s(std::size_t bytes) { return 2 + static_cast<int>(bytes >> 20); }

TriangleMesh read(const std::string& bytes, const std::string& extension) {
  Assimp::Importer importer;
  // As rviz: the axes stay those of the file.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_LINE | aiPrimitiveType_POINT);
  // From memory, so that no other file is opened.
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(),
                                                     aiProcess_Triangulate | aiProcess_SortByPType |
                                                         aiProcess_PreTransformVertices |
                                                         aiProcess_ValidateDataStructure,
                                                     extension.c_str());
  if (scene == nullptr)
    throw InvalidInput("cannot be read: " + shortened(importer.GetErrorString()));
  TriangleMesh mesh;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& part = *scene->mMeshes[m];
    const auto first = static_cast<Index>(mesh.vertices.size());
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      mesh.vertices.emplace_back(part.mVertices[v].x, part.mVertices[v].y, part.mVertices[v].z);
    }
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices != 3) continue;
      mesh.triangles.push_back(
          {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
    }
  }
  return mesh;
}

/// The numbers of a mesh as bytes: how many vertices, the vertices, the triangles.
std::string packed(const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.vertices.size();
  std::string bytes(reinterpret_cast<const char*>(&vertices), sizeof vertices);
  for (const Vec3d& vertex : mesh.vertices) {
    bytes.append(reinterpret_cast<const char*>(vertex.data()), 3 * sizeof(double));
  }
  for (const auto& corners : mesh.triangles) {
    bytes.append(reinterpret_cast<const char*>(corners.data()), sizeof corners);
  }
  return bytes;
}

TriangleMesh unpacked(const std::string& bytes) {
  TriangleMesh mesh;
  std::size_t vertices = 0, at = sizeof vertices;
  std::memcpy(&vertices, bytes.data(), sizeof vertices);
  mesh.vertices.resize(vertices);
  for (Vec3d& vertex : mesh.vertices) {
    std::memcpy(vertex.data(), bytes.data() + at, 3 * sizeof(double));
    at += 3 * sizeof(double);
  }
  mesh.triangles.resize((bytes.size() - at) / sizeof(std::array<Index, 3>));
  for (auto& corners : mesh.triangles) {
    std::memcpy(corners.data(), bytes.data() + at, sizeof corners);
    at += sizeof corners;
  }
  return mesh;
}

}  // namespace

/// In a process of its own, because the library ends its process for some damaged files.
TriangleMesh readMesh(const std::string& bytes, const std::string& extension) {
  return unpacked(
      inOwnProcess([&] { return packed(read(bytes, extension)); }, limit_s(bytes.size())));
}

}  // namespace ice_ice_baby
