#include "fluid/boundary_density.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ice_ice_baby {

namespace {

/// Fraction of the surface of a sphere of radius r inside a ball whose centre is at `distance`.
double shareInside(double r, double distance, double ball) {
  const double cosine = (distance * distance + r * r - ball * ball) / (2 * distance * r);
  return 0.5 * (1 - std::clamp(cosine, -1.0, 1.0));
}

/// Integral of the kernel over a ball, over the distance from its surface.
template <class Real>
DistanceTable<Real> ballTable(const WallKernel& kernel, double ball_m) {
  constexpr int kShells = 400;
  const double step = kernel.reach_m() / kShells;
  return DistanceTable<Real>(kernel.reach_m(), [&](double distance) {
    double sum = 0.0;
    for (int k = 0; k < kShells; ++k) {
      const double r = step * (k + 0.5);
      sum += 4 * M_PI * r * r * kernel.value(r) * shareInside(r, distance + ball_m, ball_m) * step;
    }
    return sum;
  });
}

}  // namespace

template <class Real>
BoundaryDensity<Real>::BoundaryDensity(const Scene& scene, const Colliders<Real>& colliders,
                                       double volume_m3)
    : colliders_(colliders),
      support_(static_cast<Real>(scene.supportRadius_m())),
      radius_(static_cast<Real>(scene.fluid.spacing_m / 2)) {
  sortColliders();
  buildTables(RestLattice(scene, volume_m3));
}

template <class Real>
void BoundaryDensity<Real>::buildTables(const RestLattice& lattice) {
  const auto half_space = [&](double distance) { return lattice.behind({distance, 0, 0}, 1); };
  flat_ = std::make_unique<DistanceTable<Real>>(lattice.support_m(), half_space);
  if (colliders_.anyHollow()) container_.emplace(lattice, *flat_, radius_);
  std::optional<WallKernel> kernel;
  const auto wallKernel = [&]() -> const WallKernel& {
    if (!kernel) kernel.emplace(half_space, lattice.support_m());
    return *kernel;
  };
  for (const MovingShape<Real>& collider : colliders_) {
    if (collider.shape.box() && !box_) box_.emplace(wallKernel());
    table_of_.push_back(0);
    if (const Surface* surface = collider.shape.triangleSurface()) {
      table_of_.back() = triangles_.size();
      triangles_.push_back(
          {surface, SurfaceDensity<Real>::shared(*surface, wallKernel(), 2 * double(radius_))});
    }
    if (collider.shape.flat()) continue;
    const Real radius = collider.shape.curvatureRadius();
    const auto same = std::find_if(balls_.begin(), balls_.end(),
                                   [&](const Ball& ball) { return ball.radius == radius; });
    table_of_.back() = std::size_t(same - balls_.begin());
    if (same == balls_.end()) {
      balls_.push_back({radius, ballTable<Real>(wallKernel(), double(radius))});
    }
  }
  if (colliders_.count() > 1) overlap_.emplace(wallKernel());
}

/// What two solids share is taken off the later one, so containers and grounds come before plates,
/// boxes and spheres.
template <class Real>
void BoundaryDensity<Real>::sortColliders() {
  const auto rank = [&](std::size_t k) {
    const Shape<Real>& shape = colliders_[k].shape;
    return shape.hollow() ? 0 : shape.triangleSurface() ? 3 : shape.flat() && !shape.box() ? 1 : 2;
  };
  order_.resize(colliders_.count());
  std::iota(order_.begin(), order_.end(), std::size_t(0));
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
}

/// Most particles are near one collider at most, and then nothing is shared.
template <class Real>
WallSample<Real> BoundaryDensity<Real>::at(const Vec3<Real>& point) const {
  const std::size_t none = order_.size();
  std::size_t first = none;
  bool several = false;
  for (std::size_t n = 0; n < none && !several; ++n) {
    if (!isNear(order_[n], point)) continue;
    several = first != none;
    if (!several) first = n;
  }
  if (first == none) return {};
  SeenSolids<Real> seen;
  seen.alone = !several;
  if (seen.alone) return of(order_[first], point, seen);
  WallSample<Real> sum;
  for (std::size_t n = first; n < none; ++n) {
    const WallSample<Real> one = of(order_[n], point, seen);
    sum.value += one.value;
    sum.gradient += one.gradient;
  }
  return sum;
}

template <class Real>
bool BoundaryDensity<Real>::isNear(std::size_t collider, const Vec3<Real>& point) const {
  const Vec3<Real> local = colliders_[collider].motion.to.toLocal(point);
  return !colliders_[collider].shape.clear(local, local, support_ - radius_);
}

template <class Real>
WallSample<Real> BoundaryDensity<Real>::of(std::size_t collider, const Vec3<Real>& point,
                                           SeenSolids<Real>& seen) const {
  const Shape<Real>& shape = colliders_[collider].shape;
  return shape.hollow()            ? ofContainer(collider, point, seen)
         : shape.box()             ? ofBox(collider, point, seen)
         : shape.triangleSurface() ? ofTriangles(collider, point, seen)
                                   : ofSurface(collider, point, seen);
}

