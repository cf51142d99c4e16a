// The colliders of a scene as the solver sees them: where a moving particle may go.
#pragma once

#include <string>
#include <vector>

#include "colliders/motion.h"
#include "colliders/shape.h"
#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// A collider that is somewhere else at once.
template <class Real>
struct Jump {
  std::size_t number;  ///< of the collider
  Motion<Real> motion;
};

/// A shape with what contact needs to know of it.
template <class Real>
struct MovingShape {
  std::string name;
  Shape<Real> shape;
  Motion<Real> motion;
  Real friction;
  Pose<Real> placed;  ///< where the scene has it
};

/// Colliders are numbered in the order of forEachCollider.
template <class Real>
class Colliders {
 public:
  /// @param radius_m particle radius, half the spacing: the distance that centres keep
  Colliders(const Scene& scene, double radius_m);

  bool empty() const { return all_.empty(); }
  std::size_t count() const { return all_.size(); }
  const MovingShape<Real>& operator[](std::size_t number) const { return all_[number]; }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  /// Whether any of them holds water.
  bool anyHollow() const;
  /// Whether any of them is flat.
  bool anyFlat() const;

  /// Where a particle that starts a substep at `from` ends when the solver wants it at `to`:
  /// outside every solid, its sliding reduced by Coulomb friction. In a gap too narrow for it a
  /// particle stays where it was, or goes to the nearest free place when a collider moved in on it.
  /// Where there is none at all the containers have the last word.
  /// @param stick whether it does not slide
  Vec3<Real> respond(const Vec3<Real>& from, const Vec3<Real>& to, bool stick) const;

  /// Whether a place lies behind a wall of the collider that holds the point: a ground just under a
  /// container must not count on top of its floor.
  /// @param flush whether that also holds for what lies flush with the wall
  bool hidden(const Vec3<Real>& point, const Vec3<Real>& place, bool flush) const;

  /// Poses at the start and the end of the substep that comes next.
  /// @param begin, end fractions of the frame
  void setSubstep(double begin, double end);

  /// Moves a collider over the frame that comes next. @throws InvalidInput for an unknown name
  void moveTo(const std::string& name, const Posed& pose);
  /// Colliders of which a point would go further than `most_m` over the frame do not sweep through
  /// what lies between: they are where they were going before it begins.
  /// @param reach_m how far from its origin a point of an infinite collider matters
  /// @return one entry each, with its pose before and now
  std::vector<Jump<Real>> jump(double most_m, double reach_m);
  /// Ends the frame: every collider is where it was going.
  void endFrame();
  Posed pose(const std::string& name) const;

  std::size_t bytes() const;

  /// Where each of them is and where it goes; what they are is the scene's.
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    for (auto& travel : self.travels_) archive(travel.start, travel.target);
    for (auto& collider : self.all_) archive(collider.motion);
  }
  /// @throws InvalidInput when what was read is nowhere that a collider may be
  void restore() const;

 private:
  /// Where a collider goes over a frame.
  struct Travel {
    std::string name;
    Posed start;
    Posed target;
  };

  template <class Push>
  Real pushAll(Vec3<Real>& end, const Push& push) const;
  bool cutsRound(const Vec3<Real>& from, const Vec3<Real>& to) const;
  template <class Push>
  bool pushFree(const Push& push, Vec3<Real>& end) const;
  bool slideFree(const Vec3<Real>& from, Vec3<Real>& end) const;
  bool slideFreeAnyWay(const Vec3<Real>& from, Vec3<Real>& end) const;
  Vec3<Real> nearestFree(const Vec3<Real>& from, const Vec3<Real>& end) const;
  const Travel& travel(const std::string& name) const;

  std::vector<MovingShape<Real>> all_;
  std::vector<Index> push_order_;
  std::vector<Travel> travels_;
  Real radius_m_;
};

}  // namespace ice_ice_baby
