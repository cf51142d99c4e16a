// What each stage of a step costs: calls and time, by name.
#pragma once

#include <chrono>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

/// A stage that a scene holds. `run` does the work and counts it.
class StageClock {
 public:
  explicit StageClock(const char* name) : name_(name) {}

  template <class Work>
  void run(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    time_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ++calls_;
  }

  StageStats stats(std::size_t bytes) const { return {name_, calls_, time_s_, bytes}; }

 private:
  const char* name_;
  std::uint64_t calls_ = 0;
  double time_s_ = 0.0;
};

}  // namespace ice_ice_baby
