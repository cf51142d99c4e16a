// Meshes of a scene: their files, and what is refused.
#include "loading/mesh_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "fixtures.h"
#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"
#include "meshes/mesh_topology.h"

namespace ice_ice_baby {
namespace mesh_files_test {

namespace fs = std::filesystem;

/// A cube with sides of 1, once as each kind of file.
constexpr const char* kObj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
constexpr const char* kPly =
    "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 6\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
    "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
constexpr const char* kDae = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="metre" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="24">0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1</float_array>
<technique_common><accessor source="#a" count="8" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="6"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4 4 4 4 4 4</vcount>
<p>3 2 1 0 4 5 6 7 0 1 5 4 1 2 6 5 2 3 7 6 3 0 4 7</p></polylist></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><translate>0 0 2</translate>
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

std::string stlOf(const TriangleMesh& mesh) {
  std::string text = "solid cube\n";
  for (const auto& t : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const Index corner : t) {
      const Vec3d& v = mesh.vertices[corner];
      text +=
          "vertex " + numberText(v.x()) + " " + numberText(v.y()) + " " + numberText(v.z()) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid cube\n";
}

class MeshFilesTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("iib_meshes_" + std::to_string(getpid()));
    fs::create_directories(folder_ / "scenes");
    write("cube.obj", kObj);
    if (!readsMeshes()) GTEST_SKIP() << "this build reads no meshes";
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / "scenes" / name, std::ios::binary) << text;
    return folder_ / "scenes" / name;
  }
  /// A scene with that mesh and no water near it.
  Scene sceneWith(const std::string& file, const std::string& more = "") const {
    const fs::path path =
        write("scene.yaml",
              "fluid: {spacing_m: 0.1}\nblocks: [{min_m: [3, 0, 0], max_m: [3.5, 0.5, 0.5]}]\n"
              "meshes: [{name: cup, file: \"" +
                  file + "\"" + more + "}]\n");
    return loadScene(path.string());
  }
  std::string refusal(const std::string& file, const std::string& more = "") const {
    try {
      sceneWith(file, more);
    } catch (const InvalidInput& e) {
      return e.what();
    }
    return "taken";
  }
  bool readsMeshes() const { return refusal("cube.obj").find("libassimp") == std::string::npos; }

  fs::path folder_;
};

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST_F(MeshFilesTest, EveryKindOfFileHoldsTheSameCube) {
  const TriangleMesh cube = *sceneWith("cube.obj").meshes[0].triangles;
  EXPECT_EQ(cube.vertices.size(), 8u);
  EXPECT_EQ(cube.triangles.size(), 12u);
  write("cube.ply", kPly);
  write("cube.stl", stlOf(cube));
  write("cube.dae", kDae);
  for (const char* file : {"cube.obj", "cube.ply", "cube.stl", "cube.dae"}) {
    const Scene scene = sceneWith(file, ", scale: 0.5");
    const TriangleMesh& mesh = *scene.meshes[0].triangles;
    const MeshTopology topology = topologyOf(mesh);
    EXPECT_TRUE(topology.closed()) << file;
    EXPECT_NEAR(topology.volume_m3, 0.125, 1e-7) << file;
    Eigen::AlignedBox3d box;
    for (const Vec3d& vertex : mesh.vertices) box.extend(vertex);
    // The node of the .dae lies 2 above the origin, and z stays up.
    const double up = std::string(file) == "cube.dae" ? 1.0 : 0.0;
    EXPECT_LT((box.min() - Vec3d(0, 0, up)).norm(), 1e-6) << file;
  }
}

TEST_F(MeshFilesTest, MayBeStretchedAndMirrored) {
  const Scene scene = sceneWith("cube.obj", ", scale: 0.5, stretch: [1, -2, 0.5]");
  const TriangleMesh& mesh = *scene.meshes[0].triangles;
  EXPECT_TRUE(topologyOf(mesh).closed());
  EXPECT_NEAR(topologyOf(mesh).volume_m3, 0.125, 1e-7) << "above 0, so it faces outwards";
  Eigen::AlignedBox3d box;
  for (const Vec3d& vertex : mesh.vertices) box.extend(vertex);
  EXPECT_LT((box.min() - Vec3d(0, -1, 0)).norm(), 1e-6);
  EXPECT_LT((box.max() - Vec3d(0.5, 0, 0.25)).norm(), 1e-6);
  EXPECT_SAYS(refusal("cube.obj", ", stretch: [1, 0, 1]"), "stretch.1 = 0 must be at least 0.001");
  EXPECT_SAYS(refusal("cube.obj", ", stretch: [1, 1, 1001]"), "outside the allowed range");
}

