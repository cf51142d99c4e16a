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

/// The simulation's thread encodes a checkpoint between two frames, in one pass over memory. Only
/// threads of this class wait for the disk, so neither frames nor other services do.
class Checkpoints {
 public:
  /// @param node with the private names @param resumed what the node started from
  Checkpoints(ros::NodeHandle node, const NodeParameters& parameters,
              const CheckpointFolder& folder, const Resumption& resumed,
              SimulationThread& simulation);
  /// Waits for a file that is being written, not for the simulation.
  ~Checkpoints();

  /// Full names of the services.
  std::vector<std::string> names() const { return {save_.getService(), load_.getService()}; }

  struct Status {
    std::string folder;
    std::string latest;               ///< saved last, or resumed from
    std::string resumed;              ///< what the node started from, "": the scene
    std::string problem;              ///< why the latest save failed, "" if it did not
    std::vector<std::string> broken;  ///< checkpoints that could not be resumed
    std::uint64_t saved = 0;
  };
  Status status() const;

 private:
  bool save(Save::Request& request, Save::Response& response);
  bool load(Load::Request& request, Load::Response& response);
  void autosave();
  void autosaveEvery(double period_s);
  /// The simulation after the frame under way, encoded.
  /// @throws InvalidInput if 1000 commands wait, or if the node ends
  std::string encoded();
  bool ending() const;
  void note(const std::string& saved, const std::string& problem);

  const CheckpointFolder folder_;
  const int threads_;
  SimulationThread& simulation_;
  std::mutex writing_;  ///< held while a file is written

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
