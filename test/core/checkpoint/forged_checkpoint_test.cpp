// Forged checkpoints with a valid checksum are refused, naming the file, or they run.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>

#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"
#include "simulation/stories.h"

namespace ice_ice_baby {
namespace forged_checkpoint_test {

using test::blockOf;
using test::Random;
using test::Story;

constexpr std::size_t kHeader_bytes = 32;
constexpr std::size_t kChecksumPlace = 28;

/// Simulation from the bytes; null if they are refused, which must name the file.
std::unique_ptr<Simulation> loaded(const std::string& bytes) {
  try {
    return decodeCheckpoint(bytes, "some/run.ckpt", 1);
  } catch (const InvalidInput& e) {
    EXPECT_EQ(std::string(e.what()).rfind("some/run.ckpt: ", 0), 0U) << e.what();
    return nullptr;
  }
}

/// The same bytes with a valid checksum.
std::string resigned(std::string bytes) {
  const auto* first = reinterpret_cast<const Bytef*>(bytes.data());
  const auto checksum = std::uint32_t(crc32_z(crc32_z(0, first, kChecksumPlace),
                                              first + kHeader_bytes, bytes.size() - kHeader_bytes));
  std::memcpy(bytes.data() + kChecksumPlace, &checksum, sizeof checksum);
  return bytes;
}

template <class Value>
void put(std::string& bytes, std::size_t at, Value value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

double anySize(Random& random, double digits) {
  const double size = std::pow(10.0, random.uniform(-digits, digits));
  return random.uniform(0, 1) < 0.5 ? size : -size;
}

/// Makes one edit at or after `first`: a byte, a number of any magnitude, a small index, or bytes
/// copied from elsewhere.
std::string edited(std::string bytes, std::size_t first, Random& random) {
  const auto place = [&] { return std::size_t(random.uniform(double(first), bytes.size() - 8.0)); };
  const std::size_t at = place();
  switch (int(random.uniform(0, 6))) {
    case 0:
      bytes[at] = char(static_cast<unsigned char>(random.uniform(0, 256)));
      break;
    case 1:
      put(bytes, at, float(anySize(random, 38)));
      break;
    case 2:
      put(bytes, at, anySize(random, 300));
      break;
    case 3:
      put(bytes, at, std::uint32_t(random.uniform(0, 200)));
      break;
    case 4:
      put(bytes, at, std::uint64_t(0x7fefffffffffffff));
      break;
    default:
      bytes.replace(at, 8, bytes.substr(place(), 8));
  }
  return bytes;
}

TEST(ForgedTest, ScenesAreRefusedByNameOrLoad) {
  const auto original = makeSimulation(test::fullTank(2), Precision::kFloat, 1);
  original->advanceFrame();
  const std::string whole = encodeCheckpoint(*original);
  ASSERT_EQ(resigned(whole), whole);
  const std::size_t end = whole.size() - test::stateOf(*original).size();
  Random random(11);
  int refused = 0;
  constexpr int kForged = 200;
  for (int k = 0; k < kForged; ++k) {
    const std::string scene = edited(whole.substr(0, end), kHeader_bytes, random);
    refused += loaded(resigned(scene + whole.substr(end))) == nullptr;
  }
  EXPECT_GT(refused, kForged / 4);
  EXPECT_LT(refused, kForged);
}

TEST(ForgedTest, MoreSpilledParticlesThanThereWereAreRefused) {
  const auto original = makeSimulation(test::fullTank(2), Precision::kFloat, 1);
  original->advanceFrame();
  std::string bytes = encodeCheckpoint(*original);
  StateWriter counts;
  counts(std::uint64_t(original->report().particles), std::uint64_t(0));
  const std::size_t place = bytes.rfind(counts.bytes());
  ASSERT_NE(place, std::string::npos);
  put(bytes, place + 8, std::uint64_t(1));
  const std::string why = test::refusalOf([&] { decodeCheckpoint(resigned(bytes), "file", 1); });
  EXPECT_EQ(why, "file: invalid checkpoint: more particles left than there were");
}

/// Few particles and no boundary density, so that thousands of edits take seconds.
Story small(Story story, double scale) {
  story.scene.fluid.spacing_m *= scale;
  story.scene.fluid.boundary_density = false;
  story.scene.thermal.air_heat_transfer_w_m2k = 0.0;
  story.scene.containers.clear();
  story.act = [](Simulation&, int) {};
  return story;
}

/// Ice of several bodies that fall on a floor and on each other, beside water.
Story fallingIce(double compliance_m_n) {
  Story story = small(test::kettleStory(compliance_m_n), 1.3);
  Block second = story.scene.blocks[1];
  second.min_m.z() += 0.1;
  second.max_m.z() += 0.1;
  story.scene.blocks.push_back(second);
  story.scene.planes[0].heat = ThermalBoundary::kTemperature;
  story.scene.planes[0].celsius = -5.0;
  story.scene.ice.stick_to_cold = true;
  return story;
}

Story frozen() {
  Story story = {"frozen", test::floatingCube(4)};
  story.scene.temperature.initial_c = -10.0;
  return story;
}

void expectWhole(const Simulation& simulation, std::size_t particles, int edit) {
  std::vector<ParticleSample> samples;
  simulation.sample(samples);
  const StepReport& report = simulation.report();
  ASSERT_EQ(samples.size(), report.particles) << edit;
  ASSERT_EQ(report.particles + report.spilled, particles) << edit;
  for (const ParticleSample& s : samples) {
    for (const float value : {s.x, s.y, s.z, s.vx, s.vy, s.vz, s.temperature_c, s.ice_fraction,
                              s.density, s.pressure_pa}) {
      ASSERT_TRUE(std::isfinite(value)) << edit;
    }
  }
  ASSERT_NO_THROW(encodeCheckpoint(simulation)) << "all of it is finite " << edit;
}

class ForgedStateTest : public testing::TestWithParam<Story> {};

/// The checksum does not protect against forged bytes. What the reader accepts must run.
TEST_P(ForgedStateTest, IsRefusedOrRunsAndStaysFinite) {
  const auto original = makeSimulation(GetParam().scene, Precision::kFloat, 1);
  for (int frame = 0; frame < 12; ++frame) original->advanceFrame();
  const std::string whole = encodeCheckpoint(*original);
  const std::size_t state = whole.size() - test::stateOf(*original).size();
  Random random(7);
  int refused = 0;
  constexpr int kForged = 600;
  for (int k = 0; k < kForged; ++k) {
    const auto simulation = loaded(resigned(edited(whole, state, random)));
    refused += simulation == nullptr;
    if (!simulation) continue;
    expectWhole(*simulation, original->report().particles, k);
    for (int frame = 0; frame < 2; ++frame) simulation->advanceFrame();
    expectWhole(*simulation, original->report().particles, k);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(refused, kForged / 20);
  EXPECT_LT(refused, kForged);
}

INSTANTIATE_TEST_SUITE_P(Of, ForgedStateTest,
                         testing::Values(fallingIce(0.0), fallingIce(1e-6), frozen(),
                                         small(test::hailStory(), 1.6)),
                         [](const auto& made) { return made.param.name; });

}  // namespace forged_checkpoint_test
}  // namespace ice_ice_baby
