#include "sequences/file_sequence.h"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/written_file.h"

namespace ice_ice_baby {

namespace fs = std::filesystem;

FileSequence::FileSequence(std::string folder, std::string name, std::string extension)
    : folder_(std::move(folder)), name_(std::move(name)), extension_(std::move(extension)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (!fs::is_directory(folder_)) {
    throw InvalidInput("cannot make the folder " + folder_ + ": " + error.message());
  }
  for (const auto& entry : fs::directory_iterator(folder_)) {
    if (has(entry.path().filename().string())) fs::remove(entry.path(), error);
  }
}

/// Whether a file is one of an earlier run: five digits, as next() names them.
bool FileSequence::has(const std::string& file) const {
  const std::string first = name_ + "_", last = "." + extension_;
  return file.size() == first.size() + 5 + last.size() && file.rfind(first, 0) == 0 &&
         file.substr(first.size() + 5) == last &&
         file.find_first_not_of("0123456789", first.size()) == first.size() + 5;
}

std::string FileSequence::next(double time_s) {
  char number[16];
  std::snprintf(number, sizeof number, "_%05zu.", files_.size());
  files_.emplace_back(name_ + number + extension_, time_s);
  return folder_ + "/" + files_.back().first;
}

void FileSequence::writeIndex() const {
  nlohmann::json index = {{"file-series-version", "1.0"}, {"files", nlohmann::json::array()}};
  for (const auto& [file, time_s] : files_) {
    index["files"].push_back({{"name", file}, {"time", time_s}});
  }
  writeFile(folder_ + "/" + name_ + "." + extension_ + ".series", index.dump(1) + "\n");
}

}  // namespace ice_ice_baby
