#include "colliders/face_collector.h"

namespace ice_ice_baby {

void FaceCollector::add(const Vec3d& normal, double height, Index number) {
  const double gap = normal.dot(path_.to) - height;
  if (gap >= margin_) return;
  const Vec3d point = path_.to - gap * normal;
  faces_[count_++] = {motion_.to.rotation * normal, motion_.to.toWorld(point), gap,
                      normal.dot(path_.from) - height, number};
}

void FaceCollector::addAxis(int axis, double value, bool upwards) {
  const double sign = upwards ? 1.0 : -1.0;
  add(sign * Vec3d::Unit(axis), sign * value, Index(2 * axis + (upwards ? 0 : 1)));
}

void FaceCollector::addPush() {
  for (int axis = 0; axis < 3; ++axis) {
    const double push = path_.push[axis];
    if (push != 0) addAxis(axis, path_.to[axis] + push, push > 0);
  }
}

void FaceCollector::addFaceBelow(const AlignedBox<double>& box) {
  int separated = 0, axis = 0;
  bool upwards = true;
  for (int k = 0; k < 3; ++k) {
    if (path_.to[k] > box.low[k] && path_.to[k] < box.high[k]) continue;
    ++separated;
    axis = k;
    upwards = path_.to[k] >= box.high[k];
  }
  if (separated == 1) addAxis(axis, upwards ? box.high[axis] : box.low[axis], upwards);
}

}  // namespace ice_ice_baby
