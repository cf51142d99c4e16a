// Collects the planes that the end of a path may not cross, on which ice bodies rest.
#pragma once

#include <array>

#include "colliders/aligned_box.h"
#include "colliders/motion.h"

namespace ice_ice_baby {

/// Plane that the end of a path may not cross, in the scene frame at the end of the substep.
struct Face {
  Vec3d normal;     ///< towards the allowed side
  Vec3d point;      ///< on the plane
  double gap_m;     ///< distance of the end of the path; negative: penetration
  double before_m;  ///< distance of its start from the collider at that time
  Index number;     ///< 0 ... 5, identifies the face of a collider
};

/// Path in the frame of a shape, and the displacement that moves its end out of the shape.
struct PushedPath {
  Vec3d from;
  Vec3d to;
  Vec3d push;

  bool free() const { return push.isZero(0); }
};

/// Collects faces of one collider in its frame and returns them in the scene frame.
class FaceCollector {
 public:
  FaceCollector(const Motion<double>& motion, const PushedPath& path, double margin_m,
                std::array<Face, 6>& faces)
      : motion_(motion), path_(path), margin_(margin_m), faces_(faces) {}

  /// @param height of the plane along its normal
  void add(const Vec3d& normal, double height, Index number = 0);
  void addAxis(int axis, double value, bool upwards);
  /// Adds the faces of a box that pushed, axis by axis.
  void addPush();
  /// Adds the face of a solid box that a point is above. Beside an edge there is none, because a
  /// plane would stop bodies that only pass by.
  void addFaceBelow(const AlignedBox<double>& box);

  std::size_t count() const { return count_; }

 private:
  const Motion<double>& motion_;
  const PushedPath& path_;
  double margin_;
  std::array<Face, 6>& faces_;
  std::size_t count_ = 0;
};

}  // namespace ice_ice_baby
