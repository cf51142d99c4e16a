// Containers, planes and spheres as the solver sees them: where a moving particle may go.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/scene.h"

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

/// Box in its own frame, centred on x and y.
template <class Real>
struct BoxShape {
  Vec3<Real> low;
  Vec3<Real> high;

  bool holds(const Vec3<Real>& point) const {
    return (point.array() > low.array()).all() && (point.array() < high.array()).all();
  }
};

/// Container in its own frame: floor of the inner box at z = 0, rim at inner.high.z.
/// `inner` is shrunk and `outer` grown by the particle radius, so both bound particle centres.
/// `middle` runs within the walls: on which side of it a centre lies tells on which side of the
/// wall it belongs, also when rounding has put it a hair into the wall.
template <class Real>
struct ContainerShape {
  BoxShape<Real> inner;
  BoxShape<Real> outer;
  BoxShape<Real> middle;
  bool open_top;

  /// Nearest allowed end of a path from `from` to `to`: what was inside stays inside unless it
  /// passes the open mouth, what was outside stays outside unless it enters by the mouth.
  Vec3<Real> resolve(const Vec3<Real>& from, const Vec3<Real>& to) const;
  bool inside(const Vec3<Real>& point) const { return middle.holds(point); }
  /// Whether a point within an open container's wall is nearer to its rim than to its sides.
  bool onRim(const Vec3<Real>& point) const;
};

/// Ground below z = 0, or a plate; bounds particle centres like ContainerShape.
template <class Real>
struct PlaneShape {
  Real surface;
  bool infinite;
  BoxShape<Real> plate;

  Vec3<Real> resolve(const Vec3<Real>& from, const Vec3<Real>& to) const;
};

/// Ball around the origin; `reach` is its radius plus that of a particle.
template <class Real>
struct SphereShape {
  Real reach;

  Vec3<Real> resolve(const Vec3<Real>& from, const Vec3<Real>& to) const;
};

/// A collider that is somewhere else at once.
template <class Real>
struct Jump {
  std::size_t number;  ///< in the order containers, planes, spheres
  Motion<Real> motion;
};

/// A shape with what contact needs to know of it.
template <class Real, class Shape>
struct Body {
  std::string name;
  Shape shape;
  Motion<Real> motion;
  Real friction;
};

template <class Real>
class Colliders {
 public:
  /// @param radius_m particle radius, half the spacing: the distance that centres keep
  Colliders(const Scene& scene, double radius_m);

  bool empty() const { return count() == 0; }
  std::size_t count() const { return containers.size() + planes.size() + spheres.size(); }

  /// Where a particle that starts a substep at `from` ends when the solver wants it at `to`:
  /// outside every solid, its sliding reduced by Coulomb friction. In a gap too narrow for it a
  /// particle stays where it was, or goes to the nearest free place when a collider moved in on it.
  /// Where there is none at all the containers have the last word.
  /// @param stick whether it does not slide
  Vec3<Real> respond(const Vec3<Real>& from, const Vec3<Real>& to, bool stick) const;

  /// Poses at the start and the end of the substep that comes next.
  /// @param begin, end fractions of the frame
  void setSubstep(double begin, double end);

  /// Moves a collider over the frame that comes next. @throws InvalidInput for an unknown name
  void moveTo(const std::string& name, const Posed& pose);
  /// Colliders of which a point would go further than `most_m` over the frame do not sweep through
  /// what lies between: they are where they were going before it begins.
  /// @param reach_m how far from its origin a point of an infinite plane matters
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
    for (auto& body : self.containers) archive(body.motion);
    for (auto& body : self.planes) archive(body.motion);
    for (auto& body : self.spheres) archive(body.motion);
  }
  /// @throws InvalidInput when what was read is nowhere that a collider may be
  void settle() const;

  std::vector<Body<Real, ContainerShape<Real>>> containers;
  std::vector<Body<Real, PlaneShape<Real>>> planes;
  std::vector<Body<Real, SphereShape<Real>>> spheres;

 private:
  /// Where a collider goes over a frame, in the order containers, planes, spheres.
  struct Travel {
    std::string name;
    Posed start;
    Posed target;
  };

  template <class Push>
  Real pushAll(Vec3<Real>& end, const Push& push) const;
  bool cutsSphere(const Vec3<Real>& from, const Vec3<Real>& to) const;
  template <class Push>
  bool settleBy(const Push& push, Vec3<Real>& end) const;
  bool settle(const Vec3<Real>& from, Vec3<Real>& end) const;
  bool settleRound(const Vec3<Real>& from, Vec3<Real>& end) const;
  Vec3<Real> nearestFree(const Vec3<Real>& from, const Vec3<Real>& end) const;
  double reachOf(std::size_t number, double reach_m) const;
  const Travel& travel(const std::string& name) const;
  template <class Visit>
  void forEachMotion(Visit&& visit);

  std::vector<Travel> travels_;
  Real radius_m_;
};

}  // namespace ice_ice_baby
