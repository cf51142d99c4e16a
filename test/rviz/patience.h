// Waiting in tests.
#pragma once

#include <chrono>
#include <thread>

namespace ice_ice_baby {

/// Waits up to 10 s of wall time for a condition. @return whether it came true
template <typename Condition>
bool await(Condition condition) {
  using Clock = std::chrono::steady_clock;
  for (const auto end = Clock::now() + std::chrono::seconds(10); Clock::now() < end;) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return condition();
}

}  // namespace ice_ice_baby
