#include "simulation_thread.h"

#include <ros/console.h>

#include <algorithm>

#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/source_warning.h"
#include "stage.h"

namespace ice_ice_baby {

namespace {

constexpr std::size_t kMaxCommands = 1000;
constexpr double kMaxSteps = 100000;
constexpr double kMaxWait_s = 0.05;

double frameTime_s(const Simulation& simulation) {
  return 1.0 / simulation.scene().solver.frame_rate_hz;
}

}  // namespace

SimulationThread::SimulationThread(const ServedScene& scene, const RunOptions& options,
                                   RunHooks hooks, std::unique_ptr<Simulation> loaded)
    : options_(options),
      hooks_(std::move(hooks)),
      pause_wanted_(options.start_paused),
      coming_scene_(std::make_shared<const ServedScene>(scene)),
      pacer_(0.0, options.ros_time) {
  latest_.paused = options.start_paused;
  if (!loaded) loaded = makeSimulation(scene.scene, options.precision, options.threads);
  install(std::move(loaded), coming_scene_);
  thread_ = std::thread([this] { run(); });
}

SimulationThread::~SimulationThread() {
  stop(0.0);
  thread_.join();
}

void SimulationThread::setTemperature(double celsius, double ramp_s, const std::string& target) {
  requireTemperature(celsius, ramp_s);
  requireTarget(comingScene()->scene, target);
  post(Kind::kChange, [=] { simulation_->setTemperature(celsius, ramp_s, target); });
}

void SimulationThread::heatRegion(const HeatedRegion& region) {
  requireHeatedRegion(comingScene()->scene, region);
  post(Kind::kChange, [=] { simulation_->heatRegion(region); });
}

void SimulationThread::setGravity(const Vec3d& gravity_m_s2) {
  requireGravity(gravity_m_s2);
  post(Kind::kChange, [=] { simulation_->setGravity(gravity_m_s2); });
}

void SimulationThread::setHeatRegion(const std::string& name, bool active, double power_w) {
  requireHeatRegion(comingScene()->scene, name, power_w);
  post(Kind::kChange, [=] { simulation_->setHeatRegion(name, active, power_w); });
}

void SimulationThread::setSource(const std::string& name, bool open, double flow_l_min) {
  requireSource(comingScene()->scene, name, flow_l_min);
  post(Kind::kChange, [=] { simulation_->setSource(name, open, flow_l_min); });
}

void SimulationThread::attach(const std::string& solid, const std::string& frame) {
  requireSolid(comingScene()->scene, solid);
  if (!frame.empty()) requireFrameName("frame", frame);
  post(Kind::kChange, [=] { hooks_.attach(*simulation_, solid, frame); });
}

void SimulationThread::reset(const ServedScene& scene) {
  const auto coming = std::make_shared<const ServedScene>(scene);
  const auto begin = [this, coming] {
    steps_left_ = 0;
    try {
      install(makeSimulation(coming->scene, options_.precision, options_.threads), coming);
    } catch (...) {
      forgetComing(coming);
      throw;
    }
    hooks_.started(*simulation_);
  };
  post(Kind::kChange, begin, coming);
}

void SimulationThread::load(std::unique_ptr<Simulation> simulation) {
  const ServedScene scene = simulation->scene();
  load(std::move(simulation), scene);
}

void SimulationThread::load(std::unique_ptr<Simulation> simulation, const ServedScene& scene) {
  const auto coming = std::make_shared<const ServedScene>(scene);
  const auto loaded = std::make_shared<std::unique_ptr<Simulation>>(std::move(simulation));
  const auto begin = [this, coming, loaded] {
    steps_left_ = 0;
    install(std::move(*loaded), coming);
    hooks_.started(*simulation_);
  };
  post(Kind::kChange, begin, coming);
}

void SimulationThread::inspect(std::function<void(const Simulation&)> look) {
  post(Kind::kLook, [this, look = std::move(look)] { look(*simulation_); });
}

void SimulationThread::pause() {
  postPause(true, [this] {
    latest_.paused = true;
    steps_left_ = 0;
    real_time_factor_.clear();
  });
}

void SimulationThread::resume() {
  postPause(false, [this] {
    latest_.paused = false;
    latest_.failure.clear();
    steps_left_ = 0;
  });
}

void SimulationThread::step(std::uint32_t frames) {
  requireInRange("frames to step", frames, 1, kMaxSteps);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!pause_wanted_) throw InvalidInput("step works only while paused; call pause first");
  }
  post(Kind::kChange, [=] {
    const double total = double(steps_left_) + frames;
    steps_left_ = static_cast<std::uint32_t>(std::min(total, kMaxSteps));
  });
}

Snapshot SimulationThread::snapshot() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return snapshot_;
}

std::shared_ptr<const ServedScene> SimulationThread::comingScene() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return coming_scene_;
}

bool SimulationThread::stop(double patience_s) {
  std::unique_lock<std::mutex> lock(mutex_);
  stopping_ = true;
  changed_.notify_all();
  return changed_.wait_for(lock, std::chrono::duration<double>(patience_s),
                           [this] { return ended_; });
}

