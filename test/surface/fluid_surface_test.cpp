// Surfaces against the shapes of the water that they enclose.
#include "fluid_surface.h"

#include <tbb/task_arena.h>

#include "closed_surfaces.h"
#include "ice_ice_baby/scene_loader.h"
#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {
namespace fluid_surface_test {

using FluidSurfaceTest = test::SurfaceCase;

constexpr double kSpacing_m = 0.02;
constexpr double kParticle_m3 = kSpacing_m * kSpacing_m * kSpacing_m;

FluidSurface waterOf(const std::vector<ParticleSample>& particles) {
  return surfaceOf(particles, Phase::kWater, kSpacing_m);
}

TEST_F(FluidSurfaceTest, ASphereIsRoundAndAsLargeAsItsWater) {
  for (const double radius_d : {6.0, 12.0, 24.0}) {
    const double radius = radius_d * kSpacing_m;
    const auto particles = test::waterWhere(kSpacing_m, radius, [&](const Vec3d& x) {
      return (x - Vec3d(0.003, 0.001, -0.002)).norm() < radius;
    });
    const FluidSurface surface = waterOf(particles);
    EXPECT_TRUE(test::isClosed(surface));
    const double water = double(particles.size()) * kParticle_m3;
    EXPECT_NEAR(surface.volume_m3() / water, 1.0, 0.03) << radius_d;
    const double round = std::cbrt(36 * M_PI * water * water);
    EXPECT_NEAR(surface.area_m2() / round, 1.0, 0.02) << radius_d;
    for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
      const Vec3<float> away = surface.vertices[v].normalized();
      ASSERT_GT(surface.normals[v].dot(away), 0.8f) << "outwards";
    }
  }
}

/// Water that came to rest, not a lattice.
TEST_F(FluidSurfaceTest, APoolIsFlatSteadyAndAsLargeAsItsWater) {
  const Scene scene = parseScene(R"(
fluid: {spacing_m: 0.02}
blocks: [{min_m: [-0.2, -0.14, 0], max_m: [0.2, 0.14, 0.2]}]
containers: [{name: tank, size_m: [0.4, 0.28, 0.3], friction: 0}]
)");
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  for (int frame = 0; frame < 150; ++frame) simulation->advanceFrame();
  std::vector<ParticleSample> particles;
  simulation->sample(particles);
  const FluidSurface surface = waterOf(particles);
  EXPECT_TRUE(test::isClosed(surface));
  EXPECT_NEAR(surface.volume_m3() / (double(particles.size()) * kParticle_m3), 1.0, 0.03);
  Eigen::AlignedBox<float, 1> heights;
  for (const Vec3<float>& x : surface.vertices) {
    if (x.z() > 0.15f && x.head<2>().cwiseAbs().maxCoeff() < 0.1f) {
      heights.extend(Eigen::Matrix<float, 1, 1>(x.z()));
    }
  }
  EXPECT_LT(heights.sizes()[0], 0.1 * kSpacing_m);
  EXPECT_GT(heights.min()[0], 0.19f);
  simulation->advanceFrame();
  simulation->sample(particles);
  const FluidSurface next = waterOf(particles);
  ASSERT_EQ(next.vertices.size(), surface.vertices.size());
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    ASSERT_LT((next.vertices[v] - surface.vertices[v]).norm(), 0.02 * kSpacing_m);
  }
}

