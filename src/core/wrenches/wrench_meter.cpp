#include "wrenches/wrench_meter.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace ice_ice_baby {

namespace {

/// Forces whose squares along an axis sum to less than this share of all lie across it.
constexpr double kAcross = 0.05;

}  // namespace

template <class Real>
WrenchMeter<Real>::WrenchMeter(const Scene& scene, const Colliders<Real>& colliders,
                               const Phases<Real>* phases)
    : colliders_(colliders),
      phases_(phases),
      mass_kg_(particleMass_kg(scene.fluid, scene.supportRadius_m())),
      warm_start_(scene.solver.warm_start),
      reach_m_(static_cast<Real>(scene.fluid.spacing_m)) {
  for (auto* list : {&known_, &walls_, &given_, &latest_}) list->resize(colliders.count());
}

/// Summed in order, in double precision.
template <class Real>
Impulse WrenchMeter<Real>::momentumOf(const Particles<Real>& particles,
                                      const IceBodies<Real>* bodies) const {
  Impulse sum;
  for (std::size_t i = 0; i < particles.owned(); ++i) {
    if (!counts(i)) continue;
    sum.add(particles.position.at(i).template cast<double>(),
            particles.velocity.at(i).template cast<double>());
  }
  Impulse all = sum * mass_kg_;
  if (bodies) {
    bodies->forEachSolid([&](const IceBody& body) {
      all.add(body.pose.centre_m, body.mass_kg * body.velocity_m_s);
      all.angular += body.angular_momentum;
    });
  }
  return all;
}

template <class Real>
Impulse WrenchMeter<Real>::weightOf(const Particles<Real>& particles, const IceBodies<Real>* bodies,
                                    const Vec3d& gravity_m_s2) const {
  Vec3d centre = Vec3d::Zero();
  std::size_t count = 0;
  for (std::size_t i = 0; i < particles.owned(); ++i) {
    if (!counts(i)) continue;
    centre += particles.position.at(i).template cast<double>();
    ++count;
  }
  Impulse weight = Impulse{double(count) * gravity_m_s2, centre.cross(gravity_m_s2)} * mass_kg_;
  if (bodies) {
    bodies->forEachSolid(
        [&](const IceBody& body) { weight.add(body.pose.centre_m, body.mass_kg * gravity_m_s2); });
  }
  return weight;
}

template <class Real>
void WrenchMeter<Real>::begin(const Particles<Real>& particles, const IceBodies<Real>* bodies) {
  before_ = momentumOf(particles, bodies);
  for (std::size_t c = 0; c < known_.size(); ++c) {
    // The warm start repeats a share of the corrections.
    walls_[c] = walls_[c] * warm_start_;
    known_[c] = walls_[c];
  }
}

template <class Real>
void WrenchMeter<Real>::add(const WallLoad<Real>& load) {
  known_[load.collider].add(load.point.template cast<double>(),
                            mass_kg_ * load.push.template cast<double>());
}

template <class Real>
void WrenchMeter<Real>::addCoarse(const Fluid<Real>& fluid, const Particles<Real>& particles,
                                  Real dt) {
  loads_.clear();
  fluid.coarseLoads(particles, dt, loads_);
  for (const WallLoad<Real>& load : loads_) add(load);
}

template <class Real>
void WrenchMeter<Real>::addWalls(const Fluid<Real>& fluid, const VectorField<Real>& predicted) {
  fluid.forEachWallCorrection(
      predicted, [&](std::size_t i, std::size_t collider, const Vec3<Real>& correction) {
        const Vec3d push = -mass_kg_ * correction.template cast<double>();
        const Vec3d point = predicted.at(i).template cast<double>();
        known_[collider].add(point, push);
        walls_[collider].add(point, push);
      });
}

template <class Real>
VectorField<Real>& WrenchMeter<Real>::pushes(std::size_t particles) {
  pushes_.resize(particles);
  for (auto* axis : {&pushes_.x, &pushes_.y, &pushes_.z}) {
    std::fill(axis->begin(), axis->end(), Real(0));
  }
  return pushes_;
}

template <class Real>
void WrenchMeter<Real>::addPushes(const VectorField<Real>& predicted) {
  for (std::size_t i = 0; i < pushes_.size(); ++i) {
    const Vec3<Real> push = pushes_.at(i);
    if (push.isZero(0)) continue;
    const Vec3<Real> end = predicted.at(i);
    const Index collider = pushing(end, push);
    if (collider != kNone) add({collider, end, -push});
  }
}

