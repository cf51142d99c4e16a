// A progress bar on a terminal; silent when piped.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace ice_ice_baby {

class ProgressBar {
 public:
  /// @param total number of steps
  ProgressBar(std::string title, std::size_t total);
  /// Clears the line.
  ~ProgressBar();

  /// Shows that `done` steps are finished, with a short note, at most ten times a second.
  void show(std::size_t done, const std::string& note);

 private:
  using Clock = std::chrono::steady_clock;

  std::string title_;
  std::size_t total_;
  bool terminal_;
  Clock::time_point start_;
  Clock::time_point shown_;
};

}  // namespace ice_ice_baby
