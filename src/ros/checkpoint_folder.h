// The one folder whose files the services may write and read, by name.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// Checkpoints lie flat in the folder as NAME.ckpt; no name leads out of it.
class CheckpointFolder {
 public:
  /// @param path absolute; the folder is made when the first checkpoint is written
  /// @throws InvalidInput for a path that is not absolute
  explicit CheckpointFolder(std::string path);

  const std::string& path() const { return path_; }

  /// @throws InvalidInput for a name that is not 1 to 64 letters, digits, - or _, or begins with
  /// autosave, for a link and for a 101st checkpoint
  void requireFree(const std::string& name) const;

  /// Writes a checkpoint that a user has named. @returns its path
  /// @throws InvalidInput as requireFree and writeCheckpoint
  std::string save(std::string_view bytes, const std::string& name) const;

  /// Writes over the older of two autosaves. @returns its path @throws InvalidInput as
  /// writeCheckpoint
  std::string autosave(std::string_view bytes) const;

  /// Path of a checkpoint that is there. @throws InvalidInput listing the names, where it is not
  std::string find(const std::string& name) const;

  /// What save and load can be asked for, the newest first.
  std::vector<std::string> names() const;

 private:
  std::string pathOf(const std::string& name) const { return path_ + "/" + name + ".ckpt"; }

  std::string path_;
};

/// The newest checkpoint that is whole.
struct Resumption {
  std::unique_ptr<Simulation> simulation;  ///< null where there is none
  std::string name;
  std::vector<std::string> broken;  ///< one line per newer checkpoint that cannot be used
};

/// Tries the checkpoints of a folder, the newest first. Throws nothing.
Resumption resumeFrom(const CheckpointFolder& folder, int threads);

/// $ROS_HOME, else ~/.ros, then ice_ice_baby and the name of the node.
std::string defaultCheckpointFolder(const std::string& node);

}  // namespace ice_ice_baby
