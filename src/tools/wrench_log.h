// Wrenches of colliders over a run, as means between samples and over its last half second.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

class WrenchLog {
 public:
  /// Starts to measure. @param simulation must outlive it
  explicit WrenchLog(Simulation& simulation);

  /// Takes what the latest frame did. Call it after every frame.
  void add();

  /// (colliders) means over the frames since the latest call; zero without any.
  std::vector<ColliderWrench> takeSample();
  /// (colliders) means over the last half second.
  std::vector<ColliderWrench> lastHalfSecond() const;

 private:
  Simulation& simulation_;
  std::size_t half_second_;  ///< in frames
  std::deque<std::vector<ColliderWrench>> frames_;
  std::vector<ColliderWrench> sum_;  ///< (colliders) over the frames since the latest sample
  std::size_t count_ = 0;            ///< of those frames
};

}  // namespace ice_ice_baby
