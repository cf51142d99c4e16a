#include "ice_ice_baby/colliders.h"

#include <algorithm>
#include <cmath>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

template <class Real>
Motion<Real> standing(const Posed& pose) {
  return {pose.cast<Real>(), pose.cast<Real>()};
}

template <class Real>
ContainerShape<Real> makeShape(const Container& c, double radius) {
  const Vec3d half(c.size_m.x() / 2, c.size_m.y() / 2, 0.0);
  const Vec3d high(half.x(), half.y(), c.size_m.z());
  const Vec3d r = Vec3d::Constant(radius);
  const Vec3d wall = Vec3d::Constant(c.wall_m);
  ContainerShape<Real> shape;
  // A box narrower than a particle keeps its middle plane.
  shape.inner.low = (-half + r).cwiseMin((high - half) / 2).cast<Real>();
  shape.inner.high = (high - r).cwiseMax((high - half) / 2).cast<Real>();
  shape.outer.low = (-half - wall - r).cast<Real>();
  shape.outer.high = (high + wall + r).cast<Real>();
  shape.open_top = c.open_top;
  if (c.open_top) {
    shape.inner.high.z() = static_cast<Real>(high.z());
    shape.outer.high.z() = static_cast<Real>(high.z());
  }
  shape.middle = {(shape.inner.low + shape.outer.low) / 2,
                  (shape.inner.high + shape.outer.high) / 2};
  return shape;
}

template <class Real>
PlaneShape<Real> makeShape(const Plane& p, double radius) {
  PlaneShape<Real> shape;
  shape.surface = static_cast<Real>(radius);
  shape.infinite = p.infinite();
  const Vec3d half(p.size_x_m / 2 + radius, p.size_y_m / 2 + radius, 0.0);
  shape.plate.low = Vec3d(-half.x(), -half.y(), -p.thickness_m - radius).cast<Real>();
  shape.plate.high = Vec3d(half.x(), half.y(), radius).cast<Real>();
  return shape;
}

template <class Real>
SphereShape<Real> makeShape(const Sphere& s, double radius) {
  return {static_cast<Real>(s.radius_m + radius)};
}

/// Nearest allowed end of a path, with the tangential part of its motion reduced by friction.
template <class Real, class Shape>
Vec3<Real> contact(const Body<Real, Shape>& body, const Vec3<Real>& from, const Vec3<Real>& to,
                   bool stick) {
  const Vec3<Real> start = body.motion.from.toLocal(from);
  const Vec3<Real> wanted = body.motion.to.toLocal(to);
  Vec3<Real> allowed = body.shape.resolve(start, wanted);
  const Vec3<Real> push = allowed - wanted;
  const Real depth = push.norm();
  if (depth == 0) return to;
  const Vec3<Real> normal = push / depth;
  const Vec3<Real> motion = allowed - start;
  const Vec3<Real> sliding = motion - motion.dot(normal) * normal;
  const Real slid = sliding.norm();
  const Real held = stick ? slid : std::min(slid, body.friction * depth);
  if (held > 0) allowed = body.shape.resolve(start, allowed - sliding * (held / slid));
  return body.motion.to.toWorld(allowed);
}

template <class Real>
Posed between(const Posed& a, const Posed& b, double fraction) {
  const Eigen::Quaterniond qa(a.rotation), qb(b.rotation);
  Posed pose;
  pose.position = a.position + fraction * (b.position - a.position);
  pose.rotation = qa.slerp(fraction, qb).toRotationMatrix();
  return pose;
}

}  // namespace

template <class Real>
Colliders<Real>::Colliders(const Scene& scene, double radius_m)
    : settled2_(static_cast<Real>(1e-8 * radius_m * radius_m)) {
  const auto add = [&](auto& bodies, const auto& items) {
    for (const auto& item : items) {
      const Posed pose = item.pose();
      bodies.push_back({item.name, makeShape<Real>(item, radius_m), standing<Real>(pose),
                        static_cast<Real>(item.friction)});
      travels_.push_back({item.name, pose, pose});
    }
  };
  add(containers, scene.containers);
  add(planes, scene.planes);
  add(spheres, scene.spheres);
}

template <class Real>
Vec3<Real> Colliders<Real>::respond(const Vec3<Real>& from, const Vec3<Real>& to,
                                    bool stick) const {
  Vec3<Real> end = to;
  // A later collider may push into an earlier one: in a wedge each pass halves what is left.
  constexpr int kMaxPasses = 16;
  const bool one = containers.size() + planes.size() + spheres.size() == 1;
  for (int pass = 0; pass < (one ? 1 : kMaxPasses); ++pass) {
    const Vec3<Real> before = end;
    for (const auto& body : spheres) end = contact(body, from, end, stick);
    for (const auto& body : planes) end = contact(body, from, end, stick);
    for (const auto& body : containers) end = contact(body, from, end, stick);
    if ((end - before).squaredNorm() <= settled2_) break;
  }
  return end;
}

template <class Real>
template <class Visit>
void Colliders<Real>::forEachMotion(Visit&& visit) {
  std::size_t k = 0;
  for (auto& body : containers) visit(body.motion, travels_[k++]);
  for (auto& body : planes) visit(body.motion, travels_[k++]);
  for (auto& body : spheres) visit(body.motion, travels_[k++]);
}

template <class Real>
void Colliders<Real>::setSubstep(double begin, double end) {
  forEachMotion([&](Motion<Real>& motion, const Travel& travel) {
    motion.from = between<Real>(travel.start, travel.target, begin).template cast<Real>();
    motion.to = between<Real>(travel.start, travel.target, end).template cast<Real>();
  });
}

template <class Real>
const typename Colliders<Real>::Travel& Colliders<Real>::travel(const std::string& name) const {
  std::vector<std::string> names;
  for (const Travel& travel : travels_) {
    if (travel.name == name) return travel;
    names.push_back(travel.name);
  }
  throw InvalidInput("no collider \"" + shortened(name) + "\"; the scene has: " + joined(names));
}

template <class Real>
void Colliders<Real>::moveTo(const std::string& name, const Posed& pose) {
  const_cast<Travel&>(travel(name)).target = pose;
}

template <class Real>
void Colliders<Real>::endFrame() {
  for (Travel& travel : travels_) travel.start = travel.target;
}

template <class Real>
Posed Colliders<Real>::pose(const std::string& name) const {
  return travel(name).start;
}

template <class Real>
std::size_t Colliders<Real>::bytes() const {
  return containers.capacity() * sizeof(containers[0]) + planes.capacity() * sizeof(planes[0]) +
         spheres.capacity() * sizeof(spheres[0]) + travels_.capacity() * sizeof(Travel);
}

template class Colliders<float>;
template class Colliders<double>;

}  // namespace ice_ice_baby