void SimulationThread::post(Kind kind, std::function<void()> apply,
                            std::shared_ptr<const ServedScene> coming) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (commands_.size() >= kMaxCommands) {
    throw InvalidInput(std::to_string(kMaxCommands) +
                       " commands wait for the frame under way to end; try again later");
  }
  commands_.push_back({kind, std::move(apply)});
  if (coming) coming_scene_ = std::move(coming);
  changed_.notify_all();
}

void SimulationThread::postPause(bool wanted, std::function<void()> apply) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!commands_.empty() && commands_.back().kind == Kind::kPause) commands_.pop_back();
  commands_.push_back({Kind::kPause, std::move(apply)});
  pause_wanted_ = wanted;
  changed_.notify_all();
}

void SimulationThread::install(std::unique_ptr<Simulation> simulation,
                               std::shared_ptr<const ServedScene> scene) {
  simulation_ = std::move(simulation);
  scene_ = std::move(scene);
  latest_.failure.clear();
  latest_.state_hash = 0;
  latest_.colliders.clear();
  forEachCollider(simulation_->scene(),
                  [this](const Collider& c) { latest_.colliders.push_back(c.name); });
  latest_.spacing_m = simulation_->scene().fluid.spacing_m;
  latest_.view = stageOf(simulation_->scene()).cast<double>();
  const bool paced = options_.real_time_factor > 0.0;
  pacer_.setInterval(paced ? frameTime_s(*simulation_) / options_.real_time_factor : 0.0);
  updateSnapshot();
}

void SimulationThread::forgetComing(const std::shared_ptr<const ServedScene>& failed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (coming_scene_ == failed) coming_scene_ = scene_;
}

void SimulationThread::run() {
  hooks_.started(*simulation_);
  while (true) {
    applyCommands();
    const bool ran = runFrameIfDue();
    const bool settled = latest_.paused && steps_left_ == 0;
    if (settled) hashState();
    hooks_.tick(*simulation_, latest_, settled && ran);
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, std::chrono::duration<double>(waitTime_s()),
                      [this] { return stopping_ || !commands_.empty(); });
    if (!stopping_) continue;
    ended_ = true;
    changed_.notify_all();
    return;
  }
}

void SimulationThread::applyCommands() {
  std::vector<Command> commands;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    commands.swap(commands_);
  }
  for (const Command& command : commands) {
    try {
      command.apply();
      if (command.kind == Kind::kLook) continue;
      latest_.changes += 1;
      latest_.state_hash = 0;
    } catch (const std::exception& e) {
      latest_.refused += 1;
      latest_.refusal = e.what();
      ROS_ERROR("A command failed and changed nothing: %s", e.what());
    }
  }
  if (!commands.empty()) updateSnapshot();
}

bool SimulationThread::runFrameIfDue() {
  if (steps_left_ > 0) {
    --steps_left_;
    runFrame(0.0, true);
    return true;
  }
  if (latest_.paused || pacer_.remaining() > 0.0) return false;
  runFrame(pacer_.frameBegins(), false);
  real_time_factor_.add(WallClock::now(), latest_.simulated_s);
  return true;
}

/// A frame that throws, for example out of memory, pauses the simulation and does not end the node.
void SimulationThread::runFrame(double late_s, bool stepped) {
  latest_.state_hash = 0;
  latest_.changes += 1;
  try {
    const double end_s = latest_.simulated_s + frameTime_s(*simulation_);
    hooks_.before_frame(*simulation_, {end_s, late_s, stepped});
    const StepReport& report = simulation_->advanceFrame();
    latest_.simulated_s += frameTime_s(*simulation_);
    latest_.speed_limited += report.speed_limited;
    latest_.correction_limited += report.correction_limited;
  } catch (const std::exception& e) {
    latest_.failure = e.what();
    latest_.paused = true;
    steps_left_ = 0;
    ROS_ERROR("The simulation paused because a frame failed: %s", e.what());
  }
  updateSnapshot();
}

void SimulationThread::updateSnapshot() {
  const Scene& scene = simulation_->scene();
  latest_.report = simulation_->report();
  latest_.stages = simulation_->stages();
  latest_.scene = scene.name;
  latest_.preset = scene.preset;
  latest_.precision = simulation_->precision();
  latest_.thermal = scene.thermal.enabled;
  latest_.thermal_speedup_wanted = scene.thermal.speedup;
  latest_.gravity_m_s2 = scene.gravity_m_s2;
  latest_.sources = scene.sources;
  latest_.heat_regions = scene.heat_regions;
  latest_.source_warning = sourceWarning(scene, latest_.report);
  latest_.real_time_factor = latest_.paused ? 0.0 : real_time_factor_.value();
  const std::lock_guard<std::mutex> lock(mutex_);
  snapshot_ = latest_;
  if (!latest_.failure.empty()) pause_wanted_ = true;
}

/// Once per state in which the simulation is paused.
void SimulationThread::hashState() {
  if (latest_.state_hash != 0) return;
  latest_.state_hash = simulation_->stateHash();
  updateSnapshot();
}

double SimulationThread::waitTime_s() {
  if (steps_left_ > 0) return 0.0;
  if (latest_.paused) return kMaxWait_s;
  const double remaining_s = pacer_.remaining();
  if (!options_.ros_time) return std::min(remaining_s, kMaxWait_s);
  return std::min(remaining_s, 0.005);  // ROS time may run at any rate, so look often
}

}  // namespace ice_ice_baby
