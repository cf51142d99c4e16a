// Places where a new particle would lie in nothing else.
#pragma once

#include <optional>
#include <vector>

#include "base/point_grid.h"
#include "colliders/colliders.h"
#include "flow/sources.h"
#include "particles/particles.h"

namespace ice_ice_baby {

/// New particles keep this distance from others, in spacings. Closer ones would push each other
/// away hard.
constexpr double kKeptApart_d = 0.5;

template <class Real>
class FreePlaces {
 public:
  /// @param colliders, particles must outlive it
  /// @param drops that will be asked for
  FreePlaces(const Colliders<Real>& colliders, const Particles<Real>& particles, double spacing_m,
             const std::vector<Drop>& drops);

  /// Takes the place of the drop, unless its site or way lies in a solid, or a particle or an
  /// earlier drop is too close. A drop closer to a solid than half a spacing is moved away from it,
  /// as at the start of a scene.
  /// @param in_the_way set to the particles that are too close; none for a solid
  /// @return whether the place was free
  bool take(Drop& drop, std::vector<Index>& in_the_way);

 private:
  std::optional<Vec3d> beside(const Vec3d& from_m, const Vec3d& to_m) const;

  const Colliders<Real>& colliders_;
  double spacing_m_;
  PointGrid taken_;  ///< numbers of particles; kNone for drops
};

}  // namespace ice_ice_baby
