#include "colliders/colliders.h"

#include <algorithm>
#include <cmath>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

/// Difference between poses, in m and of rotations, up to which colliders move as one body.
constexpr double kTogether = 1e-6;

template <class Real>
Motion<Real> standing(const Posed& pose) {
  return {pose.cast<Real>(), pose.cast<Real>()};
}

}  // namespace

/// Later lists push first, so that containers take precedence.
template <class Real>
Colliders<Real>::Colliders(const Scene& scene, double radius_m)
    : radius_m_(static_cast<Real>(radius_m)) {
  forEachColliderList(scene, [&](const auto& list, const ColliderKind&) {
    std::vector<Index> order;
    for (const auto& item : list) {
      order.push_back(static_cast<Index>(all_.size()));
      const Posed pose = item.pose();
      all_.push_back({item.name, Shape<Real>(makeShape<Real>(item, radius_m)), standing<Real>(pose),
                      static_cast<Real>(item.friction), pose.cast<Real>()});
      travels_.push_back({item.name, pose, pose});
    }
    push_order_.insert(push_order_.begin(), order.begin(), order.end());
  });
}

template <class Real>
bool Colliders<Real>::anyHollow() const {
  return std::any_of(begin(), end(), [](const auto& c) { return c.shape.hollow(); });
}

template <class Real>
bool Colliders<Real>::anyFlat() const {
  return std::any_of(begin(), end(), [](const auto& c) { return c.shape.flat(); });
}

template <class Real>
bool Colliders<Real>::hidden(const Vec3<Real>& point, const Vec3<Real>& place) const {
  const Real slack = Real(1e-3) * radius_m_;
  return std::any_of(begin(), end(), [&](const MovingShape<Real>& collider) {
    if (!collider.shape.hollow()) return false;
    const Pose<Real>& pose = collider.motion.to;
    return collider.shape.hides(pose.toLocal(point), pose.toLocal(place), slack);
  });
}

template <class Real>
void Colliders<Real>::setSubstep(double begin, double end) {
  for (std::size_t k = 0; k < all_.size(); ++k) {
    const Travel& travel = travels_[k];
    Motion<Real>& motion = all_[k].motion;
    motion.from = between(travel.start, travel.target, begin).template cast<Real>();
    motion.to = between(travel.start, travel.target, end).template cast<Real>();
  }
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
Jump<Real> Colliders<Real>::place(const std::string& name, const Posed& pose) {
  Travel& travel = const_cast<Travel&>(this->travel(name));
  const std::size_t number = static_cast<std::size_t>(&travel - travels_.data());
  const Jump<Real> jump{number, {travel.start.template cast<Real>(), pose.cast<Real>()}};
  travel.start = travel.target = pose;
  all_[number].motion = standing<Real>(pose);
  return jump;
}

/// Whether two colliders move as parts of one rigid body.
template <class Real>
bool Colliders<Real>::together(const Travel& a, const Travel& b) {
  const Mat3<double> rotation = a.target.rotation * a.start.rotation.transpose();
  if (!(rotation * b.start.rotation).isApprox(b.target.rotation, kTogether)) return false;
  const Vec3d end = a.target.toWorld(a.start.toLocal(b.start.position));
  return (end - b.target.position).norm() <= kTogether;
}

template <class Real>
std::vector<Jump<Real>> Colliders<Real>::jump(double max_m, double reach_m) {
  std::vector<std::size_t> fast;
  for (std::size_t k = 0; k < travels_.size(); ++k) {
    const Travel& travel = travels_[k];
    const Eigen::AngleAxisd rotation(travel.start.rotation.transpose() * travel.target.rotation);
    const double far = (travel.target.position - travel.start.position).norm() +
                       std::abs(rotation.angle()) * all_[k].shape.turningRadius(reach_m);
    if (far > max_m) fast.push_back(k);
  }
  std::vector<Jump<Real>> jumps;
  for (std::size_t k = 0; k < travels_.size() && !fast.empty(); ++k) {
    const Travel& travel = travels_[k];
    const bool jumps_too = std::any_of(fast.begin(), fast.end(), [&](std::size_t other) {
      return k == other || together(travels_[other], travel);
    });
    if (!jumps_too) continue;
    jumps.push_back({k, {travel.start.template cast<Real>(), travel.target.template cast<Real>()}});
  }
  for (const Jump<Real>& jump : jumps) travels_[jump.number].start = travels_[jump.number].target;
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
  return all_.capacity() * sizeof(MovingShape<Real>) + push_order_.capacity() * sizeof(Index) +
         travels_.capacity() * sizeof(Travel);
}

template class Colliders<float>;
template class Colliders<double>;

}  // namespace ice_ice_baby
