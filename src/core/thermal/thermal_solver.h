// Heat transfer: conduction between particles, walls, air, heated regions and steam.
//
// m dH_i/dt = sum_j L_ij (P_j - P_i) + walls + air + regions, with the specific enthalpy H and the
// conduction potential P(T) of EnthalpyCurve and the lengths L_ij of ConductionLattice. The usual
// mean of two conductivities (Cleary & Monaghan 1999) is meant for two materials; at a freezing
// front it slows the front by 4 %. Thermal time runs `thermal.speedup` times as fast as simulated
// time, with forward Euler steps so short that no temperature leaves the range of its neighbours
// and surfaces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fluid/boundary_density.h"
#include "phase/enthalpy_curve.h"
#include "thermal/conductances.h"
#include "thermal/heated_regions.h"
#include "thermal/scene_regions.h"

namespace ice_ice_baby {

/// Enthalpies are doubles in both precisions, and pairs exchange exactly opposite amounts. Without
/// walls, air and regions the total enthalpy is conserved to rounding of doubles.
template <class Real>
class ThermalSolver {
 public:
  /// Maximum number of steps per frame; a higher speed-up is not reached.
  static constexpr int kMaxPasses = 200;

  /// Without particles. @param scene, colliders must outlive it
  ThermalSolver(const Scene& scene, const Colliders<Real>& colliders);
  ThermalSolver(const ThermalSolver&) = delete;
  ThermalSolver& operator=(const ThermalSolver&) = delete;

  /// Advances the enthalpies by a period of simulated time at fixed positions.
  /// @param neighbours lists with every pair closer than the support radius
  void advance(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
               const ThermalStep<Real>& step);

  /// Appends particles of one temperature.
  void add(std::size_t count, double celsius);

  /// Puts particle order[k] at place k, as Particles::reorder does.
  void reorder(const std::vector<Index>& order);

  /// As ThermalBoundaries::set. @throws InvalidInput for an unknown name
  void setWall(const std::string& name, double celsius, double ramp_s) {
    walls_.set(name, celsius, ramp_s);
  }
  /// As ThermalBoundaries::colderThan.
  Index wallColderThan(double celsius, const Vec3<Real>& point) const {
    return walls_.colderThan(celsius, point);
  }

  void addRegion(const HeatedRegion& region) { regions_.add(region); }
  /// Number of active regions.
  std::size_t regions() const { return regions_.size(); }
  /// The heat regions of the scene; null if it has none.
  SceneRegions* sceneRegions() { return scene_regions_ ? &*scene_regions_ : nullptr; }
  const SceneRegions* sceneRegions() const { return scene_regions_ ? &*scene_regions_ : nullptr; }

  const EnthalpyCurve& curve() const { return curve_; }
  /// (n) J/kg
  const std::vector<double>& enthalpy() const { return enthalpy_; }
  double temperature(std::size_t i) const { return curve_.temperature(enthalpy_[i]); }
  double iceFraction(std::size_t i) const { return curve_.iceFraction(enthalpy_[i]); }

  /// Sum over the particles in their order, J.
  double totalEnthalpy_j() const;
  /// What walls, air and regions have put into these particles since they came, J;
  /// totalEnthalpy_j less this stays.
  double heatIn_j() const;

  /// Passes of the latest advance, and its thermal time per simulated time, which is below
  /// thermal.speedup if the passes did not suffice.
  int passes() const { return passes_; }
  /// Longest stable pass of the latest advance, s of thermal time; 0 before it.
  double passLength_s() const { return longest_pass_s_; }
  double reachedSpeedup() const { return reached_speedup_; }

  std::size_t bytes() const;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.enthalpy_, self.received_, self.walls_, self.regions_, self.passes_,
            self.longest_pass_s_, self.reached_speedup_);
    if (self.scene_regions_) archive(*self.scene_regions_);
  }
  /// @throws InvalidInput when what was read is not that of `particles` particles of this scene
  void restore(std::size_t particles, const Scene& scene) const;

 private:
  void measure(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
               const ThermalStep<Real>& step);
  void meetWalls(const VectorField<Real>& x, std::size_t first, std::size_t last,
                 const ThermalStep<Real>& step);
  void scaleBareArea();
  Real bareArea_m2(const Vec3<Real>& open_m2, Real links_m) const;
  double airTransfer_w_m2k(double conductivity_w_mk) const;
  Real relaxation_kg_s(std::size_t i, Real links_m) const;
  double findLongestPass_s() const;
  void readCurve(std::size_t i);
  void sumRate(std::size_t i, const Neighbours<Real>& neighbours);
  double fromSurfaces_w(std::size_t i, double air_c) const;
  double gainOfSteam_j_kg(std::size_t i, double air_c, double pass_s) const;
  void apply(std::size_t i, const ThermalStep<Real>& step, double pass_s);
  void resize(std::size_t n);

  ThermalParams params_;
  EnthalpyCurve curve_;
  ConductionLattice lattice_;
  ThermalBoundaries<Real> walls_;
  Conductances<Real> links_;
  HeatedRegions regions_;
  std::optional<SceneRegions> scene_regions_;  ///< if the scene has any
  const Colliders<Real>& colliders_;
  std::optional<BoundaryDensity<Real>> cover_;  ///< covers particles at walls from the air
  double steam_w_k_;                            ///< between a steam particle and the air
  double touch_w_k_;                            ///< between it and a wall
  Real noise_m2_ = 0;                           ///< exposed area below this counts as zero
  Real bare_scale_ = 1;
  Real drop_links_m_ = 0;  ///< total link length below which a particle is a drop
  Real drop_m2_ = 0;       ///< surface of a drop of one particle, m^2
  int passes_ = 0;
  double longest_pass_s_ = 0.0;
  double reached_speedup_ = 0.0;

  std::vector<double> enthalpy_;            ///< (n) J/kg
  std::vector<double> received_;            ///< (n) J/kg received from outside
  std::vector<double> rate_;                ///< (n) W from neighbours; scratch of reorder
  std::vector<Real> potential_;             ///< (n) P, W/m
  std::vector<WallContact<Real>> contact_;  ///< (n)
  std::vector<Real> power_w_;               ///< (n) from regions and walls with a flux
  std::vector<Real> bare_m2_;               ///< (n) area exposed to the air
  std::vector<Real> relaxation_;  ///< (n) relaxation_kg_s; before that the total link length, m
  VectorField<Real> open_m2_;     ///< (n) exposed area as a vector pointing inwards
};

}  // namespace ice_ice_baby
