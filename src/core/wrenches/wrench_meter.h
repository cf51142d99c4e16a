// Measures what water and ice do to each collider. Exists only while somebody asks for it.
//
// All that the particles gain in a substep beyond their weight came from colliders, so the sum over
// all colliders is exact. The stages that move particles away from walls say which collider gave
// how much; the little that they leave open is shared out in proportion to what each has got.
#pragma once

#include <vector>

#include "colliders/wall_load.h"
#include "fluid/fluid.h"
#include "ice/ice_contacts.h"
#include "ice_ice_baby/collider_wrench.h"
#include "particles/particles.h"
#include "wrenches/impulse.h"

namespace ice_ice_baby {

template <class Real>
class WrenchMeter {
 public:
  /// @param colliders must outlive it, like phases
  /// @param phases what is steam, which has no weight here, or null
  WrenchMeter(const Scene& scene, const Colliders<Real>& colliders, const Phases<Real>* phases);

  // Within a substep, in this order.

  /// @param bodies or null
  void begin(const Particles<Real>& particles, const IceBodies<Real>* bodies);
  /// What the coarse level did.
  void addCoarse(const Fluid<Real>& fluid, const Particles<Real>& particles, Real dt);
  /// What the density of walls did in an iteration. Call it before x* changes.
  void addWalls(const Fluid<Real>& fluid, const VectorField<Real>& predicted);
  /// (n) how far the collision response moves each particle, to be filled in.
  VectorField<Real>& pushes(std::size_t particles);
  /// What these did. @param predicted (n) positions to which they apply
  void addPushes(const VectorField<Real>& predicted);
  /// What contacts of ice did. @param contacts, bodies null without ice
  void addIce(const IceContacts<Real>* contacts, const IceBodies<Real>* bodies,
              const Vec3d& gravity_m_s2, double dt_s);
  void end(const Particles<Real>& particles, const IceBodies<Real>* bodies,
           const Vec3d& gravity_m_s2, double dt_s);

  /// The next substep does not start from corrections of the latest one.
  void forget();

  /// Passes time in which nothing moves and the wrenches stay what they were.
  void rest(double time_s);

  /// Starts a new mean.
  void restart();
  /// One per collider, in their order: the mean since the start.
  std::vector<ColliderWrench> mean() const;

 private:
  bool counts(std::size_t i) const { return !phases_ || !(phases_->steam(i) || phases_->solid(i)); }
  Impulse momentumOf(const Particles<Real>& particles, const IceBodies<Real>* bodies) const;
  Impulse weightOf(const Particles<Real>& particles, const IceBodies<Real>* bodies,
                   const Vec3d& gravity_m_s2) const;
  void add(const WallLoad<Real>& load);
  Index pushing(const Vec3<Real>& point, const Vec3<Real>& push) const;
  void shareOut(const Impulse& rest);

  const Colliders<Real>& colliders_;
  const Phases<Real>* phases_;
  double mass_kg_;     ///< of a particle
  double warm_start_;  ///< share of the corrections of a substep that the next one starts with
  Real reach_m_;       ///< a particle this close to a wall may have been pushed by it
  Impulse before_;     ///< momenta at the start of the substep
  std::vector<Impulse> known_;   ///< (colliders) of this substep, times dt
  std::vector<Impulse> walls_;   ///< (colliders) part of the density of walls in it, times dt
  std::vector<Impulse> given_;   ///< (colliders) since the start, in their own frames
  std::vector<Impulse> latest_;  ///< (colliders) mean force of the latest substep, own frames
  double time_s_ = 0.0;          ///< since the start
  VectorField<Real> pushes_;
  std::vector<WallLoad<Real>> loads_;
};

}  // namespace ice_ice_baby
