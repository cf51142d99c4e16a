#include "services.h"

#include <algorithm>
#include <cmath>

#include "answer.h"
#include "geometry.h"
#include "ice_ice_baby/errors.h"
#include "requests.h"
#include "served_scene.h"
#include "state_message.h"

namespace ice_ice_baby {

namespace {

/// What set_temperature acts on, for messages.
std::string targetText(const Scene& scene, const std::string& target) {
  if (!target.empty()) return "collider " + target;
  return scene.thermal.enabled ? "air" : "the whole scene";
}

/// Flow of a source, open or closed; 0 without such a source.
double flowOf_l_min(const Snapshot& snapshot, const std::string& name) {
  for (const Source& source : snapshot.sources) {
    if (source.name == name) return source.flowInForce_m3_s() * kLitresPerMinute;
  }
  return 0.0;
}

/// Power of a heat region, active or not; 0 without such a region.
double powerOf_w(const Snapshot& snapshot, const std::string& name) {
  for (const HeatRegionParams& region : snapshot.heat_regions) {
    if (region.name == name) return region.power_w;
  }
  return 0.0;
}

std::string vectorText(const Vec3d& vector) {
  return "[" + numberText(vector.x()) + ", " + numberText(vector.y()) + ", " +
         numberText(vector.z()) + "]";
}

/// Fills in the scenes that can be asked for by name; returns why there are none. A node that runs
/// a scene by its path needs no scene folder.
std::string listScenes(std::vector<std::string>& scenes) {
  try {
    scenes = sceneNames();
    return "";
  } catch (const InvalidInput& e) {
    return e.what();
  }
}

}  // namespace

Services::Services(ros::NodeHandle& node, const NodeParameters& parameters,
                   SimulationThread& simulation, const Topics& topics, const ClockPublisher& clock)
    : parameters_(parameters), simulation_(simulation), topics_(topics), clock_(clock) {
  servers_ = {node.advertiseService("get_state", &Services::getState, this),
              node.advertiseService("set_temperature", &Services::setTemperature, this),
              node.advertiseService("heat_region", &Services::heatRegion, this),
              node.advertiseService("set_gravity", &Services::setGravity, this),
              node.advertiseService("set_heat_region", &Services::setHeatRegion, this),
              node.advertiseService("set_source", &Services::setSource, this),
              node.advertiseService("attach", &Services::attach, this),
              node.advertiseService("reset", &Services::reset, this),
              node.advertiseService("pause", &Services::pause, this),
              node.advertiseService("resume", &Services::resume, this),
              node.advertiseService("step", &Services::step, this)};
}

std::vector<std::string> Services::names() const {
  std::vector<std::string> names;
  for (const ros::ServiceServer& server : servers_) names.push_back(server.getService());
  return names;
}

bool Services::setTemperature(SetTemperature::Request& request,
                              SetTemperature::Response& response) {
  response.temperature = simulation_.snapshot().report.temperature_c;
  return answer(response, [&] {
    const std::string what = targetText(simulation_.comingScene()->scene, request.target);
    simulation_.setTemperature(request.temperature, request.ramp_s, request.target);
    const bool at_once = request.ramp_s == 0.0 && request.target.empty();
    if (at_once) response.temperature = request.temperature;
    return what + " going to " + numberText(request.temperature) + " degrees C over " +
           numberText(request.ramp_s) + " s";
  });
}

bool Services::heatRegion(HeatRegion::Request& request, HeatRegion::Response& response) {
  return answer(response, [&] {
    const HeatedRegion region = regionOf(request);
    simulation_.heatRegion(region);
    const std::string verb = region.power_w < 0.0 ? "cooling" : "heating";
    return verb + " a " + request.shape + " of " + vectorText(region.size_m) + " m about " +
           vectorText(region.centre_m) + " m with " + numberText(std::abs(region.power_w)) +
           " W for " + numberText(region.duration_s) + " s";
  });
}

bool Services::setGravity(SetGravity::Request& request, SetGravity::Response& response) {
  response.gravity = vectorMessage(simulation_.snapshot().gravity_m_s2);
  return answer(response, [&] {
    simulation_.setGravity(vectorOf(request.gravity));
    response.gravity = request.gravity;
    return std::string("gravity set");
  });
}

bool Services::setHeatRegion(SetHeatRegion::Request& request, SetHeatRegion::Response& response) {
  response.power_w = powerOf_w(simulation_.snapshot(), request.name);
  return answer(response, [&] {
    simulation_.setHeatRegion(request.name, request.active, request.power_w);
    if (request.power_w != 0.0) response.power_w = request.power_w;
    const std::string verb = response.power_w < 0.0 ? "cools" : "heats";
    const std::string does = verb + " with " + numberText(std::abs(response.power_w)) + " W";
    return "heat region " + request.name + " " + (request.active ? does : "is off");
  });
}

bool Services::setSource(SetSource::Request& request, SetSource::Response& response) {
  response.flow_l_min = flowOf_l_min(simulation_.snapshot(), request.name);
  return answer(response, [&] {
    simulation_.setSource(request.name, request.open, request.flow_l_min);
    if (request.flow_l_min > 0.0) response.flow_l_min = request.flow_l_min;
    return "source " + request.name + " is " + (request.open ? "open" : "closed") + ", " +
           numberText(response.flow_l_min) + " l/min";
  });
}

bool Services::attach(Attach::Request& request, Attach::Response& response) {
  return answer(response, [&] {
    simulation_.attach(request.solid, request.frame);
    response.frame = request.frame;
    return "solid " + request.solid +
           (request.frame.empty() ? " let go" : " attached to tf frame " + request.frame);
  });
}

bool Services::reset(Reset::Request& request, Reset::Response& response) {
  const std::lock_guard<std::mutex> lock(reset_mutex_);
  response.particles = static_cast<std::uint32_t>(simulation_.snapshot().report.particles);
  return answer(response, [&] {
    const ServedScene served = sceneFor(request);
    simulation_.reset(served);
    response.particles = static_cast<std::uint32_t>(particleCount(served.scene));
    return "scene " + served.scene.name + " from the start";
  });
}

ServedScene Services::sceneFor(const Reset::Request& request) const {
  if (!request.scene.empty()) requireSceneName(request.scene);
  const auto coming = simulation_.comingScene();
  const std::string name = request.scene.empty() ? coming->source : request.scene;
  if (name.empty() && request.preset.empty()) return *coming;
  if (name.empty()) {
    throw InvalidInput(
        "preset = \"" + shortened(request.preset) +
        "\" needs the name of a scene, because the current one came from a checkpoint or as text");
  }
  const std::string preset = request.preset.empty() ? parameters_.preset : request.preset;
  return {loadServedScene(parameters_, name, preset), name};
}

bool Services::step(Step::Request& request, Step::Response& response) {
  const std::uint32_t frames = std::max<std::uint32_t>(request.frames, 1);
  return answer(response, [&] {
    simulation_.step(frames);
    return "running " + std::to_string(frames) + (frames == 1 ? " frame" : " frames");
  });
}

bool Services::pause(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return answer(response, [&] {
    simulation_.pause();
    return std::string("paused");
  });
}

bool Services::resume(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return answer(response, [&] {
    simulation_.resume();
    return std::string("running");
  });
}

bool Services::getState(GetState::Request&, GetState::Response& response) {
  return answer(response, [&] {
    response.state = stateMessage(simulation_.snapshot(), topics_.header(clock_.stamp()));
    response.state.topics = topics_.loads();
    return listScenes(response.scenes);
  });
}

}  // namespace ice_ice_baby
