#include "loading/mesh_files.h"

#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/item_names.h"
#include "ice_ice_baby/errors.h"
#include "loading/mesh_reader.h"
#include "loading/scene_files.h"
#include "meshes/mesh_topology.h"

namespace ice_ice_baby {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxFile_bytes = 256u << 20;
/// Meshes may be mirrored, not flattened.
constexpr double kSmallestStretch = 1e-3;
constexpr const char* kPackage = "package://";

std::string extensionOf(const fs::path& file) {
  std::string extension = file.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

/// Folders that may hold a ROS package, from the environment.
std::vector<fs::path> packageFolders(const std::string& package) {
  std::vector<fs::path> folders;
  const auto add = [&](const char* variable, const char* below) {
    const char* list = std::getenv(variable);
    std::stringstream stream(list ? list : "");
    for (std::string entry; std::getline(stream, entry, ':');) {
      if (entry.empty()) continue;
      const fs::path path = fs::path(entry) / below;
      folders.push_back(path / package);
      if (fs::path(entry).filename() == package) folders.emplace_back(entry);
    }
  };
  add("ROS_PACKAGE_PATH", "");
  add("CMAKE_PREFIX_PATH", "share");
  folders.push_back(fs::path("/usr/share") / package);
  return folders;
}

fs::path packageFile(const std::string& file) {
  const std::string rest = file.substr(std::string(kPackage).size());
  const std::size_t slash = rest.find('/');
  const std::string package = rest.substr(0, slash);
  if (package.empty() || slash == std::string::npos || package == "." || package == "..") {
    throw InvalidInput("is not of the form package://PACKAGE/PATH");
  }
  for (const fs::path& folder : packageFolders(package)) {
    std::error_code error;
    if (!fs::exists(folder / "package.xml", error)) continue;
    const fs::path path = folder / rest.substr(slash + 1);
    if (!fs::exists(path, error) || liesWithin(path.string(), folder.string())) return path;
    throw InvalidInput("lies outside package " + shortened(package) + "; copy it there");
  }
  throw InvalidInput("names package " + shortened(package) +
                     ", which is in none of the folders of ROS_PACKAGE_PATH; source the setup.bash "
                     "of its workspace");
}

bool inPackage(const std::string& file) { return file.rfind(kPackage, 0) == 0; }

/// Where a file lies that has been found before.
std::string placeOf(const std::string& file) {
  return inPackage(file) ? packageFile(file).string() : file;
}

std::string pathOf(const std::string& file, const fs::path& folder, MeshPlaces places) {
  if (file.empty()) throw InvalidInput("is missing; set it to an STL, OBJ, DAE or PLY file");
  const bool in_package = inPackage(file);
  if (places == MeshPlaces::kPackages && !in_package) {
    throw InvalidInput(
        "must begin with package://, because this scene came as text; put the file into a package");
  }
  const fs::path path = in_package ? packageFile(file) : folder / file;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    throw InvalidInput(
        "is not an ordinary file" +
        std::string(in_package ? "" : " in " + shortened(fs::absolute(folder, error).string())));
  }
  if (places == MeshPlaces::kFolder && !in_package && !liesWithin(path.string(), folder.string())) {
    throw InvalidInput("lies outside the folder of the scene, " + shortened(folder.string()) +
                       "; copy it there, or run the scene by its path");
  }
  return in_package ? file : fs::canonical(path, error).string();
}

std::string bytesOf(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  if (!stream || fs::file_size(path) > kMaxFile_bytes) {
    throw InvalidInput(stream ? "is larger than 256 MiB, the largest allowed" : "cannot be read");
  }
  text << stream.rdbuf();
  if (text.str().empty()) throw InvalidInput("is empty");
  return text.str();
}

void requireSound(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw InvalidInput("has no triangles with an area");
  if (mesh.triangles.size() > kMaxTriangles) {
    throw InvalidInput("has " + std::to_string(mesh.triangles.size()) + " triangles; at most " +
                       std::to_string(kMaxTriangles) + " are allowed, so simplify it");
  }
  for (const Vec3d& vertex : mesh.vertices) {
    if (vertex.allFinite() && vertex.cwiseAbs().maxCoeff() <= kMaxCoordinate_m) continue;
    throw InvalidInput("has a vertex at [" + numberText(vertex.x()) + ", " +
                       numberText(vertex.y()) + ", " + numberText(vertex.z()) +
                       "] m, outside the allowed range [" + numberText(-kMaxCoordinate_m) + ", " +
                       numberText(kMaxCoordinate_m) + "]; check its scale");
  }
}

/// Mirrored triangles still face outwards.
void stretch(const Vec3d& factors, TriangleMesh& mesh) {
  for (Vec3d& vertex : mesh.vertices) vertex = vertex.cwiseProduct(factors);
  if (factors.prod() > 0) return;
  for (auto& corners : mesh.triangles) std::swap(corners[1], corners[2]);
}

/// @param factors metres per unit of the file, along each axis
std::shared_ptr<const TriangleMesh> readFile(const std::string& path, const Vec3d& factors) {
  const std::string extension = extensionOf(path);
  if (extension != "stl" && extension != "obj" && extension != "dae" && extension != "ply") {
    throw InvalidInput("must end in .stl, .obj, .dae or .ply");
  }
  TriangleMesh mesh = readMesh(bytesOf(path), extension);
  stretch(factors, mesh);
  for (const auto& corners : mesh.triangles) {
    for (const Index corner : corners) {
      if (corner >= mesh.vertices.size())
        throw InvalidInput("names a vertex that it does not have");
    }
  }
  requireSound(mesh);
  mesh = welded(mesh);
  requireSound(mesh);
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

void requireStretch(const Mesh& mesh, std::size_t k) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(mesh.stretch[axis]) >= kSmallestStretch) continue;
    throw InvalidInput(wordsFor("meshes", k, mesh) + ": stretch." + std::to_string(axis) + " = " +
                       numberText(mesh.stretch[axis]) + " must be at least " +
                       numberText(kSmallestStretch) + ", or at most " +
                       numberText(-kSmallestStretch) + " to mirror the mesh");
  }
}

