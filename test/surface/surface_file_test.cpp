// Files of surfaces, read back by the library that reads meshes.
#include "surface_file.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "closed_surfaces.h"
#include "ice_ice_baby/errors.h"
#include "loading/mesh_reader.h"
#include "meshes/mesh_topology.h"

namespace ice_ice_baby {
namespace surface_file_test {

namespace fs = std::filesystem;

class SurfaceFileTest : public test::SurfaceCase {
 protected:
  std::string path(const std::string& extension) const {
    return (fs::path(testing::TempDir()) / ("iib_surface." + extension)).string();
  }
};

std::string bytesOf(const std::string& path) {
  std::stringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

TEST_F(SurfaceFileTest, AreReadBackByAnotherProgramsLibrary) {
  const auto particles = test::waterWhere(0.02, 0.1, [](const Vec3d& x) { return x.norm() < 0.1; });
  const FluidSurface surface = surfaceOf(particles, Phase::kWater, 0.02);
  for (const std::string extension : {"ply", "obj"}) {
    extension == "ply" ? writePly(path(extension), surface) : writeObj(path(extension), surface);
    TriangleMesh read;
    try {
      read = readMesh(bytesOf(path(extension)), extension);
    } catch (const InvalidInput& e) {
      GTEST_SKIP() << e.what();
    }
    EXPECT_EQ(read.triangles.size(), surface.triangles.size()) << extension;
    const MeshTopology topology = topologyOf(welded(read));
    EXPECT_TRUE(topology.closed()) << extension;
    EXPECT_NEAR(topology.volume_m3 / surface.volume_m3(), 1.0, 1e-4) << extension;
  }
}

TEST_F(SurfaceFileTest, ThatCannotBeWrittenSaySo) {
  EXPECT_THROW(writePly("/no/such/folder/surface.ply", {}), InvalidInput);
  EXPECT_THROW(writeObj("/no/such/folder/surface.obj", {}), InvalidInput);
}

}  // namespace surface_file_test
}  // namespace ice_ice_baby
