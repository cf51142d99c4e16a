// The one thread that owns the simulation: paces it, and applies commands between frames.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "ice_ice_baby/simulation.h"
#include "pacing.h"

namespace ice_ice_baby {

/// What others may know of the simulation while it runs: a copy, taken after each frame.
struct Snapshot {
  StepReport report;
  std::vector<StageStats> stages;
  std::string scene;
  Preset preset = Preset::kDefault;
  Precision precision = Precision::kFloat;
  Vec3d gravity_m_s2 = Vec3d::Zero();
  bool heat = false;                    ///< whether each particle has a temperature of its own
  double thermal_speedup_wanted = 0.0;  ///< thermal.speedup of the scene
  std::vector<std::string> colliders;   ///< names
  bool paused = false;
  double real_time_factor = 0.0;
  double simulated_s = 0.0;              ///< since the node started, over every reset
  std::uint64_t speed_limited = 0;       ///< the same, particles that the speed limit slowed
  std::uint64_t correction_limited = 0;  ///< the same, corrections that were cut
  std::string failure;                   ///< why frames stopped, "" while all is well
  std::uint64_t state_hash = 0;          ///< Simulation::stateHash while paused, 0 while it runs
  std::uint64_t changes = 0;             ///< frames and commands since the node started
  std::uint64_t refused = 0;             ///< commands that came to nothing after they were accepted
  std::string refusal;                   ///< why the latest of them did
};

/// A scene and where it came from.
struct ServedScene {
  ServedScene(Scene from, std::string name = "")
      : scene(std::move(from)), source(std::move(name)) {}

  Scene scene;
  std::string source;  ///< what loadScene was given, "" for the scene of a checkpoint
};

/// How the thread runs.
struct RunOptions {
  Precision precision = Precision::kFloat;
  int threads = 0;                ///< of the solver, 0: all of the machine's
  double real_time_factor = 1.0;  ///< 0: as fast as the machine can
  bool ros_time = false;          ///< frames follow ros::Time
  bool start_paused = false;
};

/// What the thread calls, always from itself.
struct RunHooks {
  /// A simulation stands at its start: at first and after each reset.
  std::function<void(const Simulation&)> started = [](const Simulation&) {};
  std::function<void(Simulation&)> before_frame = [](Simulation&) {};
  /// After each frame, and at least every 50 ms. @param settled no frame follows by itself
  std::function<void(const Simulation&, const Snapshot&, bool settled)> tick =
      [](const Simulation&, const Snapshot&, bool) {};
};

/// Every command is checked by the caller's thread, against the scene that it will meet, then
/// queued and applied between two frames, in order; none waits for the solver. A reset that fails
/// leaves the old simulation running; a command that then fits no more changes nothing.
class SimulationThread {
 public:
  /// Builds the simulation at once and starts the thread.
  /// @param loaded goes on with this one of `scene`, unless null
  /// @throws InvalidInput for a scene or a number of threads that cannot run
  SimulationThread(const ServedScene& scene, const RunOptions& options, RunHooks hooks,
                   std::unique_ptr<Simulation> loaded = nullptr);
  /// Waits for the frame that is under way.
  ~SimulationThread();

  /// Each throws InvalidInput for a bad value, or when 1000 commands wait already; but pause and
  /// resume always work.
  /// @param target as Simulation::setTemperature has it
  void setTemperature(double celsius, double ramp_s, const std::string& target = "");
  void heatRegion(const HeatedRegion& region);
  void setGravity(const Vec3d& gravity_m_s2);
  /// @param scene as loadScene gave it, so already valid
  void reset(const ServedScene& scene);
  /// Goes on with `simulation` in place of the one that runs.
  void load(std::unique_ptr<Simulation> simulation);
  /// Calls `look` between two frames, from the simulation's thread.
  void inspect(std::function<void(const Simulation&)> look);
  void pause();
  void resume();
  /// Runs frames while paused, as fast as the machine can. @throws InvalidInput unless paused, and
  /// outside [1, 100000]
  void step(std::uint32_t frames);

  Snapshot snapshot() const;

  /// The scene that a command meets which is given now: the latest that was asked for.
  std::shared_ptr<const ServedScene> comingScene() const;

  /// Asks the thread to end. @returns whether it did within `patience_s`
  bool stop(double patience_s);

 private:
  /// What a command does. Of several kPause in a row only the last counts, so that pause and
  /// resume find room on a queue however full.
  enum class Kind { kChange, kLook, kPause };
  struct Command {
    Kind kind;
    std::function<void()> apply;
  };

  /// @param coming the scene that stands after the command, null: the same as before
  void post(Kind kind, std::function<void()> apply,
            std::shared_ptr<const ServedScene> coming = nullptr);
  void postPause(bool wanted, std::function<void()> apply);
  void run();
  void install(std::unique_ptr<Simulation> simulation, std::shared_ptr<const ServedScene> scene);
  /// After a reset to `failed`: unless another waits, commands meet the scene that runs.
  void forgetComing(const std::shared_ptr<const ServedScene>& failed);
  void applyCommands();
  bool runFrameIfDue();
  void runFrame();
  void updateSnapshot();
  void hashState();
  double waitTime_s();

  const RunOptions options_;
  const RunHooks hooks_;

  mutable std::mutex mutex_;  ///< guards what follows, up to snapshot_
  std::condition_variable changed_;
  std::vector<Command> commands_;
  bool pause_wanted_;
  bool stopping_ = false;
  bool ended_ = false;
  std::shared_ptr<const ServedScene> coming_scene_;
  Snapshot snapshot_;

  std::shared_ptr<const ServedScene> scene_;  ///< that runs; from here on: the thread's own
  std::unique_ptr<Simulation> simulation_;
  Snapshot latest_;
  Pacer pacer_;
  RealTimeFactor real_time_factor_;
  std::uint32_t steps_left_ = 0;
  std::thread thread_;
};

}  // namespace ice_ice_baby
