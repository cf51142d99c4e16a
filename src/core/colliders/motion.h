// Motion of a collider in a substep.
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

}  // namespace ice_ice_baby
