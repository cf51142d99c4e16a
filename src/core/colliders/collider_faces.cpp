#include "colliders/collider_faces.h"

namespace ice_ice_baby {

namespace {

/// Pose with the rotation normalised in double precision, so that its axes are exact directions.
template <class Real>
Posed exact(const Pose<Real>& pose) {
  Posed in_double = pose.template cast<double>();
  in_double.rotation = Eigen::Quaterniond(in_double.rotation).normalized().toRotationMatrix();
  return in_double;
}

}  // namespace

template <class Real>
void ColliderFaces::take(const Colliders<Real>& colliders) {
  all_.clear();
  for (const MovingShape<Real>& collider : colliders) {
    const Motion<Real>& motion = collider.motion;
    const bool moves =
        motion.from.position != motion.to.position || motion.from.rotation != motion.to.rotation;
    all_.push_back({{exact(motion.from), exact(motion.to)},
                    double(collider.friction),
                    moves,
                    collider.shape.template cast<double>()});
  }
}

bool ColliderFaces::near(std::size_t k, const Vec3d& from, const Vec3d& to, double radius_m) const {
  const Entry& entry = all_[k];
  return !entry.shape.clear(entry.motion.from.toLocal(from), entry.motion.to.toLocal(to), radius_m);
}

Vec3d ColliderFaces::push(std::size_t k, const Vec3d& from, const Vec3d& to) const {
  const Entry& entry = all_[k];
  const Vec3d wanted = entry.motion.to.toLocal(to);
  const Vec3d end = entry.shape.resolve(entry.motion.from.toLocal(from), wanted);
  return entry.motion.to.rotation * (end - wanted);
}

std::size_t ColliderFaces::find(std::size_t k, const Vec3d& from, const Vec3d& to, double margin_m,
                                std::array<Face, 6>& faces) const {
  const Entry& entry = all_[k];
  PushedPath path{entry.motion.from.toLocal(from), entry.motion.to.toLocal(to), Vec3d::Zero()};
  path.push = entry.shape.resolve(path.from, path.to) - path.to;
  FaceCollector collector(entry.motion, path, margin_m, faces);
  entry.shape.faces(path, collector);
  return collector.count();
}

template void ColliderFaces::take(const Colliders<float>&);
template void ColliderFaces::take(const Colliders<double>&);

}  // namespace ice_ice_baby