TEST_F(FluidSurfaceTest, DropsAndThinSheetsAreKept) {
  for (const auto& shift : {Vec3d(0, 0, 0), Vec3d(0.3, 0.2, 0.45), Vec3d(-0.5, 0.5, 0.1)}) {
    const Vec3d x = shift * kSpacing_m;
    ParticleSample drop{};
    drop.x = float(x.x());
    drop.y = float(x.y());
    drop.z = float(x.z());
    const FluidSurface one = waterOf({drop});
    EXPECT_TRUE(test::isClosed(one));
    EXPECT_GT(one.volume_m3(), 0.5 * kParticle_m3);
    EXPECT_LT(one.volume_m3(), 1.5 * kParticle_m3);
  }
  const auto sheet = test::waterWhere(kSpacing_m, 0.2, [](const Vec3d& x) {
    return std::abs(x.z() - 0.5 * kSpacing_m) < 0.1 * kSpacing_m;
  });
  const FluidSurface surface = waterOf(sheet);
  EXPECT_TRUE(test::isClosed(surface));
  Eigen::AlignedBox3f box;
  for (const Vec3<float>& vertex : surface.vertices) box.extend(vertex);
  EXPECT_GT(box.sizes().x(), 0.39f) << "without holes at the edges";
  EXPECT_NEAR(surface.volume_m3() / (double(sheet.size()) * kParticle_m3), 1.2, 0.25);
}

TEST_F(FluidSurfaceTest, OnlyThePhaseAskedForIsInIt) {
  auto particles = test::waterWhere(kSpacing_m, 0.1, [](const Vec3d&) { return true; });
  for (ParticleSample& p : particles) p.phase = p.x > 0 ? Phase::kIce : Phase::kWater;
  const FluidSurface water = waterOf(particles);
  const FluidSurface ice = surfaceOf(particles, Phase::kIce, kSpacing_m);
  for (const Vec3<float>& x : water.vertices) ASSERT_LT(x.x(), 0.2 * kSpacing_m);
  for (const Vec3<float>& x : ice.vertices) ASSERT_GT(x.x(), -0.2 * kSpacing_m);
  EXPECT_TRUE(surfaceOf(particles, Phase::kSteam, kSpacing_m).triangles.empty());
  EXPECT_TRUE(waterOf({}).vertices.empty());
}

TEST_F(FluidSurfaceTest, ValuesAreThoseOfTheParticlesBesideIt) {
  auto particles = test::waterWhere(kSpacing_m, 0.2, [](const Vec3d&) { return true; });
  for (ParticleSample& p : particles) {
    p.temperature_c = 100 * p.x;
    p.vx = p.y;
    p.ice_fraction = 0.25f;
  }
  const FluidSurface surface = waterOf(particles);
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    const Vec3<float>& x = surface.vertices[v];
    ASSERT_NEAR(surface.temperatures_c[v], 100 * x.x(), 100 * kSpacing_m);
    ASSERT_NEAR(surface.velocities[v].x(), x.y(), kSpacing_m);
    ASSERT_NEAR(surface.ice_fractions[v], 0.25, 1e-5);
  }
}

/// Spray far from the water costs blocks of its own, not the space between.
TEST_F(FluidSurfaceTest, TakesParticlesKilometresApart) {
  auto particles = test::waterWhere(kSpacing_m, 0.05, [](const Vec3d&) { return true; });
  const std::size_t near = waterOf(particles).vertices.size();
  for (const float x : {-100.0f, 100.0f}) {
    ParticleSample drop{};
    drop.x = drop.y = drop.z = x;
    particles.push_back(drop);
  }
  const FluidSurface surface = waterOf(particles);
  EXPECT_TRUE(test::isClosed(surface));
  EXPECT_GT(surface.vertices.size(), near);
  EXPECT_LT(surface.vertices.size(), near + 200);
}

TEST_F(FluidSurfaceTest, IsTheSameForAnyNumberOfThreads) {
  const auto particles =
      test::waterWhere(kSpacing_m, 0.2, [](const Vec3d& x) { return x.norm() < 0.2; });
  const auto on = [&](int threads) {
    FluidSurface surface;
    tbb::task_arena(threads).execute([&] { surface = waterOf(particles); });
    return surface;
  };
  const FluidSurface one = on(1), four = on(4);
  EXPECT_EQ(one.vertices, four.vertices);
  EXPECT_EQ(one.triangles, four.triangles);
  EXPECT_EQ(one.velocities, four.velocities);
}

}  // namespace fluid_surface_test
}  // namespace ice_ice_baby
