// The vessels and gauges of a scene: where they are, and which particles are in them.
#pragma once

#include <string>
#include <vector>

#include "colliders/colliders.h"
#include "measure/vessel_space.h"
#include "particles/particles.h"

namespace ice_ice_baby {

/// Vessel of a particle, as its number within the list; kNoVessel: none.
using VesselNumber = std::uint16_t;
constexpr VesselNumber kNoVessel = 0xffff;

/// Sums over the particles in a vessel.
struct VesselContent {
  std::size_t particles = 0;
  std::size_t steam = 0;
  double water = 0.0, ice = 0.0;  ///< in volumes of a particle of water
  double floating = 0.0;          ///< what solids displace when they float or lie, in the same
  double celsius = 0.0;
};

struct MeasuredVessel {
  std::string name;
  VesselSpace space;
  Index collider = kNone;  ///< with which it moves
  Posed in_collider;       ///< its pose in the frame of that collider, or in the scene
};

/// Containers, cups and gauges, in this order.
class MeasuredVessels {
 public:
  explicit MeasuredVessels(const Scene& scene);

  std::size_t size() const { return all_.size(); }
  const MeasuredVessel& operator[](std::size_t number) const { return all_[number]; }

  /// Number of groups. Within a group a particle is in one vessel at most: group 0 are containers
  /// and cups, each other group is one gauge.
  std::size_t groups() const { return groups_.size(); }
  /// Members of a group, the smallest first, so that an inner vessel precedes the outer one.
  const std::vector<VesselNumber>& group(std::size_t number) const { return groups_[number]; }
  bool isGauge(std::size_t number) const { return number >= first_gauge_; }

  template <class Real>
  Posed pose(std::size_t number, const Colliders<Real>& colliders) const {
    const MeasuredVessel& vessel = all_[number];
    if (vessel.collider == kNone) return vessel.in_collider;
    const Posed at = colliders.pose(vessel.collider);
    return {at.toWorld(vessel.in_collider.position), at.rotation * vessel.in_collider.rotation};
  }

  /// Finds the vessel of each particle within a group. @param where (n) is overwritten
  template <class Real>
  void locate(std::size_t group, const VectorField<Real>& position_m,
              const Colliders<Real>& colliders, std::vector<VesselNumber>& where) const;

  /// How high `volume_m3` of water stands in a vessel, m; see levelOf_m. Solids displace water, and
  /// in a container or cup also the inside of smaller ones.
  /// @param up unit vector against gravity
  template <class Real>
  double level_m(std::size_t number, const Vec3d& up, double volume_m3,
                 const Colliders<Real>& colliders) const;

 private:
  std::vector<MeasuredVessel> all_;
  std::vector<std::vector<VesselNumber>> groups_;
  std::size_t first_gauge_ = 0;
};

}  // namespace ice_ice_baby
