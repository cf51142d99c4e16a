// Planes that the end of a path may not pass: what bodies of ice rest on.
#pragma once

#include <array>

#include "colliders/aligned_box.h"
#include "colliders/motion.h"

namespace ice_ice_baby {

/// Plane that the end of a path may not pass, in the scene frame at the end of the substep.
struct Face {
  Vec3d normal;     ///< towards where the point may be
  Vec3d point;      ///< on the plane
  double gap_m;     ///< of the end of the path; negative: so deep
  double before_m;  ///< of its start, against the collider at the start
  Index number;     ///< 0 ... 5, tells faces of one collider apart
};

/// Path in the frame of a shape, and how its end is pushed out of it.
struct PushedPath {
  Vec3d from;
  Vec3d to;
  Vec3d push;

  bool free() const { return push.isZero(0); }
};

/// Collects faces of one collider in its own frame and hands them out in the scene's.
class FaceCollector {
 public:
  FaceCollector(const Motion<double>& motion, const PushedPath& path, double margin_m,
                std::array<Face, 6>& faces)
      : motion_(motion), path_(path), margin_(margin_m), faces_(faces) {}

  /// @param height of the plane along its normal
  void add(const Vec3d& normal, double height, Index number = 0);
  void addAxis(int axis, double value, bool upwards);
  /// Faces by which a box pushed, axis by axis.
  void addPush();
  /// The face of a solid box that a point outside it is above. Beside an edge there is none: a
  /// plane would stop there what only passes by.
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
