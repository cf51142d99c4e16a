#include "colliders/colliders.h"

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
    : radius_m_(static_cast<Real>(radius_m)) {
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

/// How far from its origin a point of a collider can be that a turn moves and anybody notices.
template <class Real>
double Colliders<Real>::reachOf(std::size_t number, double reach_m) const {
  if (number < containers.size()) {
    const BoxShape<Real>& box = containers[number].shape.outer;
    return double(box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).norm());
  }
  number -= containers.size();
  if (number >= planes.size()) return 0.0;
  const PlaneShape<Real>& shape = planes[number].shape;
  if (shape.infinite) return reach_m;
  return double(shape.plate.low.cwiseAbs().cwiseMax(shape.plate.high.cwiseAbs()).norm());
}

template <class Real>
std::vector<Jump<Real>> Colliders<Real>::jump(double most_m, double reach_m) {
  std::vector<Jump<Real>> jumps;
  for (std::size_t k = 0; k < travels_.size(); ++k) {
    Travel& travel = travels_[k];
    const Eigen::AngleAxisd turn(travel.start.rotation.transpose() * travel.target.rotation);
    const double far = (travel.target.position - travel.start.position).norm() +
                       std::abs(turn.angle()) * reachOf(k, reach_m);
    if (far <= most_m) continue;
    jumps.push_back({k, {travel.start.template cast<Real>(), travel.target.template cast<Real>()}});
    travel.start = travel.target;
  }
  if (!jumps.empty()) setSubstep(0.0, 0.0);
  return jumps;
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
