// Freezing fronts against the closed forms of Stefan's problem: Carslaw & Jaeger 1959, chapter XI.
#include <gtest/gtest.h>

#include <cstdio>

#include "thermal/thermal_fixture.h"

namespace ice_ice_baby {
namespace stefan_test {

constexpr double kSpacing_m = 0.01;

/// Water at the freezing point on a colder plate; ice has the same constants: Ste = c dT / L.
Scene stefanColumn(double stefan, int layers, double spacing_m = kSpacing_m) {
  Scene scene = test::coldColumn(3, layers, spacing_m, -10.0);
  ThermalParams& thermal = scene.thermal;
  thermal.ice_specific_heat_j_kgk = thermal.water_specific_heat_j_kgk = 2000.0;
  thermal.ice_conductivity_w_mk = thermal.water_conductivity_w_mk = 2.0;
  thermal.latent_heat_fusion_j_kg = 2000.0 * 10.0 / stefan;
  scene.blocks[0].celsius = 0.0;
  return scene;
}

/// Volume of the ice over the cross-section of the column.
double front_m(const test::StillHeat<double>& column) {
  double ice = 0.0;
  for (std::size_t i = 0; i < column.particles.size(); ++i) ice += column.heat.iceFraction(i);
  const Vec3d size = column.scene.blocks[0].max_m - column.scene.blocks[0].min_m;
  return ice * std::pow(column.scene.fluid.spacing_m, 3) / (size.x() * size.y());
}

double diffusivity_m2_s(const Scene& scene) {
  return scene.thermal.ice_conductivity_w_mk /
         (scene.fluid.rest_density_kg_m3 * scene.thermal.ice_specific_heat_j_kgk);
}

/// Relative error of the front when the exact one is at `depth_m`: s = 2 lambda sqrt(alpha t).
double frontError(Scene scene, double lambda, double depth_m) {
  const double time_s = std::pow(depth_m / (2 * lambda), 2) / diffusivity_m2_s(scene);
  scene.thermal.speedup = time_s / 10;
  test::StillHeat<double> column(scene);
  column.run(time_s);
  EXPECT_NEAR(column.heat.reachedSpeedup() / scene.thermal.speedup, 1.0, 1e-12);
  return front_m(column) / depth_m - 1;
}

struct OnePhase {
  double stefan;
  double lambda;
};
const OnePhase kOnePhase[] = {{0.05, .156821}, {0.2, .306424}, {1, .620063}};

TEST(StefanTest, FrontFollowsStefansSolution) {
  for (const auto& [stefan, lambda] : kOnePhase) {
    for (const int layers : {5, 10, 15}) {
      const double error = frontError(stefanColumn(stefan, 20), lambda, layers * kSpacing_m);
      std::printf("Ste %.2f, %d layers: %.3f %%\n", stefan, layers, 100 * error);
      EXPECT_LT(std::abs(error), layers < 10 ? 0.02 : 0.01) << stefan;
    }
  }
}

TEST(StefanTest, RealIceOnAPlateAtMinusTen) {
  Scene scene = test::coldColumn(3, 20, 1e-3, -10.0);
  scene.fluid.rest_density_kg_m3 = 917.0;
  scene.blocks[0].celsius = 0.0;
  const double error = frontError(scene, .17343, 0.01);
  std::printf("real ice, 10 layers: %.3f %%\n", 100 * error);
  EXPECT_LT(std::abs(error), 0.01);
}

TEST(StefanTest, ErrorFallsWithTheSpacing) {
  const OnePhase one = kOnePhase[2];
  double before = 0.0;
  for (const int layers : {5, 10, 20}) {
    const double d = 0.1 / layers;
    const double error =
        std::abs(frontError(stefanColumn(one.stefan, 2 * layers, d), one.lambda, 0.1));
    if (before > 0.0) {
      std::printf("%d layers: order %.2f\n", layers, std::log2(before / error));
      EXPECT_GT(std::log2(before / error), 0.8);
    }
    before = error;
  }
}

/// A layer stays above freezing until the one below is solid, so the front halts there. It is read
/// a quarter into a layer, where it lags furthest behind.
TEST(StefanTest, WarmWaterSlowsTheFront) {
  for (const auto& [superheat, lambda] : {std::pair{0.5, .469851}, std::pair{1.0, .377760}}) {
    Scene scene = stefanColumn(1.0, 60);
    scene.blocks[0].celsius = 10.0 * superheat;
    const double error = frontError(scene, lambda, 10.25 * kSpacing_m);
    std::printf("superheat %.1f, 10 layers: %.3f %%\n", superheat, 100 * error);
    EXPECT_LT(std::abs(error), 0.02) << superheat;
  }
}

}  // namespace stefan_test
}  // namespace ice_ice_baby
