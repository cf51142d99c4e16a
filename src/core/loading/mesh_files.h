// Where the meshes of a scene lie, and what they hold.
#pragma once

#include <string>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Triangles beyond this are refused.
constexpr std::size_t kMaxTriangles = 500000;

/// Replaces the file of each mesh by its absolute path; package:// stays, wherever it leads.
/// @param folder of the scene file, which relative paths start from
/// @param confined whether no file may lie outside that folder
/// @throws InvalidInput for a file that does not exist or lies outside
void findMeshFiles(Scene& scene, const std::string& folder, bool confined);

/// Reads the triangles of each mesh that names a file.
/// @throws InvalidInput naming the mesh, its file and what is wrong with it
void readMeshFiles(Scene& scene);

/// Checksum of the triangles of a mesh, which a checkpoint holds.
std::uint32_t checksumOf(const TriangleMesh& mesh);

}  // namespace ice_ice_baby
