// Heat across the surfaces of colliders that are not insulated.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "colliders/colliders.h"
#include "colliders/distance_table.h"
#include "phase/enthalpy_curve.h"
#include "thermal/conduction_lattice.h"

namespace ice_ice_baby {

/// What the walls near a particle do to it.
template <class Real>
struct WallContact {
  Real length_m = 0;  ///< through which surfaces with a temperature conduct to it
  Real level = 0;     ///< their potential, W/m, each as much as it conducts; for steam in Celsius
  Real power_w = 0;   ///< from surfaces with a flux

  void add(Real length, double at) {
    length_m += length;
    if (length_m > 0) level += (static_cast<Real>(at) - level) * (length / length_m);
  }
};

/// A wall with a temperature counts as if the rest lattice went on behind it, each ghost as much
/// beyond the wall's temperature as a straight line from the particle through the wall has it. A
/// curved surface counts as the flat wall with the conductance of a spherical shell.
template <class Real>
class ThermalBoundaries {
 public:
  ThermalBoundaries(const Scene& scene, const Colliders<Real>& colliders,
                    const ConductionLattice& lattice, const EnthalpyCurve& curve);

  /// Gives a collider a surface temperature, reached over `ramp_s` simulated seconds from the one
  /// that it has, or that the scene names. @throws InvalidInput for an unknown name
  void set(const std::string& name, double celsius, double ramp_s);

  /// Moves the ramps on by simulated time.
  void advance(double dt_s);

  /// Whether any collider is not insulated.
  bool active() const;
  /// Whether heat crosses no face of a collider by conduction: insulated, or with a flux.
  bool mirrors(std::size_t collider) const;
  /// Of the surface, or of the scene where the surface has none. @throws InvalidInput
  double celsius(const std::string& name) const;

  /// For a particle that conducts.
  WallContact<Real> at(const Vec3<Real>& point) const;
  /// Number of a collider colder than `celsius` that a particle at a point touches, or kNone.
  Index colderThan(double celsius, const Vec3<Real>& point) const;
  /// For a puff of steam: surfaces with a temperature that it touches; `length_m` counts them.
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
