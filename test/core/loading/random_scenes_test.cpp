// Scenes drawn at random from the ranges in params.h and scene_keys.h. Those that are not refused
// keep every particle finite and in its container, with the same bits on one thread and on two.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <type_traits>

#include "fixtures.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_keys.h"
#include "ice_ice_baby/simulation.h"
#include "metrics/escape_meter.h"

namespace ice_ice_baby {
namespace random_scenes_test {

constexpr int kScenes = test::repeats(150);
constexpr int kFrames = 3;
constexpr double kShareDrawn = 0.25;  ///< of the keys; the others keep their default

/// Visitor of describe(): sets some keys at random and records them for the message of a failure.
class Draw {
 public:
  Draw(test::Random& random, std::ostream& drawn, std::string path = "")
      : random_(random), drawn_(drawn), path_(std::move(path)) {}

  void operator()(const char* name, double& value, Range range, const char*) {
    if (draws()) note(name, value = number(range));
  }
  void operator()(const char* name, int& value, Range range, const char*) {
    if (draws()) note(name, value = int(number(range)));
  }
  void operator()(const char* name, Vec3d& value, Range range, const char*) {
    if (!draws()) return;
    for (double& part : value) part = number(range);
    note(name, value.transpose());
  }
  void operator()(const char* name, Mat3<double>& value, Range range, const char*) {
    if (!draws()) return;
    for (Eigen::Index k = 0; k < value.size(); ++k) value(k) = number(range);
    note(name, value);
  }
  void operator()(const char* name, bool& value, const char*) {
    if (draws()) note(name, value = random_.uniform(0, 1) < 0.5);
  }
  void operator()(const char*, std::string&, const char*) {}
  template <class Choice>
  std::enable_if_t<std::is_enum_v<Choice>> operator()(const char* name, Choice& value,
                                                      const char*) {
    if (!draws()) return;
    const auto names = choices(value);
    const auto k = std::size_t(random_.uniform(0, double(names.size())));
    value = static_cast<Choice>(k);
    note(name, names[k]);
  }
  template <class Params>
  void section(const char* name, Params& params, const char*) {
    describe(params, Draw(random_, drawn_, path_ + name + "."));
  }
  template <class Item>
  void list(const char* name, std::vector<Item>& items, const char*) {
    for (std::size_t k = 0; k < items.size(); ++k) {
      describe(items[k], Draw(random_, drawn_, path_ + name + "." + std::to_string(k) + "."));
    }
  }

 private:
  bool draws() { return random_.uniform(0, 1) < kShareDrawn; }

  /// An end of the range, or a number of any magnitude in it.
  double number(Range range) {
    const double choice = random_.uniform(0, 1);
    if (choice < 0.1) return range.min;
    if (choice < 0.2) return range.max;
    const double max = std::max(std::abs(range.min), std::abs(range.max));
    const double size = max * std::pow(10.0, random_.uniform(-6.0, 0.0));
    const double drawn = range.min < 0.0 && choice < 0.6 ? -size : size;
    return std::clamp(drawn, range.min, range.max);
  }

  template <class Value>
  void note(const char* name, const Value& value) {
    drawn_ << path_ << name << "=" << value << "\n";
  }

