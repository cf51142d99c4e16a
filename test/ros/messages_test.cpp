// Messages: layout of clouds, chunks of springs, shapes of colliders, fields of the state.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "heat_status.h"
#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/scene_loader.h"
#include "markers.h"
#include "particle_cloud.h"
#include "particle_colour.h"
#include "state_message.h"
#include "vessels_message.h"

namespace ice_ice_baby {
namespace {

using visualization_msgs::Marker;

ParticleSample sampleOf(std::uint32_t id, float ice) {
  const Phase phase = ice < 1.0f ? Phase::kWater : Phase::kIce;
  return {0.1f, 0.2f, 0.3f, 1.1f, 1.2f, 1.3f, -4.5f, ice, 0.97f, 120.0f, id, phase};
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
  for (const Colouring colouring : {Colouring::kPlain, Colouring::kScene, Colouring::kHeat}) {
    const bool rgb = colouring != Colouring::kPlain;
    sensor_msgs::PointCloud2 cloud;
    ParticleSample slush = sampleOf(3, 0.6f), steam = sampleOf(4, 0.0f);
    steam.phase = Phase::kSteam;
    writeCloud({sampleOf(7, 0.0f), sampleOf(9, 1.0f), slush, steam}, colouring, cloud);
    ASSERT_EQ(cloud.width, 4u);
    EXPECT_EQ(cloud.height, 1u);
    EXPECT_EQ(cloud.point_step, rgb ? 52u : 48u);
    EXPECT_EQ(cloud.row_step, 4 * cloud.point_step);
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
    for (const auto& [point, phase] : {std::pair(0, Phase::kWater), std::pair(1, Phase::kIce),
                                       std::pair(2, Phase::kWater), std::pair(3, Phase::kSteam)}) {
      EXPECT_EQ(readAt<Phase>(cloud, std::size_t(point), "phase"), phase) << point;
    }
    if (!rgb) continue;
    const bool heat = colouring == Colouring::kHeat;
    const ParticleSample water = sampleOf(7, 0.0f);
    EXPECT_EQ(readAt<std::uint32_t>(cloud, 1, "rgb"), particleColour(1.0f));
    EXPECT_EQ(readAt<std::uint32_t>(cloud, 0, "rgb"),
              heat ? heatColour(water) : particleColour(0.0f));
  }
}

TEST(Cloud, OfNothingIsEmptyButWhole) {
  sensor_msgs::PointCloud2 cloud;
  writeCloud({sampleOf(1, 0.0f)}, Colouring::kScene, cloud);
  writeCloud({}, Colouring::kScene, cloud);
  EXPECT_EQ(cloud.width, 0u);
  EXPECT_TRUE(cloud.data.empty());
  EXPECT_EQ(cloud.fields.size(), 13u);
}

TEST(Cloud, IceIsWhiterThanWater) {
  const auto red = [](float ice) { return particleColour(ice) >> 16 & 255u; };
  EXPECT_LT(red(0.0f), 64u);
  EXPECT_GT(red(0.5f), red(0.0f));
  EXPECT_GT(red(1.0f), 200u);
  EXPECT_EQ(particleColour(7.0f), particleColour(1.0f));
  EXPECT_EQ(particleColour(0.5f) >> 24, 0u);
}

/// Red, green and blue of water, ice or steam in a scene with heat.
std::array<int, 3> heatParts(float celsius, float ice, Phase phase) {
  ParticleSample sample = sampleOf(1, ice);
  sample.temperature_c = celsius;
  sample.phase = phase;
  const std::uint32_t colour = heatColour(sample);
  EXPECT_EQ(colour >> 24, 0u);
  return {int(colour >> 16 & 255u), int(colour >> 8 & 255u), int(colour & 255u)};
}

TEST(Cloud, WithHeatWaterGoesFromDeepBlueToRed) {
  const auto [cold_red, cold_green, cold_blue] = heatParts(0.0f, 0.0f, Phase::kWater);
  const auto [hot_red, hot_green, hot_blue] = heatParts(100.0f, 0.0f, Phase::kWater);
  EXPECT_GT(cold_blue, 2 * cold_red);
  EXPECT_GT(hot_red, 2 * hot_blue);
  int before = cold_red;
  for (float celsius = 5.0f; celsius <= 100.0f; celsius += 5.0f) {
    const int red = heatParts(celsius, 0.0f, Phase::kWater)[0];
    EXPECT_GT(red, before) << celsius;
    before = red;
  }
  EXPECT_EQ(heatParts(-40.0f, 0.0f, Phase::kWater), heatParts(0.0f, 0.0f, Phase::kWater));
  EXPECT_EQ(heatParts(900.0f, 0.0f, Phase::kWater), heatParts(100.0f, 0.0f, Phase::kWater));
  ParticleSample lukewarm = sampleOf(1, 0.0f);
  lukewarm.temperature_c = 20.0f;
  EXPECT_EQ(heatColour(lukewarm), particleColour(0.0f));  // the usual blue
}

TEST(Cloud, WithHeatIceIsWhiteAndSteamGrey) {
  const auto ice = heatParts(-10.0f, 1.0f, Phase::kIce);
  const auto slush = heatParts(0.0f, 0.5f, Phase::kWater);
  const auto steam = heatParts(100.0f, 0.0f, Phase::kSteam);
  EXPECT_GT(*std::min_element(ice.begin(), ice.end()), 200);
  EXPECT_GT(ice[0], slush[0]);
  EXPECT_GT(slush[0], heatParts(0.0f, 0.0f, Phase::kWater)[0]);
  EXPECT_GT(*std::min_element(steam.begin(), steam.end()), 200);
  EXPECT_LT(steam[2] - steam[0], 16);
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

Eigen::AlignedBox3d boundsOf(const Marker& marker) {
  Eigen::AlignedBox3d bounds;
  for (const auto& p : marker.points) bounds.extend(Vec3d(p.x, p.y, p.z));
  return bounds;
}

void expectBounds(const Marker& marker, int type, const Vec3d& low, const Vec3d& high) {
  EXPECT_EQ(marker.type, type) << marker.ns;
  EXPECT_EQ(marker.points.size() % (type == Marker::LINE_LIST ? 2 : 3), 0u) << marker.ns;
  EXPECT_LT((boundsOf(marker).min() - low).norm(), 1e-12) << marker.ns;
  EXPECT_LT((boundsOf(marker).max() - high).norm(), 1e-12) << marker.ns;
}

TEST(ColliderMarkers, DrawEachVisibleCollider) {
  const auto simulation = makeSimulation(parseScene(R"(
    containers: [{name: closed, open_top: false}, {name: open, position_m: [3, 0, 0]}]
    planes: [{name: ground, position_m: [0, 0, -1], opacity: 0.5}]
    spheres: [{name: ball, radius_m: 0.25, position_m: [0, 0, 5]}, {name: ghost, opacity: 0,
               position_m: [0, 9, 5]}])"));
  std_msgs::Header header;
  header.frame_id = "scene";
  std::vector<Posed> poses;
  forEachCollider(simulation->scene(), [&](const Collider& collider) {
    poses.push_back(simulation->colliderPose(collider.name));
  });
  const auto array = colliderMarkers(simulation->scene(), poses, header);
  std::map<std::string, std::vector<Marker>> drawn;
  EXPECT_EQ(array.markers.at(0).action, Marker::DELETEALL);
  for (std::size_t k = 1; k < array.markers.size(); ++k) {
    const Marker& marker = array.markers[k];
    EXPECT_EQ(marker.id, int(drawn[marker.ns].size()));
    drawn[marker.ns].push_back(marker);
    EXPECT_EQ(marker.header.frame_id, "scene");
    EXPECT_NEAR(marker.pose.orientation.w, 1.0, 1e-12);
    EXPECT_GT(marker.scale.x, 0.0);
  }
  EXPECT_EQ(drawn.size(), 4u);
  const double half = 0.5, wall = 0.02, out = half + wall;
  for (const char* name : {"closed", "open"}) {
    ASSERT_EQ(drawn[name].size(), 2u) << name;  // surface and edges
    const double top = drawn[name][0].ns == "open" ? 1.0 : 1.0 + wall;
    expectBounds(drawn[name][0], Marker::TRIANGLE_LIST, {-out, -out, -wall}, {out, out, top});
    expectBounds(drawn[name][1], Marker::LINE_LIST, {-half, -half, 0}, {half, half, 1});
    EXPECT_EQ(drawn[name][1].points.size(), 24u);
    EXPECT_EQ(drawn[name][0].scale.x, 1.0);  // of what the points are measured in
    EXPECT_NEAR(drawn[name][0].color.a, 0.2, 1e-6);
    EXPECT_NEAR(drawn[name][1].color.a, 0.4, 1e-6);
  }
  EXPECT_EQ(drawn["open"][0].pose.position.x, 3.0);
  EXPECT_EQ(drawn["closed"][0].points.size(), 72u);  // outside and inside of six sides
  EXPECT_EQ(drawn["open"][0].points.size(), 84u);    // of five, and the rim
  ASSERT_EQ(drawn["ground"].size(), 1u);
  expectBounds(drawn["ground"][0], Marker::TRIANGLE_LIST, {-10, -10, -0.01}, {10, 10, 0});
  ASSERT_EQ(drawn["ball"].size(), 1u);
  EXPECT_EQ(drawn["ball"][0].type, Marker::SPHERE);
  EXPECT_NEAR(drawn["ball"][0].scale.x, 0.5, 1e-12);
  EXPECT_NEAR(drawn["ball"][0].scale.z, 0.5, 1e-12);
  EXPECT_NEAR(drawn["ball"][0].pose.position.z, 5.0, 1e-12);
  EXPECT_NEAR(drawn["ball"][0].color.a, 0.2, 1e-6);
}

TEST(StateMessage, CarriesTheReport) {
  Snapshot snapshot;
  snapshot.report.frame = 12;
  snapshot.report.particles = 345;
  snapshot.report.springs = 6;
  snapshot.report.temperature_c = -3.5;
  snapshot.report.strictness = 1.0;
  snapshot.report.asleep = true;
  snapshot.report.max_speed_m_s = 2.5;
  snapshot.report.non_finite = 8;
  snapshot.report.substeps = 6;
  snapshot.report.frame_wall_s = 0.01;
  snapshot.stages = {{"lambda", 4, 0.5, 678}};
  snapshot.scene = "pond";
  snapshot.preset = Preset::kPaper;
  snapshot.precision = Precision::kDouble;
  snapshot.gravity_m_s2 = {0, 0, -2};
  snapshot.spacing_m = 0.015;
  snapshot.view = Eigen::AlignedBox3d(Vec3d(-1, -2, 0), Vec3d(1, 2, 3));
  snapshot.paused = true;
  const State state = stateMessage(snapshot, std_msgs::Header());
  EXPECT_EQ(state.frame, 12u);
  EXPECT_EQ(state.particles, 345u);
  EXPECT_EQ(state.springs, 6u);
  EXPECT_EQ(state.temperature, -3.5);
  EXPECT_EQ(state.strictness, 1.0);
  EXPECT_TRUE(state.asleep);
  EXPECT_EQ(state.max_speed_m_s, 2.5);
  EXPECT_EQ(state.non_finite, 8u);
  EXPECT_EQ(state.substeps, 6u);
  EXPECT_EQ(state.frame_wall_s, 0.01);
  EXPECT_EQ(state.scene, "pond");
  EXPECT_EQ(state.preset, "paper");
  EXPECT_EQ(state.precision, "double");
  EXPECT_EQ(state.gravity.z, -2.0);
  EXPECT_EQ(state.spacing_m, 0.015);
  EXPECT_EQ(state.view_low.y, -2.0);
  EXPECT_EQ(state.view_high.z, 3.0);
  EXPECT_TRUE(state.paused);
  ASSERT_EQ(state.stages.size(), 1u);
  EXPECT_EQ(state.stages[0].name, "lambda");
  EXPECT_EQ(state.stages[0].bytes, 678u);
}

/// Comment of each field of a message.
std::map<std::string, std::string> fieldComments(const std::string& message) {
  std::ifstream file(IIB_MESSAGES + message);
  std::map<std::string, std::string> comments;
  for (std::string line; std::getline(file, line);) {
    const std::size_t hash = line.find('#');
    std::istringstream words(line.substr(0, hash));
    std::string type, field;
    if (!(words >> type >> field)) continue;
    comments[field] = hash == std::string::npos ? "" : line.substr(hash + 2);
  }
  return comments;
}

TEST(StateMessage, DescribesEveryReportedNumberAsTheReportDoes) {
  const auto comments = fieldComments("State.msg");
  const std::map<std::string, std::string> renamed = {{"temperature_c", "temperature"},
                                                      {"mean_celsius", "mean_temperature"}};
  describe(StepReport(), [&](const char* name, const auto&, const std::string& meaning) {
    const std::string field = renamed.count(name) > 0 ? renamed.at(name) : name;
    ASSERT_EQ(comments.count(field), 1u) << "add " << field << " to msg/State.msg: " << meaning;
    EXPECT_EQ(comments.at(field), meaning) << field << " in msg/State.msg";
  });
}

TEST(VesselsMessage, DescribesEveryNumberAsTheReportDoes) {
  const auto comments = fieldComments("Vessel.msg");
  const VesselReport report;
  describeVessel(
      [&](const char* name, const auto&, const std::string& meaning) {
        ASSERT_EQ(comments.count(name), 1u) << "add " << name << " to msg/Vessel.msg: " << meaning;
        EXPECT_EQ(comments.at(name), meaning) << name << " in msg/Vessel.msg";
      },
      report);
}

TEST(VesselsMessage, HoldsEveryVesselInOrder) {
  VesselReport tank, cup;
  tank.name = "tank";
  tank.particles = 7;
  tank.water_m3 = 0.5;
  tank.left_m3 = 0.25;
  cup.name = "cup";
  cup.level_m = 0.125;
  std_msgs::Header header;
  header.frame_id = "scene";
  const Vessels message = vesselsMessage({tank, cup}, header);
  EXPECT_EQ(message.header.frame_id, "scene");
  ASSERT_EQ(message.vessels.size(), 2u);
  EXPECT_EQ(message.vessels[0].name, "tank");
  EXPECT_EQ(message.vessels[0].particles, 7u);
  EXPECT_EQ(message.vessels[0].water_m3, 0.5);
  EXPECT_EQ(message.vessels[0].left_m3, 0.25);
  EXPECT_EQ(message.vessels[1].name, "cup");
  EXPECT_EQ(message.vessels[1].level_m, 0.125);
  EXPECT_TRUE(std::isnan(message.vessels[1].mean_celsius));
}

/// Snapshot of a freezing pond.
Snapshot freezingPond() {
  Snapshot snapshot;
  snapshot.thermal = true;
  snapshot.thermal_speedup_wanted = 100.0;
  snapshot.colliders = {"floor", "lid"};
  snapshot.report.frame = 5;
  snapshot.report.strictness = 0.25;
  snapshot.report.mean_celsius = 1.5;
  snapshot.report.enthalpy_j = 4e6;
  snapshot.report.thermal_speedup = 100.0;
  snapshot.report.ice_bodies = 3;
  snapshot.report.ice_bodies_asleep = 2;
  snapshot.report.ice_particles = 40;
  snapshot.report.steam_particles = 7;
  return snapshot;
}

TEST(StateMessage, TellsOfHeat) {
  const State state = stateMessage(freezingPond(), std_msgs::Header());
  EXPECT_TRUE(state.thermal);
  EXPECT_EQ(state.targets, (std::vector<std::string>{"floor", "lid"}));
  EXPECT_EQ(state.mean_temperature, 1.5);
  EXPECT_EQ(state.enthalpy_j, 4e6);
  EXPECT_EQ(state.thermal_speedup, 100.0);
  EXPECT_EQ(state.ice_bodies, 3u);
  EXPECT_EQ(state.ice_bodies_asleep, 2u);
  EXPECT_EQ(state.ice_particles, 40u);
  EXPECT_EQ(state.steam_particles, 7u);
}

TEST(StateMessage, HasNoTargetsWithoutHeat) {
  Snapshot snapshot = freezingPond();
  snapshot.thermal = false;
  const State state = stateMessage(snapshot, std_msgs::Header());
  EXPECT_FALSE(state.thermal);
  EXPECT_TRUE(state.targets.empty());
}

using Status = diagnostic_updater::DiagnosticStatusWrapper;

TEST(HeatStatus, SaysNothingWithoutHeat) {
  Status status;
  Snapshot snapshot = freezingPond();
  snapshot.thermal = false;
  snapshot.report.thermal_speedup = 0.0;
  addHeat(status, snapshot);
  EXPECT_TRUE(status.values.empty());
  EXPECT_EQ(status.level, Status::OK);
}

TEST(HeatStatus, WarnsWhereHeatIsSlowerThanAsked) {
  Status status;
  Snapshot snapshot = freezingPond();
  addHeat(status, snapshot);
  EXPECT_EQ(status.level, Status::OK);
  ASSERT_EQ(status.values.size(), 1u);
  EXPECT_EQ(status.values[0].key, "thermal_speedup_wanted");
  snapshot.report.thermal_speedup = 40.0;
  addHeat(status, snapshot);
  EXPECT_EQ(status.level, Status::WARN);
  EXPECT_NE(status.message.find("40"), std::string::npos) << status.message;
  EXPECT_NE(status.message.find("thermal.speedup"), std::string::npos) << status.message;
}

TEST(HeatStatus, DoesNotWarnBeforeTheFirstFrameOrAsleep) {
  for (const bool asleep : {false, true}) {
    Status status;
    Snapshot snapshot = freezingPond();
    snapshot.report.thermal_speedup = 0.0;
    snapshot.report.frame = asleep ? 9 : 0;
    snapshot.report.asleep = asleep;
    addHeat(status, snapshot);
    EXPECT_EQ(status.level, Status::OK) << status.message;
  }
}

}  // namespace
}  // namespace ice_ice_baby
