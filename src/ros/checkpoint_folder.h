// The only folder in which services write and read files, by name.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// Checkpoints are files NAME.ckpt in one folder, without subfolders. The folder is created when it
/// is first needed.
class CheckpointFolder {
 public:
  /// @param path absolute @throws InvalidInput for a relative path
  explicit CheckpointFolder(std::string path);

  /// $ROS_HOME, else ~/.ros, then ice_ice_baby and the name of the node. With neither ROS_HOME nor
  /// HOME set there is no folder, and every use of it is refused.
  static CheckpointFolder defaultFor(const std::string& node);

  /// "" where there is no folder.
  const std::string& path() const { return path_; }

  /// Why nothing can be saved here, as far as is known without writing; "" if nothing is known.
  std::string problem() const;

  /// Creates the folder and its parents where they are missing, and forces them to the disk.
  /// @throws InvalidInput with path and reason where that fails, or where the folder is read-only
  void create() const;

  /// @throws InvalidInput for a name that is not 1 to 64 letters, digits, - or _, or begins with
  /// autosave, for a link, for a 101st checkpoint, and where the folder cannot be read
  void requireFree(const std::string& name) const;

  /// Writes a checkpoint under a name given by a user. @returns its path
  /// @throws InvalidInput as requireFree, create and writeCheckpoint
  std::string save(std::string_view bytes, const std::string& name) const;

  /// Replaces the older of two autosaves. @returns its path
  /// @throws InvalidInput as create and writeCheckpoint
  std::string autosave(std::string_view bytes) const;

  /// Path of an existing checkpoint. @throws InvalidInput, with the names there are, for another
  std::string find(const std::string& name) const;

  /// Names of the checkpoints, newest first; none if the folder does not exist.
  /// @throws InvalidInput where the folder cannot be read
  std::vector<std::string> names() const;

 private:
  CheckpointFolder() = default;

  std::string pathOf(const std::string& name) const { return path_ + "/" + name + ".ckpt"; }

  std::string path_;
};

/// The newest intact checkpoint.
struct Resumption {
  std::unique_ptr<Simulation> simulation;  ///< null: there is none
  std::string name;
  std::vector<std::string> broken;  ///< one line per newer checkpoint that cannot be used
};

/// Tries the checkpoints of a folder, newest first.
/// @throws InvalidInput where the folder cannot be read
Resumption resumeFrom(const CheckpointFolder& folder, int threads);

}  // namespace ice_ice_baby