template <class Real>
WallSample<Real> BoundaryDensity<Real>::ofContainer(std::size_t collider, const Vec3<Real>& point,
                                                    SeenSolids<Real>& seen) const {
  const Shape<Real>& shape = colliders_[collider].shape;
  const Pose<Real>& pose = colliders_[collider].motion.to;
  const Vec3<Real> local = pose.toLocal(point);
  const auto rim = shape.rim(local, support_);
  const NearSurfaces<Real> near = shape.near(rim ? rim->below : local, support_);
  WallSample<Real> sample = container_->at(local, rim, near);
  sample.gradient = pose.rotation * sample.gradient;
  if (seen.alone || sample.value == 0) return sample;
  for (const NearSurface<Real>& wall : near) {
    SolidFace<Real> face{wall.gap + radius_, pose.rotation * wall.normal};
    face.flat = true;
    if (rim && wall.axis != 2) {
      const auto [share, slope] = container_->shareBelow(*rim);
      face.share = share;
      face.share_gradient = slope * pose.rotation.col(2);
    } else if (rim) {
      face.distance += local.z() - rim->below.z();
    }
    seen.faces.add(face);
  }
  return sample;
}

/// Of a plane or a ball.
template <class Real>
WallSample<Real> BoundaryDensity<Real>::ofSurface(std::size_t collider, const Vec3<Real>& point,
                                                  SeenSolids<Real>& seen) const {
  const Shape<Real>& shape = colliders_[collider].shape;
  const Pose<Real>& pose = colliders_[collider].motion.to;
  const NearSurfaces<Real> near = shape.near(pose.toLocal(point), support_);
  if (near.count == 0) return {};
  const NearSurface<Real>& surface = *near.begin();
  SolidFace<Real> face{surface.gap + radius_, pose.rotation * surface.normal};
  face.flat = shape.flat();
  const auto [value, slope] =
      (face.flat ? *flat_ : balls_[table_of_[collider]].table).at(face.distance);
  WallSample<Real> sample{value, slope * face.normal};
  if (seen.alone || value == 0) return sample;
  if (!face.flat) {
    const Real from_centre = std::max(shape.curvatureRadius() + face.distance, radius_);
    face.turning = (Mat3<Real>::Identity() - face.normal * face.normal.transpose()) / from_centre;
    setShare(sample, face);
  }
  for (const SolidFace<Real>& other : seen.faces) takeOff(other, face, *overlap_, *flat_, sample);
  seen.faces.add(face);
  return sample;
}

template <class Real>
WallSample<Real> BoundaryDensity<Real>::ofTriangles(std::size_t collider, const Vec3<Real>& point,
                                                    SeenSolids<Real>& seen) const {
  const Pose<Real>& pose = colliders_[collider].motion.to;
  const Vec3<Real> local = pose.toLocal(point);
  const Triangles& triangles = triangles_[table_of_[collider]];
  WallSample<Real> sample = triangles.density->at(local);
  if (sample.value == 0) return sample;
  sample.gradient = pose.rotation * sample.gradient;
  if (seen.alone) return sample;
  const Vec3d x = local.template cast<double>();
  const SurfacePoint near = triangles.surface->closest(x, double(support_));
  if (!near.found() || near.distance_m == 0.0) return sample;
  SolidFace<Real> face = faceOf(near, x, pose);
  setShare(sample, face);
  for (const SolidFace<Real>& other : seen.faces) takeOff(other, face, *overlap_, *flat_, sample);
  seen.faces.add(face);
  return sample;
}

/// The plane through the closest point of a surface.
template <class Real>
SolidFace<Real> BoundaryDensity<Real>::faceOf(const SurfacePoint& near, const Vec3d& point,
                                              const Pose<Real>& pose) const {
  const Vec3d normal = (point - near.point) / near.distance_m;
  Mat3<double> turning = Mat3<double>::Zero();
  if (near.part != TrianglePart::kFace) {
    const Vec3d along = near.part == TrianglePart::kEdge ? near.along.normalized() : Vec3d::Zero();
    turning = (Mat3<double>::Identity() - normal * normal.transpose() - along * along.transpose()) /
              std::max(near.distance_m, double(radius_));
  }
  return {static_cast<Real>(near.distance_m), pose.rotation * normal.cast<Real>(),
          pose.rotation * turning.cast<Real>() * pose.rotation.transpose()};
}

template <class Real>
void BoundaryDensity<Real>::setShare(const WallSample<Real>& sample, SolidFace<Real>& face) const {
  const auto [whole, slope] = flat_->at(face.distance);
  if (!(whole > 0)) return;
  const Real share = sample.value / whole;
  if (share >= 1) return;  // rounding: a convex solid lies within its half space
  face.share = std::max(share, Real(0));
  if (share > 0) face.share_gradient = (sample.gradient - share * slope * face.normal) / whole;
}

template <class Real>
std::size_t BoundaryDensity<Real>::bytes() const {
  std::size_t total =
      flat_->bytes() + (order_.capacity() + table_of_.capacity()) * sizeof(std::size_t);
  if (container_) total += container_->bytes();
  if (box_) total += box_->bytes();
  if (overlap_) total += overlap_->bytes();
  for (const Triangles& one : triangles_) total += one.density->bytes();
  for (const Ball& ball : balls_) total += ball.table.bytes();
  return total;
}

template class BoundaryDensity<float>;
template class BoundaryDensity<double>;

}  // namespace ice_ice_baby