/// Adds the key and the value to what a message says about the file.
template <class Action>
void forMesh(const Scene& scene, std::size_t k, const Action& action) {
  const std::string file = scene.meshes[k].file;
  try {
    action();
  } catch (const InvalidInput& e) {
    throw InvalidInput("meshes." + std::to_string(k) + ".file = " + shortened(file) + " " +
                       e.what());
  }
}

}  // namespace

void findMeshFiles(Scene& scene, const std::string& folder, MeshPlaces places) {
  for (std::size_t k = 0; k < scene.meshes.size(); ++k) {
    if (scene.meshes[k].triangles) continue;
    forMesh(scene, k, [&] { scene.meshes[k].file = pathOf(scene.meshes[k].file, folder, places); });
  }
}

void readMeshFiles(Scene& scene) {
  for (std::size_t k = 0; k < scene.meshes.size(); ++k) {
    Mesh& mesh = scene.meshes[k];
    if (mesh.triangles) continue;
    requireStretch(mesh, k);
    forMesh(scene, k,
            [&] { mesh.triangles = readFile(placeOf(mesh.file), mesh.scale * mesh.stretch); });
  }
}

std::uint32_t checksumOf(const TriangleMesh& mesh) {
  uLong sum = 0;
  for (const Vec3d& vertex : mesh.vertices) {
    sum = crc32_z(sum, reinterpret_cast<const Bytef*>(vertex.data()), 3 * sizeof(double));
  }
  for (const auto& corners : mesh.triangles) {
    sum = crc32_z(sum, reinterpret_cast<const Bytef*>(corners.data()), 3 * sizeof(Index));
  }
  return static_cast<std::uint32_t>(sum);
}

}  // namespace ice_ice_baby
