// Which particles the drains of a scene remove.
#pragma once

#include <vector>

#include "particles/particles.h"

namespace ice_ice_baby {

class Drains {
 public:
  explicit Drains(const Scene& scene) : allowance_(scene.drains.size(), 0.0) {}

  /// Marks the particles that drains remove at the end of a frame: all in an unlimited one,
  /// otherwise those nearest to its centre, as many as its rate allows.
  /// @param gone (n) set for those that are removed; those already set are not removed again
  /// @param stays (n) whether a particle is not removed
  /// @return number of particles marked
  template <class Real>
  std::size_t choose(const Scene& scene, const Particles<Real>& particles, std::vector<char>& gone,
                     const std::vector<char>& stays);

  std::size_t bytes() const { return allowance_.capacity() * sizeof(double); }

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.allowance_);
  }
  /// @throws InvalidInput if the state of a checkpoint is out of range
  void restore(const Scene& scene) const;

 private:
  std::vector<double> allowance_;  ///< particles that a drain may still remove, 0 ... 1
};

}  // namespace ice_ice_baby
