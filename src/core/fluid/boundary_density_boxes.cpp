// Density of plates and boxes, less what they share with other solids.
#include <algorithm>

#include "fluid/boundary_density.h"

namespace ice_ice_baby {

template <class Real>
WallSample<Real> BoundaryDensity<Real>::ofBox(std::size_t collider, const Vec3<Real>& point,
                                              SeenSolids<Real>& seen) const {
  const Pose<Real>& pose = colliders_[collider].motion.to;
  const Vec3<Real> local = pose.toLocal(point);
  const AlignedBox<Real> solid = *colliders_[collider].shape.box();
  SolidBox<Real> box{{solid.low - local, solid.high - local}, pose.rotation, seen.faces.count()};
  std::array<bool, SeenSolids<Real>::kMaxFaces> counted{};
  WallSample<Real> sample = cutBox(seen, box, counted);
  if (sample.value == 0) return {};
  BoxList commons;
  for (const SolidBox<Real>& other : seen.boxes) {
    AlignedBox<Real> common;
    if (!commonPart(other, box, common)) continue;
    counted[other.face] = true;
    commons.add(common);
  }
  const WallSample<Real> shared = ofAny(commons, 0, box.box);
  sample.value -= shared.value;
  sample.gradient -= shared.gradient;
  sample.gradient = pose.rotation * sample.gradient;
  if (seen.alone) return sample;
  SolidFace<Real> face = faceOf(box);
  setShare(sample, face);
  std::size_t k = 0;
  for (const SolidFace<Real>& other : seen.faces) {
    if (!counted[k++]) takeOff(other, face, *overlap_, *flat_, sample);
  }
  if (seen.faces.count() < counted.size()) seen.boxes.add(box);
  seen.faces.add(face);
  return sample;
}

/// Of what lies in a box and in any of the others from `first` on, by inclusion and exclusion.
template <class Real>
WallSample<Real> BoundaryDensity<Real>::ofAny(const BoxList& others, std::size_t first,
                                              const AlignedBox<Real>& box) const {
  WallSample<Real> sum;
  for (std::size_t k = first; k < others.count(); ++k) {
    const AlignedBox<Real>& other = others.begin()[k];
    const AlignedBox<Real> both{box.low.cwiseMax(other.low), box.high.cwiseMin(other.high)};
    if ((both.low.array() >= both.high.array()).any()) continue;
    const WallSample<Real> one = box_->at(both), again = ofAny(others, k + 1, both);
    sum.value += one.value - again.value;
    sum.gradient += one.gradient - again.gradient;
  }
  return sum;
}

/// Cuts off what lies behind flat faces parallel to its sides. Walls that end at a rim cut by their
/// share.
template <class Real>
template <class Marks>
WallSample<Real> BoundaryDensity<Real>::cutBox(const SeenSolids<Real>& seen, SolidBox<Real>& box,
                                               Marks& counted) const {
  const SolidFace<Real>* rim = nullptr;
  std::size_t k = 0;
  for (const SolidFace<Real>& face : seen.faces) {
    if (face.share == 1) counted[k] = cutBehind(face, box);
    ++k;
  }
  SolidBox<Real> below = box;
  k = 0;
  for (const SolidFace<Real>& face : seen.faces) {
    if (face.share < 1 && cutBehind(face, below)) {
      counted[k] = true;
      rim = &face;
    }
    ++k;
  }
  WallSample<Real> sample = box_->at(box.box);
  if (!rim) return sample;
  const WallSample<Real> cut = box_->at(below.box);
  sample.gradient += rim->share * (cut.gradient - sample.gradient) +
                     (cut.value - sample.value) * (box.axes.transpose() * rim->share_gradient);
  sample.value += rim->share * (cut.value - sample.value);
  return sample;
}

/// The plane through the closest point of a box.
template <class Real>
SolidFace<Real> BoundaryDensity<Real>::faceOf(const SolidBox<Real>& box) const {
  const Vec3<Real> closest = Vec3<Real>::Zero().cwiseMax(box.box.low).cwiseMin(box.box.high);
  const Real distance = closest.norm();
  if (distance > 0) {
    const Vec3<Real> normal = -closest / distance;
    const Vec3<Real> beyond = (closest.array() != 0).template cast<Real>();
    const Mat3<Real> turning = (Mat3<Real>(beyond.asDiagonal()) - normal * normal.transpose()) /
                               std::max(distance, radius_);
    return {distance, box.axes * normal, box.axes * turning * box.axes.transpose()};
  }
  int axis;
  const Vec3<Real> depth = (-box.box.low).cwiseMin(box.box.high);
  depth.minCoeff(&axis);
  const Real side = -box.box.low[axis] > depth[axis] ? Real(1) : Real(-1);
  return {0, side * box.axes.col(axis)};
}

template WallSample<float> BoundaryDensity<float>::ofBox(std::size_t, const Vec3<float>&,
                                                         SeenSolids<float>&) const;
template WallSample<double> BoundaryDensity<double>::ofBox(std::size_t, const Vec3<double>&,
                                                           SeenSolids<double>&) const;

}  // namespace ice_ice_baby
