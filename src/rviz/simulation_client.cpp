#include "simulation_client.h"

#include <ice_ice_baby/GetState.h>
#include <ice_ice_baby/Reset.h>
#include <ice_ice_baby/SetTemperature.h>
#include <ice_ice_baby/Step.h>
#include <ros/names.h>
#include <ros/service.h>
#include <std_srvs/Trigger.h>

#include <boost/function.hpp>
#include <utility>

namespace ice_ice_baby {

SimulationClient::SimulationClient(Callbacks callbacks)
    : callbacks_(std::move(callbacks)), spinner_(1, &queue_) {
  handle_.setCallbackQueue(&queue_);
  spinner_.start();
  worker_ = std::thread([this] { work(); });
}

SimulationClient::~SimulationClient() {
  state_subscriber_.shutdown();
  spinner_.stop();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  breakOff();
  wake_.notify_all();
  worker_.join();
}

bool SimulationClient::follow(const std::string& node) {
  std::string error;
  if (node.empty() || !ros::names::validate(node, error)) return false;
  node_ = ros::names::resolve(node);
  breakOff();
  const boost::function<void(const State::ConstPtr&)> deliver =
      [this](const State::ConstPtr& state) { callbacks_.state(*state); };
  state_subscriber_ = handle_.subscribe<State>(node_ + "/state", 1, deliver);
  refresh();
  return true;
}

/// Discards waiting calls and cancels the pending one, so that a node that hangs does not block the
/// caller.
void SimulationClient::breakOff() {
  const std::lock_guard<std::mutex> lock(mutex_);
  jobs_.clear();
  ++generation_;
  if (under_way_) under_way_.shutdown();
}

void SimulationClient::enqueue(Job job) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    jobs_.push_back([job = std::move(job), node = node_] { return job(node); });
  }
  wake_.notify_one();
}

void SimulationClient::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return stopping_ || !jobs_.empty(); });
    if (stopping_) return;
    const auto job = std::move(jobs_.front());
    jobs_.pop_front();
    const unsigned generation = generation_;
    lock.unlock();
    const Answer answer = job();
    lock.lock();
    if (stopping_ || generation != generation_) continue;
    lock.unlock();
    callbacks_.answered(answer);
    lock.lock();
  }
}

template <typename Service>
Answer SimulationClient::call(const std::string& node, const std::string& name, Service& service) {
  Answer answer;
  answer.service = name;
  const std::string resolved = node + "/" + name;
  if (!ros::service::exists(resolved, false)) {
    answer.message = "no node at " + node;
    return answer;
  }
  // Persistent, because only a persistent client can be shut down while it waits for its answer.
  auto client = handle_.serviceClient<Service>(resolved, true);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stopping_) return answer;
    under_way_ = client;
  }
  answer.reached = client.call(service);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    under_way_ = ros::ServiceClient();
  }
  if (!answer.reached) {
    answer.message = "no answer from " + resolved;
    return answer;
  }
  answer.success = service.response.success;
  answer.message = service.response.message;
  return answer;
}

void SimulationClient::setTemperature(double celsius, double ramp_s, const std::string& target) {
  enqueue([this, celsius, ramp_s, target](const std::string& node) {
    SetTemperature service;
    service.request.temperature = celsius;
    service.request.ramp_s = ramp_s;
    service.request.target = target;
    return call(node, "set_temperature", service);
  });
}

void SimulationClient::pause() {
  enqueue([this](const std::string& node) {
    std_srvs::Trigger service;
    return call(node, "pause", service);
  });
}

void SimulationClient::resume() {
  enqueue([this](const std::string& node) {
    std_srvs::Trigger service;
    return call(node, "resume", service);
  });
}

void SimulationClient::step(unsigned frames) {
  enqueue([this, frames](const std::string& node) {
    Step service;
    service.request.frames = frames;
    return call(node, "step", service);
  });
}

void SimulationClient::reset(const std::string& scene, const std::string& preset) {
  enqueue([this, scene, preset](const std::string& node) {
    Reset service;
    service.request.scene = scene;
    service.request.preset = preset;
    return call(node, "reset", service);
  });
}

void SimulationClient::refresh() {
  enqueue([this](const std::string& node) {
    GetState service;
    Answer answer = call(node, "get_state", service);
    if (answer.success) {
      callbacks_.scenes(service.response.scenes);
      callbacks_.state(service.response.state);
    }
    return answer;
  });
}

}  // namespace ice_ice_baby
