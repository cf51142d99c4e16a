#include "checkpoint_folder.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".ckpt";
constexpr const char* kAutosave = "autosave";
constexpr std::size_t kLongestName = 64;
/// Whoever reaches the service may not fill the disk.
constexpr std::size_t kMostCheckpoints = 100;

void requireName(const std::string& name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  });
  if (plain && !name.empty() && name.size() <= kLongestName) return;
  throw InvalidInput(
      "name = \"" + shortened(name) +
      "\" must be 1 to 64 letters, digits, - or _, as before_freezing; the folder is "
      "the node's parameter ~checkpoint_folder");
}

fs::file_time_type writtenAt(const fs::path& path) {
  std::error_code missing;
  const fs::file_time_type time = fs::last_write_time(path, missing);
  return missing ? fs::file_time_type::min() : time;
}

}  // namespace

CheckpointFolder::CheckpointFolder(std::string path) : path_(std::move(path)) {
  if (!path_.empty() && path_.front() == '/') return;
  throw InvalidInput("parameter ~checkpoint_folder = \"" + shortened(path_) +
                     "\" must be an absolute path, as /var/lib/ice_ice_baby");
}

void CheckpointFolder::requireFree(const std::string& name) const {
  requireName(name);
  if (name.rfind(kAutosave, 0) == 0) {
    throw InvalidInput("name = \"" + name +
                       "\" is kept for the node's own checkpoints; take one that does not begin "
                       "with autosave");
  }
  if (fs::is_symlink(pathOf(name))) {
    throw InvalidInput(pathOf(name) + " is a link, which may lead out of the folder; remove it");
  }
  const std::vector<std::string> there = names();
  const bool replaces = std::find(there.begin(), there.end(), name) != there.end();
  if (!replaces && there.size() >= kMostCheckpoints) {
    throw InvalidInput(path_ + " holds " + std::to_string(there.size()) + " checkpoints, of " +
                       std::to_string(kMostCheckpoints) +
                       " allowed; delete some, or save under a name that is there");
  }
}

std::string CheckpointFolder::save(std::string_view bytes, const std::string& name) const {
  requireFree(name);
  writeCheckpoint(bytes, pathOf(name));
  return pathOf(name);
}

std::string CheckpointFolder::autosave(std::string_view bytes) const {
  const std::string first = pathOf(std::string(kAutosave) + "_1");
  const std::string second = pathOf(std::string(kAutosave) + "_2");
  const std::string& older = writtenAt(first) <= writtenAt(second) ? first : second;
  writeCheckpoint(bytes, older);
  return older;
}

std::string CheckpointFolder::find(const std::string& name) const {
  requireName(name);
  const std::vector<std::string> there = names();
  if (std::find(there.begin(), there.end(), name) != there.end()) return pathOf(name);
  if (there.empty()) {
    throw InvalidInput("no checkpoint \"" + name + "\": " + path_ + " holds none; call save first");
  }
  throw InvalidInput("no checkpoint \"" + name + "\"" + suggestion(name, there));
}

std::vector<std::string> CheckpointFolder::names() const {
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(path_, unreadable)) {
    if (entry.path().extension() != kEnding) continue;
    found.emplace_back(writtenAt(entry.path()), entry.path().stem().string());
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<std::string> names;
  names.reserve(found.size());
  for (auto& [time, name] : found) names.push_back(std::move(name));
  return names;
}

Resumption resumeFrom(const CheckpointFolder& folder, int threads) {
  Resumption resumption;
  for (const std::string& name : folder.names()) {
    try {
      resumption.simulation = loadCheckpoint(folder.find(name), threads);
      resumption.name = name;
      break;
    } catch (const std::exception& e) {
      resumption.broken.emplace_back(e.what());
    }
  }
  return resumption;
}

std::string defaultCheckpointFolder(const std::string& node) {
  const char* ros_home = std::getenv("ROS_HOME");
  const char* home = std::getenv("HOME");
  const std::string root = ros_home ? ros_home : std::string(home ? home : "/tmp") + "/.ros";
  return root + "/ice_ice_baby" + node;
}

}  // namespace ice_ice_baby
