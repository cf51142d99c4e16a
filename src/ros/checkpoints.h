// Checkpoints of the running simulation: the services save and load, and autosaves.
#pragma once

#include <ice_ice_baby/Load.h>
#include <ice_ice_baby/Save.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "checkpoint_folder.h"
#include "parameters.h"
#include "simulation_thread.h"

namespace ice_ice_baby {

/// The simulation's thread encodes between two frames, which is one pass over memory; what waits
/// for the disk are threads of this class alone, so neither frames nor other services do.
class Checkpoints {
 public:
  /// @param node of the private names @param resumed what the node started from
  Checkpoints(ros::NodeHandle node, const NodeParameters& parameters,
              const CheckpointFolder& folder, const Resumption& resumed,
              SimulationThread& simulation);
  /// Waits for a file under way, not for the simulation.
  ~Checkpoints();

  /// Full names of the services.
  std::vector<std::string> names() const { return {save_.getService(), load_.getService()}; }

  struct Status {
    std::string folder;
    std::string latest;   ///< what was saved last, or resumed from
    std::string resumed;  ///< what the node started from, "": from the scene
    std::string problem;  ///< why the latest attempt to save failed, "" while all is well
    std::vector<std::string> broken;  ///< that could not be resumed from
    std::uint64_t saved = 0;
  };
  Status status() const;

 private:
  bool save(Save::Request& request, Save::Response& response);
  bool load(Load::Request& request, Load::Response& response);
  void autosave();
  void autosaveEvery(double period_s);
  /// The bytes of the simulation as it is after the frame under way.
  /// @throws InvalidInput when 1000 commands wait, or the node ends
  std::string encoded();
  bool ending() const;
  void note(const std::string& saved, const std::string& problem);

  const CheckpointFolder folder_;
  const int threads_;
  SimulationThread& simulation_;
  std::mutex writing_;  ///< one file at a time

  mutable std::mutex mutex_;  ///< guards what follows, up to status_
  std::condition_variable changed_;
  bool stopping_ = false;
  Status status_;

  ros::CallbackQueue queue_;
  ros::ServiceServer save_;
  ros::ServiceServer load_;
  ros::AsyncSpinner spinner_;
  std::thread autosaver_;
};

}  // namespace ice_ice_baby
