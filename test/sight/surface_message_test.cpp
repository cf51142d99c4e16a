// From a cloud of particles to the messages of their surface.
#include "surface_message.h"

#include <gtest/gtest.h>

#include "cloud_samples.h"
#include "ice_ice_baby/errors.h"
#include "particle_cloud.h"
#include "particle_colour.h"

namespace ice_ice_baby {
namespace {

constexpr float kSpacing_m = 0.02f;

/// A cube of `side` particles along each edge whose lowest corner is at `x_m`.
void addCube(std::vector<ParticleSample>& particles, int side, float x_m, Phase phase,
             float celsius) {
  for (int k = 0; k < side * side * side; ++k) {
    ParticleSample p{};
    p.x = x_m + kSpacing_m * float(k % side);
    p.y = kSpacing_m * float(k / side % side);
    p.z = kSpacing_m * float(k / side / side);
    p.vz = -1.5f;
    p.temperature_c = celsius;
    p.ice_fraction = phase == Phase::kIce ? 1.0f : 0.0f;
    p.id = std::uint32_t(particles.size());
    p.phase = phase;
    particles.push_back(p);
  }
}

/// Warm water, ice beside it, one particle of steam and one of a solid.
std::vector<ParticleSample> someOfEach() {
  std::vector<ParticleSample> particles;
  addCube(particles, 8, 0.0f, Phase::kWater, 80.0f);
  addCube(particles, 6, 1.0f, Phase::kIce, -5.0f);
  addCube(particles, 1, 2.0f, Phase::kSteam, 100.0f);
  addCube(particles, 1, 3.0f, Phase::kSolid, 20.0f);
  return particles;
}

TEST(CloudSamples, AreThoseThatWereWritten) {
  const std::vector<ParticleSample> particles = someOfEach();
  for (const Colouring colouring : {Colouring::kPlain, Colouring::kHeat}) {
    sensor_msgs::PointCloud2 cloud;
    writeCloud(particles, colouring, cloud);
    const std::vector<ParticleSample> read = readSamples(cloud);
    ASSERT_EQ(read.size(), particles.size());
    for (std::size_t k = 0; k < read.size(); ++k) {
      EXPECT_EQ(read[k].x, particles[k].x);
      EXPECT_EQ(read[k].z, particles[k].z);
      EXPECT_EQ(read[k].vz, particles[k].vz);
      EXPECT_EQ(read[k].temperature_c, particles[k].temperature_c);
      EXPECT_EQ(read[k].ice_fraction, particles[k].ice_fraction);
      EXPECT_EQ(read[k].phase, particles[k].phase);
    }
  }
}

TEST(CloudSamples, RefuseOtherClouds) {
  sensor_msgs::PointCloud2 cloud;
  EXPECT_THROW(readSamples(cloud), InvalidInput);  // no fields
  writeCloud(someOfEach(), Colouring::kPlain, cloud);
  sensor_msgs::PointCloud2 cut = cloud;
  cut.data.pop_back();
  EXPECT_THROW(readSamples(cut), InvalidInput);
  sensor_msgs::PointCloud2 unknown = cloud;
  unknown.data[offsetof(ParticleSample, phase)] = 9;
  EXPECT_THROW(readSamples(unknown), InvalidInput);
  sensor_msgs::PointCloud2 narrow = cloud;
  narrow.point_step = 16;
  EXPECT_THROW(readSamples(narrow), InvalidInput);
}

class SurfaceMessageTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!makesSurfaces()) GTEST_SKIP() << "built without OpenVDB";
    surface_ = surfaceMessage(someOfEach(), kSpacing_m);
  }

  Surface surface_;
};

TEST_F(SurfaceMessageTest, HoldsEachPhaseApart) {
  const auto widthOf = [](const SurfaceMesh& mesh) {
    float low = 1e9f, high = -1e9f;
    for (const auto& v : mesh.vertices) low = std::min(low, v.x), high = std::max(high, v.x);
    return std::pair(low, high);
  };
  const float half = kSpacing_m / 2;
  EXPECT_NEAR(widthOf(surface_.water).first, -half, 0.5f * kSpacing_m);
  EXPECT_NEAR(widthOf(surface_.water).second, 7 * kSpacing_m + half, 0.5f * kSpacing_m);
  EXPECT_NEAR(widthOf(surface_.ice).first, 1 - half, 0.5f * kSpacing_m);
  ASSERT_EQ(surface_.steam.size(), 1u);
  EXPECT_EQ(surface_.steam[0].x, 2.0f);
  EXPECT_EQ(surface_.spacing_m, kSpacing_m);
}

TEST_F(SurfaceMessageTest, HasTheValuesOfTheParticles) {
  const SurfaceMesh& water = surface_.water;
  ASSERT_FALSE(water.vertices.empty());
  ASSERT_EQ(water.velocities.size(), water.vertices.size());
  ASSERT_EQ(water.temperatures.size(), water.vertices.size());
  for (std::size_t v = 0; v < water.vertices.size(); ++v) {
    EXPECT_NEAR(water.velocities[v].z, -1.5f, 1e-4f);
    EXPECT_NEAR(water.temperatures[v], 80.0f, 1e-3f);
    EXPECT_EQ(water.ice_fractions[v], 0.0f);
  }
  for (const Triangle& t : water.triangles) {
    for (const std::uint32_t v : t.vertices) ASSERT_LT(v, water.vertices.size());
  }
}

TEST_F(SurfaceMessageTest, MarkersAreColouredByTemperatureOnlyWithHeat) {
  const auto redOfWater = [this] {
    for (const auto& marker : surfaceMarkers(surface_).markers) {
      if (marker.ns == "water") return marker.colors.at(0).r;
    }
    return -1.0f;
  };
  const auto red = [](std::uint32_t packed) { return float(packed >> 16 & 255u) / 255; };
  EXPECT_NEAR(redOfWater(), red(particleColour(0.0f)), 1e-6f);
  surface_.thermal = true;
  ParticleSample warm{};
  warm.temperature_c = 80.0f;
  EXPECT_NEAR(redOfWater(), red(heatColour(warm)), 0.01f);
}

TEST_F(SurfaceMessageTest, OfNothingIsEmptyAndDeletesItsMarkers) {
  const Surface nothing = surfaceMessage({}, kSpacing_m);
  EXPECT_TRUE(nothing.water.triangles.empty() && nothing.ice.triangles.empty());
  for (const auto& marker : surfaceMarkers(nothing).markers) {
    EXPECT_EQ(marker.action, visualization_msgs::Marker::DELETE);
  }
}

}  // namespace
}  // namespace ice_ice_baby
