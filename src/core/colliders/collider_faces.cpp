#include "colliders/collider_faces.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

BoxShape<double> inDouble(const BoxShape<double>& box) { return box; }
BoxShape<double> inDouble(const BoxShape<float>& box) {
  return {box.low.cast<double>(), box.high.cast<double>()};
}

template <class Real>
ContainerShape<double> inDouble(const ContainerShape<Real>& shape) {
  return {inDouble(shape.inner), inDouble(shape.outer), inDouble(shape.middle), shape.open_top};
}
template <class Real>
PlaneShape<double> inDouble(const PlaneShape<Real>& shape) {
  return {double(shape.surface), shape.infinite, inDouble(shape.plate)};
}
template <class Real>
SphereShape<double> inDouble(const SphereShape<Real>& shape) {
  return {double(shape.reach)};
}

/// Pose with a rotation that is one to the last bit, as forces along its axes are to be.
template <class Real>
Posed exact(const Pose<Real>& pose) {
  Posed in_double = pose.template cast<double>();
  in_double.rotation = Eigen::Quaterniond(in_double.rotation).normalized().toRotationMatrix();
  return in_double;
}

/// Whether a ball that goes from `from` to `to` stays within a box, or beyond one of its sides.
bool within(const BoxShape<double>& box, const Vec3d& from, const Vec3d& to, double radius) {
  const Vec3d r = Vec3d::Constant(radius);
  const BoxShape<double> inner{box.low + r, box.high - r};
  return inner.holds(from) && inner.holds(to);
}

bool beyond(const BoxShape<double>& box, const Vec3d& from, const Vec3d& to, double radius) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::max(from[axis], to[axis]) < box.low[axis] - radius) return true;
    if (std::min(from[axis], to[axis]) > box.high[axis] + radius) return true;
  }
  return false;
}

/// Whether points within `radius` of a path may come near a shape.
bool comesNear(const ContainerShape<double>& shape, const Vec3d& from, const Vec3d& to,
               double radius) {
  return !within(shape.inner, from, to, radius) && !beyond(shape.outer, from, to, radius);
}
bool comesNear(const PlaneShape<double>& shape, const Vec3d& from, const Vec3d& to, double radius) {
  if (!shape.infinite) return !beyond(shape.plate, from, to, radius);
  return std::min(from.z(), to.z()) < shape.surface + radius;
}
bool comesNear(const SphereShape<double>& shape, const Vec3d& from, const Vec3d& to,
               double radius) {
  return std::min(from.norm(), to.norm()) < shape.reach + radius + (to - from).norm();
}

/// Collects faces of one collider in its own frame and hands them out in the scene's.
class Collector {
 public:
  Collector(const Motion<double>& motion, const Vec3d& from, const Vec3d& to, double margin_m,
            std::array<Face, 6>& faces)
      : motion_(motion), from_(from), to_(to), margin_(margin_m), faces_(faces) {}

  void add(const Vec3d& normal, double height, Index number) {
    const double gap = normal.dot(to_) - height;
    if (gap >= margin_) return;
    const Vec3d point = to_ - gap * normal;
    faces_[count_++] = {motion_.to.rotation * normal, motion_.to.toWorld(point), gap,
                        normal.dot(from_) - height, number};
  }
  void addAxis(int axis, double value, bool upwards) {
    const double sign = upwards ? 1.0 : -1.0;
    add(sign * Vec3d::Unit(axis), sign * value, Index(2 * axis + (upwards ? 0 : 1)));
  }
  /// Faces by which a box pushed, axis by axis.
  void addPush(const Vec3d& push) {
    for (int axis = 0; axis < 3; ++axis) {
      if (push[axis] != 0) addAxis(axis, to_[axis] + push[axis], push[axis] > 0);
    }
  }
  /// The face of a solid box that a point outside it is above. Beside an edge there is none: a
  /// plane would stop there what only passes by.
  void addFaceBelow(const BoxShape<double>& box) {
    int separated = 0, axis = 0;
    bool upwards = true;
    for (int k = 0; k < 3; ++k) {
      if (to_[k] > box.low[k] && to_[k] < box.high[k]) continue;
      ++separated;
      axis = k;
      upwards = to_[k] >= box.high[k];
    }
    if (separated == 1) addAxis(axis, upwards ? box.high[axis] : box.low[axis], upwards);
  }
  std::size_t count() const { return count_; }

