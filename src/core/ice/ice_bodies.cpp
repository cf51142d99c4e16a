#include "ice/ice_bodies.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "particles/kernels.h"

namespace ice_ice_baby {

namespace {

Placement placementOf(const Posed& pose) {
  return {pose.position, Eigen::Quaterniond(pose.rotation)};
}

}  // namespace

template <class Real>
IceBodies<Real>::IceBodies(const Scene& scene)
    : particle_kg_(particleMass_kg(scene.fluid, scene.supportRadius_m())),
      radius_m_(scene.fluid.spacing_m / 2),
      sleep_speed_m_s_(scene.ice.sleep_speed_m_s),
      max_speed_m_s_(scene.solver.max_speed_m_s) {
  for (const Solid& solid : scene.solids) solids_.push_back(massOf(solid));
}

template <class Real>
void IceBodies<Real>::reorder(const std::vector<Index>& order) {
  if (bodies_.empty()) return member_at_.clear();
  if (member_at_.size() < order.size()) member_at_.resize(order.size(), kNone);
  old_member_at_.swap(member_at_);
  member_at_.resize(order.size());
  parallelFor(order.size(), [&](std::size_t k) {
    const Index member = old_member_at_[order[k]];
    member_at_[k] = member;
    if (member != kNone) place_[member] = static_cast<Index>(k);
  });
}

template <class Real>
template <class Visit>
void IceBodies<Real>::forEachChunk(const Visit& visit) const {
  const std::size_t batches = batches_.empty() ? 0 : batches_.size() - 1;
  parallelForRanges(
      batches,
      [&](std::size_t first, std::size_t last) {
        for (Index c = batches_[first]; c < batches_[last]; ++c) visit(c, chunks_[c]);
      },
      1);
}

/// Slows a body above the speed limit or one that would rotate too far. A body with momenta that
/// are not finite is stopped.
template <class Real>
void IceBodies<Real>::limit(IceBody& body) {
  const Vec3d angular_velocity = body.angularVelocityAt(body.pose.rotation_matrix);
  const double fastest = body.velocity_m_s.norm() + angular_velocity.norm() * body.radius_m;
  const double angle = angular_velocity.norm() * dt_s_;
  bool limited = !std::isfinite(fastest);
  if (limited) body.stop();
  if (fastest > max_speed_m_s_) {
    body.velocity_m_s *= max_speed_m_s_ / fastest;
    body.angular_momentum *= max_speed_m_s_ / fastest;
    limited = true;
  }
  if (angle > kMaxRotation_rad) {
    body.angular_momentum *= kMaxRotation_rad / angle;
    // A single particle's rotation has no visible effect, so it is not counted.
    limited = limited || body.count() > 1;
  }
  if (limited) limited_.fetch_add(1, std::memory_order_relaxed);
}

/// Pose given by the collider that carries a body.
template <class Real>
Placement IceBodies<Real>::held(const IceBody& body, const Colliders<Real>& colliders) const {
  const Placement carrier = placementOf(colliders[body.anchor].motion.to.template cast<double>());
  return {carrier.at(body.hold.centre_m), carrier.rotation * body.hold.rotation};
}

/// Moves a body with what carries it.
template <class Real>
void IceBodies<Real>::follow(IceBody& body, const Placement& to) const {
  body.moveTo(to);
  body.velocity_m_s = (body.next.centre_m - body.pose.centre_m) / dt_s_;
  const Eigen::AngleAxisd rotation(body.next.rotation * body.pose.rotation.conjugate());
  const Vec3d angular_velocity = rotation.axis() * (rotation.angle() / dt_s_);
  body.angular_momentum =
      body.next.rotation_matrix *
      (body.inertia * (body.next.rotation_matrix.transpose() * angular_velocity));
}

template <class Real>
void IceBodies<Real>::fly(IceBody& body) {
  body.velocity_m_s += dt_s_ * gravity_m_s2_;
  limit(body);
  body.moveTo(body.flight(dt_s_));
}

template <class Real>
void IceBodies<Real>::predict(Particles<Real>& particles, const Colliders<Real>& colliders,
                              const Vec3d& gravity_m_s2, double dt_s) {
  dt_s_ = dt_s;
  gravity_m_s2_ = gravity_m_s2;
  parallelFor(bodies_.size(), [&](std::size_t b) {
    IceBody& body = bodies_[b];
    if (body.gripped) {
      follow(body, gripped(body));
    } else if (body.anchor != kNone) {
      follow(body, held(body, colliders));
    } else if (body.asleep) {
      body.moveTo(body.pose);
    } else {
      fly(body);
    }
  });
  writePredicted(particles.predicted);
}

template <class Real>
void IceBodies<Real>::writePredicted(VectorField<Real>& predicted, bool all) const {
  forEachChunk([&](Index, const Chunk& chunk) {
    const IceBody& body = bodies_[chunk.body];
    if (!all && body.held()) return;
    for (Index m = chunk.first; m < chunk.last; ++m) {
      predicted.set(place_[m], body.next.at(offset_[m]).template cast<Real>());
    }
  });
}

/// Sums difference(member, arm), in m or m/s, over every chunk, in the order of the members.
template <class Real>
template <class Difference>
void IceBodies<Real>::sumMoments(const Difference& difference) {
  moments_.resize(chunks_.size());
  forEachChunk([&](Index c, const Chunk& chunk) {
    const IceBody& body = bodies_[chunk.body];
    Moment moment{Vec3d::Zero(), Vec3d::Zero()};
    for (Index m = chunk.first; m < chunk.last; ++m) {
      const Vec3d arm = body.next.rotation_matrix * offset_[m];
      const Vec3d by = difference(body, m, arm);
      moment.sum += by;
      moment.torque += arm.cross(by);
    }
    moments_[c] = moment;
  });
}

template <class Real>
void IceBodies<Real>::conform(VectorField<Real>& predicted) {
  sumMoments([&](const IceBody& body, Index m, const Vec3d& arm) {
    // Relative to the rounded pose, so that unmoved members add nothing.
    const Vec3<Real> rigid = (body.next.centre_m + arm).template cast<Real>();
    return (predicted.at(place_[m]) - rigid).template cast<double>().eval();
  });
  for (std::size_t c = 0; c < chunks_.size();) {
    IceBody& body = bodies_[chunks_[c].body];
    Moment moment = moments_[c];
    for (++c; c < chunks_.size() && chunks_[c].first < body.last; ++c) {
      moment.sum += moments_[c].sum;
      moment.torque += moments_[c].torque;
    }
    if (body.held() || (moment.sum.isZero(0) && moment.torque.isZero(0))) continue;
    body.push(moment.sum / body.mass_particles, body.mobility_now * (particle_kg_ * moment.torque),
              dt_s_);
  }
  writePredicted(predicted);
}

template <class Real>
void IceBodies<Real>::finish(Particles<Real>& particles) {
  parallelFor(bodies_.size(), [&](std::size_t b) {
    IceBody& body = bodies_[b];
    body.pose = body.next;
    if (!body.held()) limit(body);
    body.speed_m_s = body.fastest_m_s();
  });
  forEachChunk([&](Index, const Chunk& chunk) {
    const IceBody& body = bodies_[chunk.body];
    const Vec3d angular_velocity = body.angularVelocity();
    for (Index m = chunk.first; m < chunk.last; ++m) {
      const Vec3d arm = body.next.rotation_matrix * offset_[m];
      const Vec3<Real> x = (body.next.centre_m + arm).template cast<Real>();
      particles.predicted.set(place_[m], x);
      particles.position.set(place_[m], x);
      particles.velocity.set(
          place_[m], (body.velocity_m_s + angular_velocity.cross(arm)).template cast<Real>());
    }
  });
}

template <class Real>
void IceBodies<Real>::takeVelocities(Particles<Real>& particles) {
  const auto rigid = [](const IceBody& body, const Vec3d& angular_velocity, const Vec3d& arm) {
    return (body.velocity_m_s + angular_velocity.cross(arm)).template cast<Real>().eval();
  };
  sumMoments([&](const IceBody& body, Index m, const Vec3d& arm) {
    const Vec3<Real> change =
        particles.velocity.at(place_[m]) - rigid(body, body.angularVelocity(), arm);
    return change.template cast<double>().eval();
  });
  for (std::size_t c = 0; c < chunks_.size(); ++c) {
    IceBody& body = bodies_[chunks_[c].body];
    if (body.held()) continue;
    body.velocity_m_s += moments_[c].sum / body.mass_particles;
    body.angular_momentum += particle_kg_ * moments_[c].torque;
  }
  forEachChunk([&](Index, const Chunk& chunk) {
    const IceBody& body = bodies_[chunk.body];
    const Vec3d angular_velocity = body.angularVelocity();
    for (Index m = chunk.first; m < chunk.last; ++m) {
      particles.velocity.set(place_[m],
                             rigid(body, angular_velocity, body.next.rotation_matrix * offset_[m]));
    }
  });
}

template <class Real>
void IceBodies<Real>::carry(const std::vector<Jump<Real>>& jumps,
                            const Colliders<Real>& colliders) {
  for (IceBody& body : bodies_) {
    for (const Jump<Real>& jump : jumps) {
      const Placement from = placementOf(jump.motion.from.template cast<double>());
      const Placement to = placementOf(jump.motion.to.template cast<double>());
      const Vec3d local = from.rotation_matrix.transpose() * (body.pose.centre_m - from.centre_m);
      const bool within =
          body.anchor == kNone && colliders[jump.number].shape.holds(local.cast<Real>());
      if (!within && body.anchor != jump.number) continue;
      const Eigen::Quaterniond rotation = to.rotation * from.rotation.conjugate();
      body.moveTo(within ? Placement(to.at(local), rotation * body.pose.rotation)
                         : held(body, colliders));
      body.pose = body.next;
      body.velocity_m_s = rotation * body.velocity_m_s;
      body.angular_momentum = rotation * body.angular_momentum;
      break;
    }
  }
}

template <class Real>
void IceBodies<Real>::anchor(Index b, Index collider, const Colliders<Real>& colliders) {
  IceBody& body = bodies_[b];
  if (body.anchor == collider) return;
  const Placement carrier = placementOf(colliders[collider].motion.to.template cast<double>());
  const Eigen::Quaterniond back = carrier.rotation.conjugate();
  body.hold = {back * (body.pose.centre_m - carrier.centre_m), back * body.pose.rotation};
  body.anchor = collider;
  body.asleep = false;
}

template class IceBodies<float>;
template class IceBodies<double>;

}  // namespace ice_ice_baby