/// The collider with a surface near a point whose normal is closest to the direction of a push.
template <class Real>
Index WrenchMeter<Real>::pushing(const Vec3<Real>& point, const Vec3<Real>& push) const {
  Index best = kNone;
  Real most = 0;
  for (std::size_t c = 0; c < colliders_.count(); ++c) {
    const Pose<Real>& pose = colliders_[c].motion.to;
    for (const NearSurface<Real>& surface :
         colliders_[c].shape.near(pose.toLocal(point), reach_m_)) {
      const Real along = (pose.rotation * surface.normal).dot(push);
      if (along <= most) continue;
      most = along;
      best = Index(c);
    }
  }
  return best;
}

/// The anchor of a body carries it whatever the body does.
template <class Real>
void WrenchMeter<Real>::addIce(const IceContacts<Real>* contacts, const IceBodies<Real>* bodies,
                               const Vec3d& gravity_m_s2, double dt_s) {
  if (!contacts || !bodies) return;
  contacts->forEachWallImpulse([&](Index collider, const Vec3d& point, const Vec3d& impulse) {
    known_[collider].add(point, -dt_s * impulse);
  });
  for (Index b = 0; b < bodies->count(); ++b) {
    const IceBody& body = bodies->body(b);
    if (body.anchor == kNone) continue;
    known_[body.anchor].add(body.pose.centre_m, dt_s * dt_s * body.mass_kg * gravity_m_s2);
  }
}

/// Closes the balance: what the particles gained beyond their weight, the colliders lost.
template <class Real>
void WrenchMeter<Real>::end(const Particles<Real>& particles, const IceBodies<Real>* bodies,
                            const Vec3d& gravity_m_s2, double dt_s) {
  Impulse rest = weightOf(particles, bodies, gravity_m_s2) * dt_s;
  rest += before_;
  rest -= momentumOf(particles, bodies);
  for (Impulse& known : known_) {
    known = known * (1 / dt_s);
    rest -= known;
  }
  shareOut(rest);
  for (std::size_t c = 0; c < known_.size(); ++c) {
    const Posed pose = colliders_[c].motion.to.template cast<double>();
    const Impulse& world = known_[c];
    const Mat3<double> turned = pose.rotation.transpose();
    const Impulse own{turned * world.linear,
                      turned * (world.angular - pose.position.cross(world.linear))};
    given_[c] += own;
    latest_[c] = own * (1 / dt_s);
  }
  time_s_ += dt_s;
}

/// Changes the forces as little as possible, each along its own direction, so that they add up;
/// what lies across all of them is shared out in proportion.
template <class Real>
void WrenchMeter<Real>::shareOut(const Impulse& rest) {
  Mat3<double> forces = Mat3<double>::Zero();
  double sum = 0.0;
  for (const Impulse& known : known_) {
    forces += known.linear * known.linear.transpose();
    sum += known.linear.norm();
  }
  if (sum == 0.0) return;
  const Eigen::SelfAdjointEigenSolver<Mat3<double>> axes(forces);
  Vec3d along = Vec3d::Zero();
  for (int k = 0; k < 3; ++k) {
    if (axes.eigenvalues()[k] < kAcross * forces.trace()) continue;
    const Vec3d axis = axes.eigenvectors().col(k);
    along += axis * (axis.dot(rest.linear) / axes.eigenvalues()[k]);
  }
  Impulse open = rest;
  sum = 0.0;
  for (Impulse& known : known_) {
    const Impulse change = known * known.linear.dot(along);
    open -= change;
    known += change;
    sum += known.linear.norm();
  }
  if (sum == 0.0) return;
  for (Impulse& known : known_) known += open * (known.linear.norm() / sum);
}

template <class Real>
void WrenchMeter<Real>::forget() {
  std::fill(walls_.begin(), walls_.end(), Impulse());
}

template <class Real>
void WrenchMeter<Real>::rest(double time_s) {
  for (std::size_t c = 0; c < given_.size(); ++c) given_[c] += latest_[c] * time_s;
  time_s_ += time_s;
}

template <class Real>
void WrenchMeter<Real>::restart() {
  std::fill(given_.begin(), given_.end(), Impulse());
  time_s_ = 0.0;
}

template <class Real>
std::vector<ColliderWrench> WrenchMeter<Real>::mean() const {
  std::vector<ColliderWrench> wrenches;
  const double share = time_s_ > 0 ? 1 / time_s_ : 0.0;
  for (std::size_t c = 0; c < given_.size(); ++c) {
    const Impulse mean = given_[c] * share;
    wrenches.push_back({colliders_[c].name, mean.linear, mean.angular});
  }
  return wrenches;
}

template class WrenchMeter<float>;
template class WrenchMeter<double>;

}  // namespace ice_ice_baby