TEST_F(MeshFilesTest, RefusesWhatIsNoMesh) {
  EXPECT_SAYS(refusal("none.stl"), "is not an ordinary file in");
  EXPECT_SAYS(refusal(""), "is missing; set it to an STL");
  write("cube.xyz", kObj);
  EXPECT_SAYS(refusal("cube.xyz"), "must end in .stl, .obj, .dae or .ply");
  write("empty.stl", "");
  EXPECT_SAYS(refusal("empty.stl"), "empty.stl is empty");
  write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  EXPECT_SAYS(refusal("flat.obj"), "has no triangles with an area");
  write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  EXPECT_NE(refusal("nan.obj"), "taken");
  EXPECT_SAYS(refusal("cube.obj", ", scale: 1e6"), "check its scale");
  EXPECT_SAYS(refusal("package://no_such_package/cup.stl"), "source the setup.bash");
  EXPECT_SAYS(refusal("package://cup.stl"), "package://PACKAGE/PATH");
}

TEST_F(MeshFilesTest, OfASceneByNameStayInItsFolder) {
  fs::copy(folder_ / "scenes" / "cube.obj", folder_ / "outside.obj");
  sceneWith("cube.obj");
  setenv("ICE_ICE_BABY_SCENES", (folder_ / "scenes").c_str(), 1);
  EXPECT_NO_THROW(loadScene("scene"));
  std::string said;
  EXPECT_NO_THROW(sceneWith("../outside.obj")) << "by path";
  try {
    loadScene("scene");
  } catch (const InvalidInput& e) {
    said = e.what();
  }
  unsetenv("ICE_ICE_BABY_SCENES");
  EXPECT_SAYS(said, "lies outside the folder of the scene");
}

TEST_F(MeshFilesTest, OfASceneAsTextLieInPackages) {
  for (const std::string& file : {(folder_ / "scenes" / "cube.obj").string(),
                                  std::string("/no/such/file.obj"), std::string("cube.obj")}) {
    const std::string said =
        test::refusalOf([&] { parseForeignScene("meshes: [{file: " + file + "}]"); });
    EXPECT_SAYS(said, "must begin with package://, because this scene came as text");
  }
}

TEST_F(MeshFilesTest, OfAPackageStayInIt) {
  fs::create_directories(folder_ / "cups" / "meshes");
  std::ofstream(folder_ / "cups" / "package.xml") << "<package/>";
  fs::copy(folder_ / "scenes" / "cube.obj", folder_ / "cups" / "meshes" / "cube.obj");
  setenv("ROS_PACKAGE_PATH", folder_.c_str(), 1);
  EXPECT_EQ(sceneWith("package://cups/meshes/cube.obj").meshes[0].file,
            "package://cups/meshes/cube.obj");
  const std::string said = refusal("package://cups/../scenes/cube.obj");
  unsetenv("ROS_PACKAGE_PATH");
  EXPECT_SAYS(said, "lies outside package cups");
}

TEST_F(MeshFilesTest, WaterInsideASolidMeshIsRefused) {
  EXPECT_SAYS(refusal("cube.obj", ", position_m: [3, 0, 0]"), "inside mesh cup (meshes.0)");
}

/// Truncated and damaged files are refused or read, never more.
TEST_F(MeshFilesTest, DamagedFilesEndInAMessage) {
  test::Random random(7);
  const std::string stl = stlOf(*sceneWith("cube.obj").meshes[0].triangles);
  const std::vector<std::pair<std::string, std::string>> files{
      {"stl", stl}, {"obj", kObj}, {"ply", kPly}, {"dae", kDae}};
  for (const auto& [extension, whole] : files) {
    for (int k = 0; k < 12; ++k) {
      std::string bytes = whole;
      if (k % 2 == 0) bytes.resize(std::size_t(random.uniform(0, double(bytes.size()))));
      for (int flip = 0; flip < k % 4 && !bytes.empty(); ++flip) {
        bytes[std::size_t(random.uniform(0, double(bytes.size())))] =
            char(int(random.uniform(-128, 128)));
      }
      write("damaged." + extension, bytes);
      try {
        const Scene scene = sceneWith("damaged." + extension);
        for (const Vec3d& vertex : scene.meshes[0].triangles->vertices) {
          ASSERT_TRUE(vertex.allFinite());
        }
      } catch (const InvalidInput&) {
      }
    }
  }
}

TEST_F(MeshFilesTest, ACheckpointKnowsItsMesh) {
  const Scene scene = sceneWith("cube.obj");
  auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  simulation->advanceFrame();
  const std::string bytes = encodeCheckpoint(*simulation);
  EXPECT_EQ(decodeCheckpoint(bytes, "saved", 1)->stateHash(), simulation->stateHash());
  std::string longer = kObj;
  longer.replace(longer.find("v 0 1 1"), 7, "v 0 1 2");
  write("cube.obj", longer);
  try {
    decodeCheckpoint(bytes, "saved", 1);
    FAIL() << "taken";
  } catch (const InvalidInput& e) {
    EXPECT_SAYS(std::string(e.what()), "has changed since the checkpoint was saved");
  }
}

}  // namespace mesh_files_test
}  // namespace ice_ice_baby
