#include "metrics/error_metrics.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "frame_loop.h"
#include "ice_ice_baby/scene_loader.h"

namespace ice_ice_baby {
namespace {

constexpr char kPool[] = R"(
fluid: {spacing_m: 0.05}
blocks: [{min_m: [-0.2, -0.2, 0], max_m: [0.2, 0.2, 0.3]}]
containers: [{name: tank, size_m: [0.4, 0.4, 0.6]}]
)";

std::map<std::string, double> facesOf(const std::vector<Override>& changes, double duration_s,
                                      const char* yaml = kPool) {
  const auto simulation = makeSimulation(parseScene(yaml, changes), Precision::kFloat, 1);
  std::map<std::string, double> metrics;
  for (const ErrorMetric& metric : runFrames(*simulation, {}, duration_s, 1).metrics) {
    metrics[metric.name] = metric.value;
  }
  return metrics;
}

TEST(ErrorMetrics, AColumnThatStandsLosesNothing) {
  const auto metrics = facesOf({}, 1.0);
  EXPECT_NEAR(metrics.at("column_height_m"), 0.3, 0.01);
  EXPECT_NEAR(metrics.at("column_height_lost"), 0.0, 0.03);
  EXPECT_NEAR(metrics.at("energy_drift"), 0.0, 0.02);
  EXPECT_LT(metrics.at("energy_rise"), 0.02);
  EXPECT_LT(metrics.at("volume_lost"), 0.01);
  EXPECT_LE(metrics.at("volume_lost"), metrics.at("density_mean"));
}

TEST(ErrorMetrics, AColumnThatCannotStandSinks) {
  const auto weak = facesOf(
      {{"solver.substeps", "1"}, {"solver.relaxation", "0.05"}, {"solver.coarse_level", "false"}},
      1.0);
  EXPECT_GT(weak.at("column_height_lost"), 0.05);
  EXPECT_GT(weak.at("density_mean"), 0.01);
}

TEST(ErrorMetrics, AreThereOnlyWhereTheSceneHasThem) {
  const auto pool = facesOf({}, 0.1);
  EXPECT_EQ(pool.count("front_error"), 0u);
  EXPECT_EQ(pool.count("ice_drift_spacings"), 0u);
  const std::vector<Override> roomy{{"containers.0.size_m", "[0.42, 0.42, 0.6]"},
                                    {"containers.0.position_m", "[0, 0, -0.005]"}};
  EXPECT_EQ(facesOf(roomy, 0.05).count("column_height_m"), 1u);
  for (const std::vector<Override>& not_a_column : std::vector<std::vector<Override>>{
           {{"blocks.0.max_m", "[0, 0.2, 0.3]"}},      // a dam
           {{"blocks.0.min_m", "[-0.2, -0.2, 0.1]"}},  // falls
           {{"blocks.0.velocity_m_s", "[0, 0, 1]"}},
           {{"containers.0.rpy_deg", "[0, 1, 0]"},  // with room to tilt
            {"containers.0.size_m", "[0.42, 0.42, 0.6]"},
            {"containers.0.position_m", "[0, 0, -0.005]"}},
           {{"gravity_m_s2", "[1, 0, -9]"}},
           {{"fluid.spacing_m", "0.06"}},  // 0.4 m do not hold whole particles: it sinks aside
           {{"spheres", "[{name: ball, position_m: [0, 0, 0.5], radius_m: 0.05}]"}}}) {
    EXPECT_EQ(facesOf(not_a_column, 0.05).count("column_height_m"), 0u) << not_a_column[0].key;
  }
  EXPECT_EQ(facesOf({{"gravity_m_s2", "[0, 0, 0]"}}, 0.05).count("energy_drift"), 0u);
  EXPECT_TRUE(facesOf({}, 0.0).count("density_mean") == 0u) << "no frame, no density";
  EXPECT_NO_THROW(facesOf({{"blocks", "[]"}}, 0.05));
}

TEST(ErrorMetrics, ADamOfTheRightShapeIsComparedWithTheExperiment) {
  const std::vector<Override> dam{{"blocks.0.max_m", "[-0.1, 0.2, 0.2]"},
                                  {"blocks.0.min_m", "[-0.2, -0.2, 0]"},
                                  {"containers.0.position_m", "[0.3, 0, 0]"},
                                  {"containers.0.size_m", "[1, 0.4, 0.6]"},
                                  {"containers.0.friction", "0"}};
  const auto long_enough = facesOf(dam, 0.35);
  EXPECT_LT(long_enough.at("front_error"), 0.35);  // two particles across
  EXPECT_GT(long_enough.at("front_error"), 0.0);
  auto too_high = dam;
  too_high[0].value = "[-0.1, 0.2, 0.3]";
  EXPECT_EQ(facesOf(too_high, 0.35).count("front_error"), 0u);
}

TEST(ErrorMetrics, IceIsJudgedFromTheFrameInWhichItFroze) {
  const auto metrics = facesOf({{"temperature.initial_c", "-5"}}, 1.0);
  EXPECT_LT(metrics.at("ice_drift_spacings"), 0.05);
  EXPECT_LT(metrics.at("ice_residual_speed_m_s"), 0.05);
  EXPECT_EQ(facesOf({{"temperature.initial_c", "-5"}}, 0.2).count("ice_residual_speed_m_s"), 0u)
      << "not frozen for half a second yet";
  const std::vector<Override> never{{"schedule", "[{at_s: 0.1, celsius: 1}]"}};
  EXPECT_EQ(facesOf(never, 0.3).count("ice_drift_spacings"), 0u);
}

}  // namespace
}  // namespace ice_ice_baby
