// Where the meshes of a scene lie, and what they hold.
#pragma once

#include <string>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Triangles beyond this are refused.
constexpr std::size_t kMaxTriangles = 500000;

/// Where the meshes of a scene may lie; package:// is always allowed.
enum class MeshPlaces {
  kAnywhere,
  kFolder,    ///< only in the folder of the scene file
  kPackages,  ///< only in packages
};

/// Replaces the file of each mesh by its absolute path; package:// stays, wherever it leads.
/// @param folder of the scene file, which relative paths start from
/// @throws InvalidInput for a file that does not exist or that `places` excludes
void findMeshFiles(Scene& scene, const std::string& folder, MeshPlaces places);

/// Reads the triangles of each mesh that names a file.
/// @throws InvalidInput naming the mesh, its file and what is wrong with it
void readMeshFiles(Scene& scene);

/// Checksum of the triangles of a mesh, which a checkpoint holds.
std::uint32_t checksumOf(const TriangleMesh& mesh);

}  // namespace ice_ice_baby
