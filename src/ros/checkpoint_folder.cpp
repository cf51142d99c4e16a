#include "checkpoint_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".ckpt";
constexpr const char* kAutosave = "autosave";
constexpr std::size_t kMaxNameLength = 64;
/// Callers of the service must not be able to fill the disk.
constexpr std::size_t kMaxCheckpoints = 100;

void requireName(const std::string& name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  });
  if (plain && !name.empty() && name.size() <= kMaxNameLength) return;
  throw InvalidInput(
      "name = \"" + shortened(name) +
      "\" must be 1 to 64 letters, digits, - or _, as before_freezing; the folder is set by the "
      "node's parameter ~checkpoint_folder");
}

fs::file_time_type writtenAt(const fs::path& path) {
  std::error_code missing;
  const fs::file_time_type time = fs::last_write_time(path, missing);
  return missing ? fs::file_time_type::min() : time;
}

/// Value of an environment variable, "" if it is not set.
std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

constexpr const char* kNoFolder =
    "there is no checkpoint folder: neither ROS_HOME nor HOME is an absolute path; set one of "
    "them, "
    "or ~checkpoint_folder";

std::string refusal(const std::string& path, const std::string& reason) {
  return "cannot use the checkpoint folder " + path + ": " + reason +
         "; make it a folder that the node may write to, or set ~checkpoint_folder to another";
}

/// `path` or the nearest parent that exists.
fs::path existingPart(fs::path path) {
  std::error_code error;
  while (!fs::exists(path, error) && path != path.root_path()) path = path.parent_path();
  return path;
}

/// Forces the entries of a folder to the disk; some file systems do not support that.
void flush(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

}  // namespace

CheckpointFolder::CheckpointFolder(std::string path) : path_(std::move(path)) {
  if (!path_.empty() && path_.front() == '/') return;
  throw InvalidInput("parameter ~checkpoint_folder = \"" + shortened(path_) +
                     "\" must be an absolute path, as /var/lib/ice_ice_baby");
}

CheckpointFolder CheckpointFolder::defaultFor(const std::string& node) {
  std::string root = environment("ROS_HOME");
  if (root.empty()) root = environment("HOME") + "/.ros";
  const bool usable = root.front() == '/' && root != "/.ros";
  return usable ? CheckpointFolder(root + "/ice_ice_baby" + node) : CheckpointFolder();
}

std::string CheckpointFolder::problem() const {
  if (path_.empty()) return kNoFolder;
  const fs::path there = existingPart(path_);
  std::error_code error;
  if (!fs::is_directory(there, error)) {
    return refusal(path_, there.string() + " is not a folder");
  }
  if (::access(there.c_str(), W_OK | X_OK) == 0) return "";
  const std::string reason = std::strerror(errno);
  return refusal(path_, there == path_ ? reason : there.string() + ": " + reason);
}

void CheckpointFolder::create() const {
  if (const std::string why = problem(); !why.empty()) throw InvalidInput(why);
  std::vector<fs::path> missing;
  const fs::path there = existingPart(path_);
  for (fs::path at = path_; at != there; at = at.parent_path()) missing.push_back(at);
  std::error_code error;
  while (!missing.empty()) {
    fs::create_directory(missing.back(), error);
    if (error) throw InvalidInput(refusal(path_, error.message()));
    flush(missing.back().parent_path());
    missing.pop_back();
  }
}

void CheckpointFolder::requireFree(const std::string& name) const {
  requireName(name);
  if (name.rfind(kAutosave, 0) == 0) {
    throw InvalidInput("name = \"" + name +
                       "\" is reserved for the node's own checkpoints; choose a name that does not "
                       "begin with autosave");
  }
  if (fs::is_symlink(pathOf(name))) {
    throw InvalidInput(pathOf(name) + " is a link, which may point outside the folder; remove it");
  }
  const std::vector<std::string> there = names();
  const bool replaces = std::find(there.begin(), there.end(), name) != there.end();
  if (!replaces && there.size() >= kMaxCheckpoints) {
    throw InvalidInput(path_ + " holds " + std::to_string(there.size()) + " checkpoints of " +
                       std::to_string(kMaxCheckpoints) +
                       " allowed; delete some, or save under an existing name");
  }
}

std::string CheckpointFolder::save(std::string_view bytes, const std::string& name) const {
  requireFree(name);
  create();
  writeCheckpoint(bytes, pathOf(name));
  return pathOf(name);
}

std::string CheckpointFolder::autosave(std::string_view bytes) const {
  create();
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
  if (path_.empty()) throw InvalidInput(kNoFolder);
  std::error_code error;
  fs::directory_iterator entries(path_, error);
  if (error == std::errc::no_such_file_or_directory) return {};
  if (error) throw InvalidInput(refusal(path_, error.message()));
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  for (const auto& entry : entries) {
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

}  // namespace ice_ice_baby
