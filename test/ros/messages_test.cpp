// What goes out: layout of clouds, chunks of springs, shapes of colliders, fields of the state.
#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "ice_ice_baby/scene_loader.h"
#include "markers.h"
#include "particle_cloud.h"
#include "state_message.h"

namespace ice_ice_baby {
namespace {

using visualization_msgs::Marker;

ParticleSample sampleOf(std::uint32_t id, float ice) {
  return {0.1f, 0.2f, 0.3f, 1.1f, 1.2f, 1.3f, -4.5f, ice, 0.97f, 120.0f, id};
}

template <class Value>
Value readAt(const sensor_msgs::PointCloud2& cloud, std::size_t point, const std::string& name) {
  for (const auto& field : cloud.fields) {
    if (field.name != name) continue;
    Value value;
    std::memcpy(&value, &cloud.data[point * cloud.point_step + field.offset], sizeof(value));
    return value;
  }
  ADD_FAILURE() << "no field " << name;
  return Value();
}

TEST(Cloud, EachFieldHoldsWhatItsNameSays) {
  for (const bool rgb : {false, true}) {
    sensor_msgs::PointCloud2 cloud;
    writeCloud({sampleOf(7, 0.0f), sampleOf(9, 1.0f)}, rgb, cloud);
    ASSERT_EQ(cloud.width, 2u);
    EXPECT_EQ(cloud.height, 1u);
    EXPECT_EQ(cloud.point_step, rgb ? 48u : 44u);
    EXPECT_EQ(cloud.row_step, 2 * cloud.point_step);
    EXPECT_EQ(cloud.data.size(), cloud.row_step);
    EXPECT_TRUE(cloud.is_dense);
    EXPECT_EQ(readAt<float>(cloud, 1, "x"), 0.1f);
    EXPECT_EQ(readAt<float>(cloud, 1, "z"), 0.3f);
    EXPECT_EQ(readAt<float>(cloud, 1, "vy"), 1.2f);
    EXPECT_EQ(readAt<float>(cloud, 1, "temperature"), -4.5f);
    EXPECT_EQ(readAt<float>(cloud, 1, "ice_fraction"), 1.0f);
    EXPECT_EQ(readAt<float>(cloud, 1, "density"), 0.97f);
    EXPECT_EQ(readAt<float>(cloud, 1, "pressure"), 120.0f);
    EXPECT_EQ(readAt<std::uint32_t>(cloud, 1, "id"), 9u);
    if (!rgb) continue;
    EXPECT_EQ(readAt<std::uint32_t>(cloud, 1, "rgb"), particleColour(1.0f));
    EXPECT_EQ(readAt<std::uint32_t>(cloud, 0, "rgb"), particleColour(0.0f));
  }
}

TEST(Cloud, OfNothingIsEmptyButWhole) {
  sensor_msgs::PointCloud2 cloud;
  writeCloud({sampleOf(1, 0.0f)}, true, cloud);
  writeCloud({}, true, cloud);
  EXPECT_EQ(cloud.width, 0u);
  EXPECT_TRUE(cloud.data.empty());
  EXPECT_EQ(cloud.fields.size(), 12u);
}

TEST(Cloud, IceIsWhiterThanWater) {
  const auto red = [](float ice) { return particleColour(ice) >> 16 & 255u; };
  EXPECT_LT(red(0.0f), 64u);
  EXPECT_GT(red(0.5f), red(0.0f));
  EXPECT_GT(red(1.0f), 200u);
  EXPECT_EQ(particleColour(7.0f), particleColour(1.0f));
  EXPECT_EQ(particleColour(0.5f) >> 24, 0u);
}

TEST(SpringMarkers, AreCutIntoChunks) {
  const std::vector<SpringSample> springs(20001, SpringSample{0, 0, 0, 1, 2, 3});
  const auto array = springMarkers(springs, std_msgs::Header(), 0.01, false);
  ASSERT_EQ(array.markers.size(), 3u);
  std::size_t points = 0;
  std::set<int> ids;
  for (const Marker& marker : array.markers) {
    EXPECT_EQ(marker.type, Marker::LINE_LIST);
    EXPECT_EQ(marker.action, Marker::ADD);
    EXPECT_LE(marker.points.size(), kMaxMarkerPoints);
    EXPECT_EQ(marker.points.size() % 2, 0u);
    EXPECT_EQ(marker.pose.orientation.w, 1.0);
    points += marker.points.size();
    ids.insert(marker.id);
  }
  EXPECT_EQ(points, 2 * springs.size());
  EXPECT_EQ(ids.size(), 3u);
  EXPECT_EQ(array.markers[0].points[1].z, 3.0);
}

TEST(SpringMarkers, ClearDeletesWhatWasDrawn) {
  const auto array = springMarkers({}, std_msgs::Header(), 0.01, true);
  ASSERT_EQ(array.markers.size(), 1u);
  EXPECT_EQ(array.markers[0].action, Marker::DELETEALL);
}

TEST(ColliderMarkers, DrawEachVisibleCollider) {
  const auto simulation = makeSimulation(parseScene(R"(
    containers: [{name: closed, open_top: false}, {name: open, position_m: [3, 0, 0]}]
    planes: [{name: ground, position_m: [0, 0, -1], opacity: 0.5}]
    spheres: [{name: ball, radius_m: 0.25, position_m: [0, 0, 5]}, {name: ghost, opacity: 0,
               position_m: [0, 9, 5]}])"));
  std_msgs::Header header;
  header.frame_id = "scene";
  const auto array = colliderMarkers(*simulation, header);
  std::multiset<std::string> names;
  EXPECT_EQ(array.markers.at(0).action, Marker::DELETEALL);
  for (std::size_t k = 1; k < array.markers.size(); ++k) {
    const Marker& marker = array.markers[k];
    names.insert(marker.ns);
    EXPECT_EQ(marker.header.frame_id, "scene");
    EXPECT_NEAR(marker.pose.orientation.w, 1.0, 1e-12);
    EXPECT_GT(marker.scale.x, 0.0);
    if (marker.ns != "ball") continue;
    EXPECT_EQ(marker.type, Marker::SPHERE);
    EXPECT_NEAR(marker.scale.z, 0.5, 1e-12);
    EXPECT_NEAR(marker.pose.position.z, 5.0, 1e-12);
    EXPECT_NEAR(marker.color.a, 0.2, 1e-6);
  }
  EXPECT_EQ(names.count("closed"), 7u);  // floor, walls, lid, edges
  EXPECT_EQ(names.count("open"), 6u);
  EXPECT_EQ(names.count("ground"), 1u);
  EXPECT_EQ(names.count("ghost"), 0u);
}

TEST(StateMessage, CarriesTheReport) {
  Snapshot snapshot;
  snapshot.report.frame = 12;
  snapshot.report.particles = 345;
  snapshot.report.springs = 6;
  snapshot.report.temperature_c = -3.5;
  snapshot.report.strictness = 1.0;
  snapshot.stages = {{"lambda", 4, 0.5, 678}};
  snapshot.scene = "pond";
  snapshot.preset = Preset::kPaper;
  snapshot.precision = Precision::kDouble;
  snapshot.gravity_m_s2 = {0, 0, -2};
  snapshot.paused = true;
  const State state = stateMessage(snapshot, std_msgs::Header());
  EXPECT_EQ(state.frame, 12u);
  EXPECT_EQ(state.particles, 345u);
  EXPECT_EQ(state.springs, 6u);
  EXPECT_EQ(state.temperature, -3.5);
  EXPECT_EQ(state.strictness, 1.0);
  EXPECT_EQ(state.scene, "pond");
  EXPECT_EQ(state.preset, "paper");
  EXPECT_EQ(state.precision, "double");
  EXPECT_EQ(state.gravity.z, -2.0);
  EXPECT_TRUE(state.paused);
  ASSERT_EQ(state.stages.size(), 1u);
  EXPECT_EQ(state.stages[0].name, "lambda");
  EXPECT_EQ(state.stages[0].bytes, 678u);
}

}  // namespace
}  // namespace ice_ice_baby
