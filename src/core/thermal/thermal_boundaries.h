// Heat transfer through collider surfaces that are not insulated.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "colliders/colliders.h"
#include "colliders/distance_table.h"
#include "phase/enthalpy_curve.h"
#include "thermal/conduction_lattice.h"

namespace ice_ice_baby {

/// Effect of the walls near a particle.
template <class Real>
struct WallContact {
  Real length_m = 0;  ///< conductance length to surfaces with a temperature
  Real level = 0;     ///< their mean potential, W/m, weighted by conductance; for steam the
                      ///< temperature in Celsius
  Real power_w = 0;   ///< from surfaces with a flux

  void add(Real length, double at) {
    length_m += length;
    if (length_m > 0) level += (static_cast<Real>(at) - level) * (length / length_m);
  }
};

/// A wall with a temperature counts as if the rest lattice continued behind it, with temperatures
/// extrapolated linearly from the particle through the wall. A curved surface counts as the flat
/// wall with the conductance of a spherical shell. Particles beside an edge or a corner receive
/// heat from their neighbours over the faces only. So a surface with a flux delivers flux x area.
template <class Real>
class ThermalBoundaries {
 public:
  ThermalBoundaries(const Scene& scene, const Colliders<Real>& colliders,
                    const ConductionLattice& lattice, const EnthalpyCurve& curve);

  /// Ramps the surface temperature of a collider over `ramp_s` simulated seconds, starting from its
  /// present one or that of the scene file. @throws InvalidInput for an unknown name
  void set(const std::string& name, double celsius, double ramp_s);

  /// Advances the ramps by simulated time.
  void advance(double dt_s);

  /// Whether any collider is not insulated.
  bool active() const;
  /// Whether a collider has no surface temperature: it is insulated or has a flux.
  bool mirrors(std::size_t collider) const;
  /// Temperature of the surface, or of the scene file if it has none. @throws InvalidInput
  double celsius(const std::string& name) const;

  /// For a particle that conducts.
  WallContact<Real> at(const Vec3<Real>& point) const;
  /// Index of a collider colder than `celsius` that a particle at the point touches, or kNone.
  Index colderThan(double celsius, const Vec3<Real>& point) const;
  /// For steam: surfaces with a temperature that it touches; `length_m` is their number.
  WallContact<Real> touching(const Vec3<Real>& point) const;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    for (auto& one : self.surfaces_) {
      archive(one.heat, one.celsius, one.target_c, one.ramp_left_s);
    }
  }

  /// @throws InvalidInput when what was read is no temperature or ramp
  void restore() const;

  std::size_t bytes() const { return share_.bytes() + surfaces_.capacity() * sizeof(Surface); }

 private:
  struct Surface {
    std::string name;
    ThermalBoundary heat;
    double flux_w_m2;
    double celsius;
    double target_c;
    double ramp_left_s;
  };

  const Surface& surface(const std::string& name) const;
  template <class Visit>
  void forEachNear(const Vec3<Real>& point, Real reach, const Visit& visit) const;

  const Colliders<Real>& colliders_;
  const EnthalpyCurve& curve_;
  Real spacing_;
  Real radius_;
  Real support_;
  Real area_;                      ///< m^2
  DistanceTable<Real> share_;      ///< ConductionLattice::wallShare
  std::vector<Surface> surfaces_;  ///< of each collider
};

}  // namespace ice_ice_baby
