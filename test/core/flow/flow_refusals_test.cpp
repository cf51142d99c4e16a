// Sources and drains that are refused, with a message that names them.
#include <gtest/gtest.h>

#include "flow/flow_fixtures.h"
#include "ice_ice_baby/scene_loader.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {
namespace flow_refusals_test {

std::string refusal(const std::string& yaml) {
  return test::refusalOf([&] { parseScene("fluid: {spacing_m: 0.01}\n" + yaml); });
}

std::string ofSource(const std::string& keys, const std::string& more = "") {
  return refusal("sources: [{name: tap, " + keys + "}]\n" + more);
}

TEST(FlowRefusals, NameTheSourceTheValueAndTheCure) {
  EXPECT_EQ(ofSource("speed_m_s: 1"), "");
  EXPECT_EQ(ofSource("flow_l_min: 10"), "");
  EXPECT_EQ(ofSource("radius_m: 0.02"),
            "scene: sources.0 (tap): speed_m_s = 0 and flow_l_min = 0; set exactly one of them "
            "above 0, the other follows from radius_m");
  EXPECT_NE(ofSource("speed_m_s: 1, flow_l_min: 2").find("speed_m_s = 1 and flow_l_min = 2; set"),
            std::string::npos);
  EXPECT_NE(ofSource("speed_m_s: 31")
                .find("sources.0 (tap): the water would leave with 31 m/s, above "
                      "solver.max_speed_m_s = 30; lower speed_m_s"),
            std::string::npos);
  EXPECT_NE(ofSource("flow_l_min: 1e6").find("m/s, above solver.max_speed_m_s"), std::string::npos);
  EXPECT_NE(ofSource("speed_m_s: -1").find("sources.0.speed_m_s = -1 is outside"),
            std::string::npos);
  EXPECT_NE(ofSource("speed_m_s: 1, direction: [0, 0, 0]").find("(tap): direction = [0, 0, 0]"),
            std::string::npos);
  EXPECT_NE(ofSource("speed_m_s: 1, radius_m: 50").find("particles at a time, more than 1e+05"),
            std::string::npos);
  EXPECT_NE(ofSource("speed_m_s: 1", "limits: {max_particles: 5}").find("more than 5"),
            std::string::npos);
  EXPECT_NE(ofSource("speed_m_s: 1", "bounds: {min_m: [0, 0, 0.1]}")
                .find("sources.0 (tap): x in m of a place that water leaves"),
            std::string::npos);
  EXPECT_NE(ofSource("speed_m_s: 1, celsius: 4").find("unknown key sources.0.celsius"),
            std::string::npos);
}

TEST(FlowRefusals, WaterOfASourceIsLiquid) {
  const std::string heat = "thermal: {enabled: true}";
  EXPECT_EQ(ofSource("speed_m_s: 1, temperature_c: 0", heat), "");
  EXPECT_NE(ofSource("speed_m_s: 1, temperature_c: -1", heat)
                .find("sources.0 (tap).temperature_c, from thermal.freezing_c to "
                      "thermal.boiling_c, = -1 is outside the allowed range [0, 100]"),
            std::string::npos);
  EXPECT_EQ(ofSource("speed_m_s: 1, temperature_c: -1"), "") << "one temperature for all";
}

TEST(FlowRefusals, NamesAreUniqueAndGivenToThoseWithout) {
  const Scene scene = parseScene(
      "sources: [{speed_m_s: 1}, {speed_m_s: 1}]\n"
      "drains: [{max_m: [1, 1, 1]}]");
  EXPECT_EQ(scene.sources[1].name, "source_1");
  EXPECT_EQ(scene.drains[0].name, "drain_0");
  EXPECT_EQ(refusal("sources: [{name: a, speed_m_s: 1}, {name: a, speed_m_s: 1}]"),
            "scene: two sources are called a; give each its own name");
  EXPECT_NE(refusal("sources: [{name: \"a b\", speed_m_s: 1}]").find("name of a source"),
            std::string::npos);
  EXPECT_NE(refusal("drains: [{name: out, max_m: [1, 0, 1]}]")
                .find("drains.0 (out): min_m.1 = 0 must be below max_m.1 = 0"),
            std::string::npos);
}

TEST(FlowRefusals, ASourceInASolidIsRefused) {
  const std::string ball = "spheres: [{name: ball, radius_m: 0.05, position_m: [0, 0, ";
  EXPECT_EQ(ofSource("speed_m_s: 1", ball + "-0.06]}]"), "");
  EXPECT_EQ(ofSource("speed_m_s: 1", ball + "-0.049]}]"),
            "scene: sources.0 (tap): 4 of its 13 particles lie inside sphere ball (spheres.0); "
            "change sources.0.position_m or radius_m, or spheres.0.position_m");
  EXPECT_NE(
      ofSource("speed_m_s: 1, radius_m: 0.001",
               "containers: [{name: tank, size_m: [1, 1, 1],"
               " position_m: [0, 0, 0.01]}]")
          .find("sources.0 (tap): 1 of its 1 particles lies inside the wall of container tank"),
      std::string::npos);
}

TEST(FlowRefusals, CommandsToSourcesNameThemAndChangeNothing) {
  Scene scene = test::jet(test::tap(Vec3d::Zero(), 0.02, 1.0), 0.01);
  Source other = test::tap({1, 0, 0}, 0.02, 1.0);
  other.name = "hose";
  scene.sources.push_back(other);
  Simulator<float> simulator(scene, 1);
  const std::uint64_t hash = simulator.stateHash();
  const auto refused = [&](const std::string& name, double flow_l_min) {
    const std::string why = test::refusalOf([&] { simulator.setSource(name, false, flow_l_min); });
    EXPECT_EQ(simulator.stateHash(), hash);
    return why;
  };
  EXPECT_EQ(refused("tab", 1.0), "no source \"tab\"; scene unnamed has: tap, hose");
  EXPECT_EQ(refused("tap", -1.0)
                .rfind("flow of source tap in l/min = -1 is outside the allowed "
                       "range [0, 2261.9",
                       0),
            0U);
  EXPECT_NE(refused("hose", std::nan("")), "");
  EXPECT_NE(refused("hose", 2300.0), "");
  scene.sources.clear();
  EXPECT_EQ(test::refusalOf([&] { requireSource(scene, "tap", 1.0); }),
            "no source \"tap\"; scene unnamed has none");
}

}  // namespace flow_refusals_test
}  // namespace ice_ice_baby
