#include "loading/scene_files.h"

#include <dlfcn.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"
#include "loading/yaml_text.h"

namespace ice_ice_baby {

namespace fs = std::filesystem;

namespace {

/// Folder within the scene folder, of the scenes whose answer is known.
constexpr char kVerification[] = "verification";

std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".yaml" || !entry.is_regular_file(error)) continue;
    if (!isScenePath(name)) names.push_back(name);  // a.yaml.yaml would be read as the path a.yaml
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The shared library that holds this code, or the program that it is linked into.
fs::path ownFile() {
  std::error_code error;
  Dl_info info;
  if (dladdr(kVerification, &info) != 0 && std::strchr(info.dli_fname, '/') != nullptr) {
    const fs::path file = fs::canonical(info.dli_fname, error);
    if (!error) return file;
  }
  return fs::canonical("/proc/self/exe", error);
}

/// Folder of the scenes that $ICE_ICE_BABY_SCENES names, or "".
std::string chosenFolder() {
  const char* chosen = std::getenv("ICE_ICE_BABY_SCENES");
  return chosen ? chosen : "";
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw InvalidInput("scene file " + shortened(path) + " " + why);
}

void requireOrdinary(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    const bool relative = fs::path(path).is_relative();
    const std::string folder = fs::current_path(error).string();
    throw InvalidInput("no scene file " + shortened(path) +
                       (relative ? " in the folder " + shortened(folder) : ""));
  }
  if (fs::is_directory(status)) refuse(path, "is a folder; name a .yaml file in it");
  if (!fs::is_regular_file(status)) refuse(path, "is a device or a pipe; name an ordinary file");
}

}  // namespace

bool isScenePath(const std::string& name_or_path) {
  const fs::path path(name_or_path);
  return path.extension() == ".yaml" || path.extension() == ".yml" || path.has_parent_path();
}

bool liesWithin(const std::string& file, const std::string& folder) {
  std::error_code error;
  const fs::path real_file = fs::canonical(file, error);
  const fs::path real_folder = fs::canonical(folder, error);
  if (error) return false;
  const auto ends =
      std::mismatch(real_folder.begin(), real_folder.end(), real_file.begin(), real_file.end());
  return ends.first == real_folder.end();
}

std::string readSceneFile(const std::string& path) {
  requireOrdinary(path);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse(path, std::string("cannot be read: ") + std::strerror(errno));
  // Not by the size that the file system tells: files of /proc have none, and a file may grow.
  std::string text(kMaxYaml_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) refuse(path, std::string("cannot be read: ") + std::strerror(errno));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > kMaxYaml_bytes) refuse(path, "is larger than 1 MiB, the largest allowed");
  return text;
}

std::string sceneFile(const std::string& name) {
  const std::vector<std::string> names = sceneNames();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw InvalidInput("no scene \"" + shortened(name) + "\"" + suggestion(name, names) +
                       "; or the path of a .yaml file");
  }
  const fs::path folder = sceneFolder();
  const fs::path ordinary = folder / (name + ".yaml");
  const fs::path file = fs::exists(ordinary) ? ordinary : folder / kVerification / (name + ".yaml");
  if (!liesWithin(file.string(), folder.string())) {
    throw InvalidInput("scene " + shortened(name) +
                       " is a link that leads out of the scene folder " + folder.string() +
                       "; copy the file there, or run it by its path");
  }
  return file.string();
}

std::string sceneFolder() {
  const std::string chosen = chosenFolder();
  if (!chosen.empty()) {
    if (fs::is_directory(chosen)) return chosen;
    throw InvalidInput("no scenes: ICE_ICE_BABY_SCENES = " + shortened(chosen) +
                       " is not a folder; set it to a folder of .yaml files, or unset it");
  }
  const fs::path installed = (ownFile().parent_path() / IIB_SCENES_FROM_HERE).lexically_normal();
  for (const fs::path& folder : {installed, fs::path(IIB_SOURCE_SCENES)}) {
    if (fs::is_directory(folder)) return folder.string();
  }
  throw InvalidInput("no scenes: neither " + installed.string() +
                     " nor " IIB_SOURCE_SCENES
                     " is a folder; set ICE_ICE_BABY_SCENES to a folder of .yaml files");
}

std::vector<std::string> sceneNames() {
  const fs::path folder = sceneFolder();
  std::vector<std::string> names = namesIn(folder);
  const std::vector<std::string> known = namesIn(folder / kVerification);
  names.insert(names.end(), known.begin(), known.end());
  if (!names.empty()) return names;
  throw InvalidInput("no scenes: " + shortened(folder.string()) +
                     " holds no .yaml files; set ICE_ICE_BABY_SCENES to a folder that does" +
                     (chosenFolder().empty() ? "" : ", or unset it"));
}

}  // namespace ice_ice_baby
