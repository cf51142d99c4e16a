#include <ice_ice_baby/HeatRegion.h>
#include <ice_ice_baby/LoadScene.h>
#include <ice_ice_baby/Reset.h>
#include <ice_ice_baby/SetGravity.h>
#include <ice_ice_baby/SetHeatRegion.h>
#include <ice_ice_baby/SetSource.h>
#include <ice_ice_baby/SetTemperature.h>
#include <ros/serialization.h>

#include "geometry.h"
#include "ice_ice_baby/errors.h"
#include "parameters.h"
#include "promises.h"
#include "requests.h"

namespace ice_ice_baby::fuzz {

namespace {

constexpr char kRequestsScene[] = R"(
fluid: {spacing_m: 0.05, boundary_density: false}
thermal: {enabled: true}
solver: {quality: fast}
blocks: [{min_m: [-0.1, -0.1, 0], max_m: [0.1, 0.1, 0.1], celsius: -1}]
planes: [{name: tank, heat: temperature}]
sources: [{name: tap, position_m: [0, 0, 0.4], radius_m: 0.06, speed_m_s: 1}]
heat_regions: [{name: torch, power_w: 500}]
)";

/// @throws ros::Exception if the bytes end too early; roscpp then calls no callback
template <class Request>
Request read(const std::string& bytes) {
  std::string copy = bytes;
  ros::serialization::IStream stream(reinterpret_cast<std::uint8_t*>(copy.data()),
                                     static_cast<std::uint32_t>(copy.size()));
  Request request;
  ros::serialization::deserialize(stream, request);
  return request;
}

/// The first byte selects the service; the rest is the request.
void serve(Simulation& simulation, const std::string& bytes) {
  const std::string rest = bytes.substr(1);
  switch (bytes[0]) {
    case 't': {
      const auto request = read<SetTemperature::Request>(rest);
      return simulation.setTemperature(request.temperature, request.ramp_s, request.target);
    }
    case 'h':
      return simulation.heatRegion(regionOf(read<HeatRegion::Request>(rest)));
    case 'g':
      return simulation.setGravity(vectorOf(read<SetGravity::Request>(rest).gravity));
    case 's': {
      const auto request = read<SetSource::Request>(rest);
      return simulation.setSource(request.name, request.open, request.flow_l_min);
    }
    case 'w': {
      const auto request = read<SetHeatRegion::Request>(rest);
      return simulation.setHeatRegion(request.name, request.active, request.power_w);
    }
    case 'r': {
      const auto request = read<Reset::Request>(rest);
      requireSceneName(request.scene);
      overridesFor(NodeParameters(), request.preset);
      return;
    }
    case 'l':
      parseForeignScene(read<LoadScene::Request>(rest).yaml);
      return;
    default:
      return;
  }
}

}  // namespace

void requests(const std::string& bytes) {
  static const Scene scene = parseScene(kRequestsScene);
  if (bytes.empty()) return;
  const auto simulation = makeSimulation(scene, Precision::kFloat, 1);
  const std::uint64_t before = simulation->stateHash();
  const std::size_t particles = particlesEver(*simulation);
  try {
    serve(*simulation, bytes);
  } catch (const InvalidInput& e) {
    requireReadable(e.what());
    if (simulation->stateHash() != before) throw Broken("a refusal changed the state");
  } catch (const ros::Exception&) {
    return;
  }
  simulation->advanceFrame();
  requireWhole(*simulation, particles);
}

}  // namespace ice_ice_baby::fuzz
