// The thread that owns the simulation: it paces frames and applies commands between them.
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

/// Copy of the simulation's report and settings, taken after each frame for other threads.
struct Snapshot {
  StepReport report;
  std::vector<StageStats> stages;
  std::string scene;
  Preset preset = Preset::kDefault;
  Precision precision = Precision::kFloat;
  Vec3d gravity_m_s2 = Vec3d::Zero();
  double spacing_m = 0.0;
  Eigen::AlignedBox3d view;             ///< box that a view of the scene should show
  bool thermal = false;                 ///< whether each particle has a temperature of its own
  double thermal_speedup_wanted = 0.0;  ///< thermal.speedup of the scene
  std::vector<std::string> colliders;   ///< names
  std::vector<Source> sources;          ///< with the values in force
  std::vector<HeatRegionParams> heat_regions;  ///< likewise
  std::string source_warning;                  ///< see sourceWarning
  bool paused = false;
  double real_time_factor = 0.0;
  double simulated_s = 0.0;              ///< since the node started, over every reset
  std::uint64_t speed_limited = 0;       ///< particles slowed by the speed limit, likewise
  std::uint64_t correction_limited = 0;  ///< corrections limited, likewise
  std::string failure;                   ///< why frames stopped, "" if they did not
  std::uint64_t state_hash = 0;          ///< Simulation::stateHash while paused, 0 while it runs
  std::uint64_t changes = 0;             ///< frames and commands since the node started
  std::uint64_t refused = 0;             ///< commands that failed after they were accepted
  std::string refusal;                   ///< why the latest of them failed
};

/// A scene and its name.
struct ServedScene {
  ServedScene(Scene from, std::string name = "")
      : scene(std::move(from)), source(std::move(name)) {}

  Scene scene;
  std::string source;  ///< argument of loadScene, "" for the scene of a checkpoint
};

/// How the thread runs.
struct RunOptions {
  Precision precision = Precision::kFloat;
  int threads = 0;                ///< of the solver, 0: one per core
  double real_time_factor = 1.0;  ///< 0: as fast as possible
  bool ros_time = false;          ///< whether frames follow ros::Time
  bool start_paused = false;
};

/// A frame that begins now.
struct FrameBegin {
  double end_s;   ///< simulated time at its end, since the node started
  double late_s;  ///< time since it was due, of the clock that paces frames
  bool stepped;   ///< whether it is a step while paused
};

/// Functions called on the simulation's thread.
struct RunHooks {
  /// A simulation starts: the first one, and after each reset and load.
  std::function<void(const Simulation&)> started = [](const Simulation&) {};
  std::function<void(Simulation&, const FrameBegin&)> before_frame = [](Simulation&,
                                                                        const FrameBegin&) {};
  /// A solid is attached to a tf frame, or let go where the frame is empty.
  std::function<void(Simulation&, const std::string& solid, const std::string& frame)> attach =
      [](Simulation&, const std::string&, const std::string&) {};
  /// After each frame, and at least every 50 ms. @param settled whether no frame follows by itself
  std::function<void(const Simulation&, const Snapshot&, bool settled)> tick =
      [](const Simulation&, const Snapshot&, bool) {};
};

/// A command is checked on the caller's thread, against the scene on which it will act, then queued
/// and applied between two frames, in order; callers do not wait for the solver. If a reset fails,
/// the old simulation goes on, and queued commands that do not suit it change nothing.
class SimulationThread {
 public:
  /// Builds the simulation at once and starts the thread.
  /// @param loaded simulation of `scene` to continue, null: makes a new one
  /// @throws InvalidInput for a scene or a number of threads that cannot run
  SimulationThread(const ServedScene& scene, const RunOptions& options, RunHooks hooks,
                   std::unique_ptr<Simulation> loaded = nullptr);
  /// Waits for the frame under way.
  ~SimulationThread();

  /// Commands throw InvalidInput for a bad value, or if 1000 commands wait already. Pause and
  /// resume always work. @param target see Simulation::setTemperature
  void setTemperature(double celsius, double ramp_s, const std::string& target = "");
  void heatRegion(const HeatedRegion& region);
  void setGravity(const Vec3d& gravity_m_s2);
  /// @param power_w see Simulation::setHeatRegion
  void setHeatRegion(const std::string& name, bool active, double power_w = 0.0);
  /// @param flow_l_min see Simulation::setSource
  void setSource(const std::string& name, bool open, double flow_l_min = 0.0);
  /// @param frame tf frame; "": the solid is let go
  void attach(const std::string& solid, const std::string& frame);
  /// @param scene from loadScene, so already valid
  void reset(const ServedScene& scene);
  /// Replaces the simulation by this one.
  void load(std::unique_ptr<Simulation> simulation);
  /// @param scene from which it was made, which a reset starts again
  void load(std::unique_ptr<Simulation> simulation, const ServedScene& scene);
  /// Calls `look` between two frames, on the simulation's thread.
  void inspect(std::function<void(const Simulation&)> look);
  void pause();
  void resume();
  /// Runs frames while paused, as fast as possible. @throws InvalidInput unless paused, and outside
  /// [1, 100000]
  void step(std::uint32_t frames);

  Snapshot snapshot() const;

  /// The scene on which a command given now will act: the latest one requested.
  std::shared_ptr<const ServedScene> comingScene() const;

  /// Asks the thread to end. @returns whether it ended within `patience_s`
  bool stop(double patience_s);

 private:
  /// Of several kPause in a row only the last is kept, so that pause and resume fit into a full
  /// queue.
  enum class Kind { kChange, kLook, kPause };
  struct Command {
    Kind kind;
    std::function<void()> apply;
  };

  /// @param coming the scene after the command, null: unchanged
  void post(Kind kind, std::function<void()> apply,
            std::shared_ptr<const ServedScene> coming = nullptr);
  void postPause(bool wanted, std::function<void()> apply);
  void run();
  void install(std::unique_ptr<Simulation> simulation, std::shared_ptr<const ServedScene> scene);
  /// After a failed reset to `failed`: unless another reset waits, commands act on the running
  /// scene.
  void forgetComing(const std::shared_ptr<const ServedScene>& failed);
  void applyCommands();
  bool runFrameIfDue();
  void runFrame(double late_s, bool stepped);
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

  std::shared_ptr<const ServedScene> scene_;  ///< running; from here on used by the thread only
  std::unique_ptr<Simulation> simulation_;
  Snapshot latest_;
  Pacer pacer_;
  RealTimeFactor real_time_factor_;
  std::uint32_t steps_left_ = 0;
  std::thread thread_;
};

}  // namespace ice_ice_baby
