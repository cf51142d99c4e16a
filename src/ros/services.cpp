#include "services.h"

#include <algorithm>
#include <cmath>

#include "geometry.h"
#include "ice_ice_baby/errors.h"
#include "requests.h"
#include "state_message.h"

namespace ice_ice_baby {

namespace {

/// Runs `work` and answers with what it returns, or with why it was refused.
template <class Response, class Work>
bool answer(Response& response, const Work& work) {
  try {
    response.message = work();
    response.success = true;
  } catch (const std::exception& e) {
    response.message = e.what();
    response.success = false;
  }
  return true;
}

/// What a temperature is set of, in words.
std::string targetText(const Scene& scene, const std::string& target) {
  if (!target.empty()) return "collider " + target;
  return scene.heat.enabled ? "air" : "the whole scene";
}

std::string vectorText(const Vec3d& vector) {
  return "[" + numberText(vector.x()) + ", " + numberText(vector.y()) + ", " +
         numberText(vector.z()) + "]";
}

}  // namespace

Services::Services(ros::NodeHandle& node, const NodeParameters& parameters,
                   SimulationThread& simulation, Frames& frames, const Topics& topics,
                   const ClockPublisher& clock)
    : parameters_(parameters),
      simulation_(simulation),
      frames_(frames),
      topics_(topics),
      clock_(clock),
      scene_(parameters.scene) {
  servers_ = {node.advertiseService("get_state", &Services::getState, this),
              node.advertiseService("set_temperature", &Services::setTemperature, this),
              node.advertiseService("heat_region", &Services::heatRegion, this),
              node.advertiseService("set_gravity", &Services::setGravity, this),
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
    const std::string what = targetText(*simulation_.comingScene(), request.target);
    simulation_.setTemperature(request.temperature, request.ramp_s, request.target);
    const bool at_once = request.ramp_s == 0.0 && request.target.empty();
    if (at_once) response.temperature = request.temperature;
    return what + " going to " + numberText(request.temperature) + " degrees C over " +
           numberText(request.ramp_s) + " s";
  });
}

bool Services::heatRegion(ApplyHeat::Request& request, ApplyHeat::Response& response) {
  return answer(response, [&] {
    const HeatRegion region = regionOf(request);
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

bool Services::reset(Reset::Request& request, Reset::Response& response) {
  const std::lock_guard<std::mutex> lock(reset_mutex_);
  response.particles = static_cast<std::uint32_t>(simulation_.snapshot().report.particles);
  return answer(response, [&] {
    if (!request.scene.empty()) requireSceneName(request.scene);
    const std::string name = request.scene.empty() ? scene_ : request.scene;
    const std::string preset = request.preset.empty() ? parameters_.preset : request.preset;
    const Scene scene = loadScene(name, overridesFor(parameters_, preset));
    simulation_.reset(scene);
    frames_.prepare(scene);  // only now: a refused reset leaves the running scene its tf
    scene_ = name;
    response.particles = static_cast<std::uint32_t>(particleCount(scene));
    return "scene " + scene.name + " from the start";
  });
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
    response.scenes = sceneNames();
    return std::string();
  });
}

}  // namespace ice_ice_baby
