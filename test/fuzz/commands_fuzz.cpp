#include <cstdlib>
#include <sstream>

#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"
#include "promises.h"

namespace ice_ice_baby::fuzz {

namespace {

/// Without containers and balls, whose tables take a second with sanitizers.
constexpr char kCommandsScene[] = R"(
fluid: {spacing_m: 0.05, boundary_density: false}
thermal: {enabled: true, speedup: 1000}
solver: {quality: fast}
blocks:
  - {min_m: [-0.1, -0.1, 0], max_m: [0.1, 0.1, 0.1], celsius: 5}
  - {min_m: [-0.1, -0.1, 0.1], max_m: [0.1, 0.1, 0.2], celsius: -5}
planes:
  - {name: ground, heat: temperature}
  - {name: plate, size_x_m: 0.3, size_y_m: 0.3, position_m: [0, 0, 0.3], rpy_deg: [0, 10, 0]}
sources:
  - {name: tap, position_m: [0.4, 0, 0.4], radius_m: 0.06, flow_l_min: 600}
  - {name: hose, radius_m: 0.06, speed_m_s: 3, follow_frame: hand}
drains:
  - {name: hole, min_m: [-0.1, -0.1, 0], max_m: [0, 0.1, 0.1], rate_l_min: 900}
heat_regions:
  - {name: torch, power_w: 500}
solids:
  - {name: raft, size_m: [0.15, 0.15, 0.1], position_m: [-0.4, 0, 0.3], density_kg_m3: 500}
  - {name: ball, shape: sphere, radius_m: 0.06, position_m: [-0.4, 0.4, 0.3], density_kg_m3: 3000}
)";

constexpr int kMaxFrames = 5;
constexpr int kMaxCommands = 100;

/// Words of a line; numbers are read by strtod, so nan, inf and 0x1p-1074 are numbers.
class Words {
 public:
  explicit Words(const std::string& line) : stream_(line) {}

  std::string text() {
    std::string word;
    stream_ >> word;
    return word;
  }
  double number() { return std::strtod(text().c_str(), nullptr); }
  Vec3d vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

 private:
  std::istringstream stream_;
};

HeatedRegion readRegion(Words& words) {
  HeatedRegion region;
  const std::string shape = words.text();
  if (shape == "box") region.shape = BlockShape::kBox;
  if (shape == "cylinder") region.shape = BlockShape::kCylinder;
  region.centre_m = words.vector();
  region.size_m = words.vector();
  region.power_w = words.number();
  region.duration_s = words.number();
  return region;
}

/// Not normalised, as the simulation has to refuse what is not a rotation.
Posed readPose(Words& words) {
  Posed pose;
  pose.position = words.vector();
  const double w = words.number();
  const Vec3d v = words.vector();
  pose.rotation = Eigen::Quaterniond(w, v.x(), v.y(), v.z()).toRotationMatrix();
  return pose;
}

void run(Simulation& simulation, const std::string& line) {
  Words words(line);
  const std::string verb = words.text();
  if (verb == "temperature") {
    const double celsius = words.number(), ramp_s = words.number();
    simulation.setTemperature(celsius, ramp_s, words.text());
  } else if (verb == "heat") {
    simulation.heatRegion(readRegion(words));
  } else if (verb == "gravity") {
    simulation.setGravity(words.vector());
  } else if (verb == "move") {
    const std::string collider = words.text();
    simulation.moveCollider(collider, readPose(words));
  } else if (verb == "place") {
    const std::string collider = words.text();
    simulation.placeColliders({{collider, readPose(words)}});
  } else if (verb == "source") {
    const std::string source = words.text();
    const bool open = words.number() != 0.0;
    simulation.setSource(source, open, words.number());
  } else if (verb == "carry") {
    const std::string source = words.text();
    simulation.moveSource(source, readPose(words));
  } else if (verb == "put") {
    const std::string source = words.text();
    simulation.placeSource(source, readPose(words));
  } else if (verb == "region") {
    const std::string region = words.text();
    const bool active = words.number() != 0.0;
    simulation.setHeatRegion(region, active, words.number());
  } else if (verb == "aim") {
    const std::string region = words.text();
    simulation.moveHeatRegion(region, readPose(words));
  } else if (verb == "hold") {
    const std::string solid = words.text();
    simulation.holdSolid(solid, readPose(words));
  } else if (verb == "release") {
    simulation.releaseSolid(words.text());
  } else if (verb == "frame") {
    simulation.advanceFrame();
  }
}

}  // namespace

void commands(const std::string& bytes) {
  static const Scene scene = parseScene(kCommandsScene);
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  const std::size_t particles = particlesEver(*simulation);
  std::istringstream lines(bytes);
  std::string line;
  for (int k = 0; k < kMaxCommands && std::getline(lines, line); ++k) {
    if (simulation->report().frame >= kMaxFrames) break;
    const std::uint64_t before = simulation->stateHash();
    try {
      run(*simulation, line);
    } catch (const InvalidInput& e) {
      requireReadable(e.what());
      if (simulation->stateHash() != before) throw Broken("a refusal changed the state: " + line);
    }
    requireWhole(*simulation, particles);
  }
}

}  // namespace ice_ice_baby::fuzz
