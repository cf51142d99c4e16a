// Motion of a collider in a substep and over a frame.
#pragma once

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Pose of a collider at the start and at the end of a substep.
template <class Real>
struct Motion {
  Pose<Real> from;
  Pose<Real> to;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.from, self.to);
  }
};

/// Pose of a body that moves evenly from one pose to another.
/// @param fraction of the way, 0 ... 1
inline Posed between(const Posed& from, const Posed& to, double fraction) {
  const Eigen::Quaterniond begin(from.rotation), end(to.rotation);
  Posed pose;
  pose.position = from.position + fraction * (to.position - from.position);
  pose.rotation = begin.slerp(fraction, end).toRotationMatrix();
  return pose;
}

}  // namespace ice_ice_baby
