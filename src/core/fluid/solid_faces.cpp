#include "fluid/solid_faces.h"

#include <algorithm>

namespace ice_ice_baby {

namespace {

/// Cosine from which on two directions count as parallel.
constexpr double kParallel = 1 - 1e-6;

/// The axis that is parallel to a direction, or -1.
template <class Real>
int axisAlong(const Vec3<Real>& direction) {
  int axis;
  return direction.cwiseAbs().maxCoeff(&axis) > Real(kParallel) ? axis : -1;
}

}  // namespace

template <class Real>
bool cutBehind(const SolidFace<Real>& face, SolidBox<Real>& box) {
  const Vec3<Real> normal = box.axes.transpose() * face.normal;
  const int axis = face.flat ? axisAlong(normal) : -1;
  if (axis < 0) return false;
  if (normal[axis] > 0) box.box.low[axis] = std::max(box.box.low[axis], -face.distance);
  if (normal[axis] < 0) box.box.high[axis] = std::min(box.box.high[axis], face.distance);
  return true;
}

template <class Real>
bool commonPart(const SolidBox<Real>& a, const SolidBox<Real>& b, AlignedBox<Real>& common) {
  const Mat3<Real> turn = b.axes.transpose() * a.axes;  // from a to b
  common = b.box;
  for (int column = 0; column < 3; ++column) {
    const int axis = axisAlong<Real>(turn.col(column));
    if (axis < 0) return false;
    const bool same = turn(axis, column) > 0;
    const Real low = same ? a.box.low[column] : -a.box.high[column];
    const Real high = same ? a.box.high[column] : -a.box.low[column];
    common.low[axis] = std::max(common.low[axis], low);
    common.high[axis] = std::min(common.high[axis], high);
  }
  common.high = common.high.cwiseMax(common.low);
  return true;
}

template <class Real>
void takeOff(const SolidFace<Real>& other, const SolidFace<Real>& face,
             const OverlapDensity<Real>& overlap, const DistanceTable<Real>& flat,
             WallSample<Real>& solid) {
  const auto [whole, slope] = flat.at(face.distance);
  if (whole <= 0) return;
  const auto shared = overlap.at(other.distance, face.distance, other.normal.dot(face.normal));
  const Real ratio = shared.value / whole;
  if (ratio <= 0) return;
  Vec3<Real> ratio_gradient = Vec3<Real>::Zero();
  if (ratio < 1) {
    const Vec3<Real> cosine_gradient = other.turning * face.normal + face.turning * other.normal;
    ratio_gradient =
        (shared.slope_a * other.normal + (shared.slope_b - ratio * slope) * face.normal +
         shared.slope_cosine * cosine_gradient) /
        whole;
  }
  const Real part = std::min(ratio, Real(1));
  solid.gradient = (1 - other.share * part) * solid.gradient -
                   solid.value * (other.share * ratio_gradient + part * other.share_gradient);
  solid.value *= 1 - other.share * part;
}

template bool cutBehind(const SolidFace<float>&, SolidBox<float>&);
template bool cutBehind(const SolidFace<double>&, SolidBox<double>&);
template bool commonPart(const SolidBox<float>&, const SolidBox<float>&, AlignedBox<float>&);
template bool commonPart(const SolidBox<double>&, const SolidBox<double>&, AlignedBox<double>&);
template void takeOff(const SolidFace<float>&, const SolidFace<float>&,
                      const OverlapDensity<float>&, const DistanceTable<float>&,
                      WallSample<float>&);
template void takeOff(const SolidFace<double>&, const SolidFace<double>&,
                      const OverlapDensity<double>&, const DistanceTable<double>&,
                      WallSample<double>&);

}  // namespace ice_ice_baby
