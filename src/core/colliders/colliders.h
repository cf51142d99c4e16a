// The colliders of a scene for the solver: where a moving particle may go.
#pragma once

#include <string>
#include <vector>

#include "colliders/motion.h"
#include "colliders/shape.h"
#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// A collider that jumps to another pose instead of sweeping there.
template <class Real>
struct Jump {
  std::size_t number;  ///< index of the collider
  Motion<Real> motion;
};

/// A shape with the data needed for contact.
template <class Real>
struct MovingShape {
  std::string name;
  Shape<Real> shape;
  Motion<Real> motion;
  Real friction;
  Pose<Real> placed;  ///< pose in the scene file
};

/// Colliders are indexed in the order of forEachCollider.
template <class Real>
class Colliders {
 public:
  /// @param radius_m particle radius, half the spacing: minimum distance of particle centres
  Colliders(const Scene& scene, double radius_m);

  bool empty() const { return all_.empty(); }
  std::size_t count() const { return all_.size(); }
  const MovingShape<Real>& operator[](std::size_t number) const { return all_[number]; }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  /// Whether any of them can hold water.
  bool anyHollow() const;
  /// Whether any of them is flat.
  bool anyFlat() const;

  /// End position of a particle that starts a substep at `from` and that the solver moves to `to`:
  /// outside every solid, with sliding reduced by Coulomb friction. In a gap that is too narrow the
  /// particle stays where it was, or moves to the nearest free position if a collider moved into
  /// it. If there is none, containers take precedence.
  /// @param stick whether the particle must not slide
  Vec3<Real> respond(const Vec3<Real>& from, const Vec3<Real>& to, bool stick) const;

  /// Whether `place` lies behind a wall of the collider that contains the point: a ground just
  /// below a container must not heat water in addition to its floor.
  bool hidden(const Vec3<Real>& point, const Vec3<Real>& place) const;

  /// Sets the poses at the start and the end of the next substep.
  /// @param begin, end fractions of the frame
  void setSubstep(double begin, double end);

  /// Moves a collider to a pose over the next frame. @throws InvalidInput for an unknown name
  void moveTo(const std::string& name, const Posed& pose);
  /// Puts a collider at a pose at once; a motion over the next frame is dropped.
  /// @throws InvalidInput for an unknown name
  Jump<Real> place(const std::string& name, const Posed& pose);
  /// Colliders with a point that would move farther than `max_m` in the frame do not sweep: they
  /// jump to their target pose before the frame starts, together with all that move as one body
  /// with them: water that a box takes along must not pass the wall of a cup in it that sweeps.
  /// @param reach_m distance from the origin up to which an infinite collider matters
  /// @return one entry per collider that jumped, with its poses before and after
  std::vector<Jump<Real>> jump(double max_m, double reach_m);
  /// Ends the frame: every collider is at its target pose.
  void endFrame();
  Posed pose(const std::string& name) const;
  Posed pose(std::size_t number) const { return travels_[number].start; }

  std::size_t bytes() const;

  /// Lists present and target poses; everything else follows from the scene.
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    for (auto& travel : self.travels_) archive(travel.start, travel.target);
    for (auto& collider : self.all_) archive(collider.motion);
  }
  /// @throws InvalidInput if a pose from a checkpoint is out of range
  void restore() const;

 private:
  /// Motion of a collider over a frame.
  struct Travel {
    std::string name;
    Posed start;
    Posed target;
  };

  static bool together(const Travel& a, const Travel& b);
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