  test::Random& random_;
  std::ostream& drawn_;
  std::string path_;
};

/// Resets the keys that would only make the scene large or empty.
void keepSmall(Scene& scene, test::Random& random) {
  scene.duration_s = 1.0;
  scene.limits = LimitParams();
  scene.bounds = BoundsParams();
  FluidParams& fluid = scene.fluid;
  fluid.spacing_m = 1e-3 * std::pow(10.0, random.uniform(0.0, 3.0));
  if (fluid.support_radius_m > 0.0) {
    fluid.support_radius_m = fluid.spacing_m * random.uniform(1.05, 4.0);
  }
  scene.solver.substeps = std::min(scene.solver.substeps, 12);
  scene.solver.iterations = std::min(scene.solver.iterations, 6);
  const double d = fluid.spacing_m;
  for (Container& tank : scene.containers) {
    tank.position_m.setZero();
    tank.size_m = d * random.inBox(Vec3d::Constant(8), Vec3d::Constant(12));
    tank.wall_m = d * random.uniform(0.5, 3.0);
  }
  // Side by side and below the spheres, as overlaps are refused.
  double from_x = -3.0;
  for (Block& block : scene.blocks) {
    const Vec3d low = d * random.inBox(Vec3d(from_x, -3, 1), Vec3d(from_x + 0.4, -1, 2));
    block.min_m = low;
    block.max_m = low + d * random.inBox(Vec3d::Constant(2.01), Vec3d(2.4, 4.5, 2.9));
    block.copies.setOnes();
    from_x += 3.5;
  }
  for (Sphere& sphere : scene.spheres) {
    sphere.position_m = d * Vec3d(random.uniform(-4, 4), 0, 7);
    sphere.radius_m = d * random.uniform(0.5, 2.0);
  }
  for (Box& box : scene.boxes) {
    box.position_m = d * Vec3d(random.uniform(-4, 4), 3, 7);
    box.size_m = d * random.inBox(Vec3d::Constant(0.5), Vec3d::Constant(1.5));
  }
}

struct Drawn {
  Scene scene;
  std::string keys;  ///< key=value of what differs from a default scene
};

Drawn drawScene(std::uint64_t seed) {
  test::Random random(seed);
  std::ostringstream keys;
  keys.precision(17);
  Scene scene;
  scene.blocks.resize(std::size_t(random.uniform(1, 3)));
  scene.schedule.resize(std::size_t(random.uniform(0, 3)));
  scene.containers.resize(std::size_t(random.uniform(0, 2)));
  scene.planes.resize(std::size_t(random.uniform(0, 2)));
  scene.spheres.resize(std::size_t(random.uniform(0, 2)));
  scene.boxes.resize(std::size_t(random.uniform(0, 2)));
  describe(scene, Draw(random, keys));
  keepSmall(scene, random);
  for (Container& tank : scene.containers) tank.name = "tank";
  return {scene, keys.str()};
}

bool finite(const StepReport& r) {
  bool finite = true;
  describe(r, [&](const char*, const auto& value, const char*) {
    finite = finite && std::isfinite(double(value));
  });
  return finite;
}

void expectConsistent(const Simulation& simulation, std::uint64_t frame) {
  const StepReport& report = simulation.report();
  const Scene& scene = simulation.scene();
  EXPECT_EQ(report.frame, frame);
  EXPECT_DOUBLE_EQ(report.time_s, double(frame) / scene.solver.frame_rate_hz);
  EXPECT_TRUE(finite(report));
  EXPECT_EQ(report.non_finite, 0u);
  EXPECT_LE(report.ice_particles + report.steam_particles, report.particles);
  EXPECT_LE(report.ice_bodies_asleep, report.ice_bodies);
  EXPECT_LE(report.density_error_mean, report.density_error_max);
  EXPECT_LE(report.rms_speed_m_s, report.max_speed_m_s * (1 + 1e-12));
  EXPECT_GE(report.strictness, 0.0);
  EXPECT_LE(report.strictness, 1.0);
  std::vector<ParticleSample> samples;
  simulation.sample(samples);
  ASSERT_EQ(samples.size() + report.spilled, std::size_t(particleCount(scene)));
  ASSERT_EQ(report.particles, samples.size());
  for (const ParticleSample& s : samples) {
    ASSERT_TRUE(std::isfinite(s.x + s.y + s.z) && std::isfinite(s.vx + s.vy + s.vz) &&
                std::isfinite(s.density) && std::isfinite(s.temperature_c))
        << "particle " << s.id;
  }
}

/// @return whether the scene ran; false if makeSimulation refused it
bool expectRuns(const Scene& scene) {
  std::unique_ptr<Simulation> one, two;
  try {
    one = makeSimulation(scene, Precision::kFloat, 1);
    two = makeSimulation(scene, Precision::kFloat, 2);
  } catch (const InvalidInput&) {
    return false;
  }
  const std::size_t outside = countEscaped(*one);  // of a block that juts out of a tilted tank
  for (int frame = 1; frame <= kFrames; ++frame) {
    one->advanceFrame();
    two->advanceFrame();
    expectConsistent(*one, std::uint64_t(frame));
    EXPECT_LE(countEscaped(*one), outside);
    EXPECT_EQ(one->stateHash(), two->stateHash()) << "frame " << frame;
    if (testing::Test::HasFailure()) return true;
  }
  return true;
}

TEST(RandomScenes, KeepEveryParticleOrAreRefused) {
  int ran = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const Drawn drawn = drawScene(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + drawn.keys);
    ran += expectRuns(drawn.scene);
  }
  EXPECT_GT(ran, kScenes / 4) << "too few scenes are valid for the test to mean much";
}

}  // namespace random_scenes_test
}  // namespace ice_ice_baby
