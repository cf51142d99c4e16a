#include "checkpoints.h"

#include <ros/console.h>

#include <chrono>
#include <future>

#include "answer.h"
#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

/// Interval between checks whether the node ends.
constexpr std::chrono::milliseconds kLook{50};

}  // namespace

Checkpoints::Checkpoints(ros::NodeHandle node, const NodeParameters& parameters,
                         const CheckpointFolder& folder, const Resumption& resumed,
                         SimulationThread& simulation)
    : folder_(folder), threads_(parameters.threads), simulation_(simulation), spinner_(1, &queue_) {
  status_.folder = folder_.path();
  status_.broken = resumed.broken;
  status_.latest = status_.resumed = resumed.name;
  node.setCallbackQueue(&queue_);
  save_ = node.advertiseService("save", &Checkpoints::save, this);
  load_ = node.advertiseService("load", &Checkpoints::load, this);
  spinner_.start();
  const double period_s = parameters.autosave_s;
  if (period_s > 0.0) autosaver_ = std::thread([this, period_s] { autosaveEvery(period_s); });
}

Checkpoints::~Checkpoints() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  if (autosaver_.joinable()) autosaver_.join();
  spinner_.stop();
}

Checkpoints::Status Checkpoints::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return status_;
}

bool Checkpoints::save(Save::Request& request, Save::Response& response) {
  return answer(response, [&] {
    folder_.requireFree(request.name);
    folder_.create();
    const std::string bytes = encoded();
    try {
      const std::lock_guard<std::mutex> lock(writing_);
      response.file = folder_.save(bytes, request.name);
    } catch (const InvalidInput& e) {
      note("", e.what());
      throw;
    }
    response.bytes = bytes.size();
    note(request.name, "");
    return "saved " + std::to_string(bytes.size()) + " bytes as " + response.file;
  });
}

bool Checkpoints::load(Load::Request& request, Load::Response& response) {
  response.particles = static_cast<std::uint32_t>(simulation_.snapshot().report.particles);
  return answer(response, [&] {
    std::unique_ptr<Simulation> loaded = loadCheckpoint(folder_.find(request.name), threads_);
    const Scene scene = loaded->scene();
    const StepReport report = loaded->report();
    simulation_.load(std::move(loaded));
    response.particles = static_cast<std::uint32_t>(report.particles);
    return "scene " + scene.name + " goes on from frame " + std::to_string(report.frame);
  });
}

void Checkpoints::autosaveEvery(double period_s) {
  std::uint64_t changes = 0;
  std::unique_lock<std::mutex> lock(mutex_);
  while (!changed_.wait_for(lock, std::chrono::duration<double>(period_s),
                            [this] { return stopping_; })) {
    lock.unlock();
    const std::uint64_t now = simulation_.snapshot().changes;
    if (now != changes) autosave();
    changes = now;
    lock.lock();
  }
}

void Checkpoints::autosave() {
  try {
    const std::string bytes = encoded();
    const std::lock_guard<std::mutex> lock(writing_);
    note(folder_.autosave(bytes), "");
  } catch (const std::exception& e) {
    const bool logged = status().problem == e.what();
    note("", e.what());
    if (!logged && !ending()) {
      ROS_ERROR("Autosave failed, the simulation goes on: %s", e.what());
    }
  }
}

std::string Checkpoints::encoded() {
  const auto promise = std::make_shared<std::promise<std::string>>();
  std::future<std::string> bytes = promise->get_future();
  simulation_.inspect([promise](const Simulation& simulation) {
    try {
      promise->set_value(encodeCheckpoint(simulation));
    } catch (...) {
      promise->set_exception(std::current_exception());
    }
  });
  while (bytes.wait_for(kLook) != std::future_status::ready) {
    if (ending()) throw InvalidInput("the node is shutting down");
  }
  return bytes.get();
}

bool Checkpoints::ending() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return stopping_;
}

void Checkpoints::note(const std::string& saved, const std::string& problem) {
  const std::lock_guard<std::mutex> lock(mutex_);
  status_.problem = problem;
  if (saved.empty()) return;
  status_.latest = saved;
  status_.saved += 1;
}

}  // namespace ice_ice_baby