 private:
  const Motion<double>& motion_;
  const Vec3d& from_;
  const Vec3d& to_;
  double margin_;
  std::array<Face, 6>& faces_;
  std::size_t count_ = 0;
};

void findFaces(const ContainerShape<double>& shape, const Vec3d& from, const Vec3d& to,
               const Vec3d& push, Collector& faces) {
  if (!shape.middle.holds(from)) {
    faces.addPush(push);
    if (push.isZero(0)) faces.addFaceBelow(shape.outer);
    return;
  }
  // What passes the open mouth is beside no wall any more, unless it was pushed back.
  if (shape.open_top && to.z() > shape.inner.high.z() && push.isZero(0)) return;
  for (int axis = 0; axis < 3; ++axis) {
    faces.addAxis(axis, shape.inner.low[axis], true);
    if (axis < 2 || !shape.open_top) faces.addAxis(axis, shape.inner.high[axis], false);
  }
}

void findFaces(const PlaneShape<double>& shape, const Vec3d&, const Vec3d&, const Vec3d& push,
               Collector& faces) {
  if (shape.infinite) {
    faces.addAxis(2, shape.surface, true);
    return;
  }
  faces.addPush(push);
  if (push.isZero(0)) faces.addFaceBelow(shape.plate);
}

void findFaces(const SphereShape<double>& shape, const Vec3d&, const Vec3d& to, const Vec3d& push,
               Collector& faces) {
  const double distance = to.norm();
  if (!push.isZero(0)) {
    const Vec3d normal = push.normalized();
    faces.add(normal, normal.dot(to + push), 0);
  } else if (distance > 0) {
    faces.add(to / distance, shape.reach, 0);
  }
}

}  // namespace

template <class Real>
const Motion<Real>& motionOf(const Colliders<Real>& colliders, std::size_t number) {
  if (number < colliders.containers.size()) return colliders.containers[number].motion;
  number -= colliders.containers.size();
  if (number < colliders.planes.size()) return colliders.planes[number].motion;
  return colliders.spheres[number - colliders.planes.size()].motion;
}

template <class Real>
void ColliderFaces::take(const Colliders<Real>& colliders) {
  all_.clear();
  const auto add = [&](const auto& bodies) {
    for (const auto& body : bodies) {
      const Motion<Real>& motion = body.motion;
      const bool moves =
          motion.from.position != motion.to.position || motion.from.rotation != motion.to.rotation;
      all_.push_back({{exact(motion.from), exact(motion.to)},
                      double(body.friction),
                      moves,
                      inDouble(body.shape)});
    }
  };
  add(colliders.containers);
  add(colliders.planes);
  add(colliders.spheres);
}

bool ColliderFaces::near(std::size_t k, const Vec3d& from, const Vec3d& to, double radius_m) const {
  const Entry& entry = all_[k];
  const Vec3d a = entry.motion.from.toLocal(from), b = entry.motion.to.toLocal(to);
  return std::visit([&](const auto& shape) { return comesNear(shape, a, b, radius_m); },
                    entry.shape);
}

Vec3d ColliderFaces::push(std::size_t k, const Vec3d& from, const Vec3d& to) const {
  const Entry& entry = all_[k];
  const Vec3d a = entry.motion.from.toLocal(from), b = entry.motion.to.toLocal(to);
  const Vec3d end = std::visit([&](const auto& shape) { return shape.resolve(a, b); }, entry.shape);
  return entry.motion.to.rotation * (end - b);
}

std::size_t ColliderFaces::find(std::size_t k, const Vec3d& from, const Vec3d& to, double margin_m,
                                std::array<Face, 6>& faces) const {
  const Entry& entry = all_[k];
  const Vec3d a = entry.motion.from.toLocal(from), b = entry.motion.to.toLocal(to);
  Collector collector(entry.motion, a, b, margin_m, faces);
  std::visit(
      [&](const auto& shape) {
        const Vec3d push = shape.resolve(a, b) - b;
        findFaces(shape, a, b, push, collector);
      },
      entry.shape);
  return collector.count();
}

template const Motion<float>& motionOf(const Colliders<float>&, std::size_t);
template const Motion<double>& motionOf(const Colliders<double>&, std::size_t);
template void ColliderFaces::take(const Colliders<float>&);
template void ColliderFaces::take(const Colliders<double>&);

}  // namespace ice_ice_baby
