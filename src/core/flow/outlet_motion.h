// How the outlet of a source moves over a frame.
#pragma once

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Moves evenly from where it is to where it is asked to be. The outlet of a source with a
/// `follow_frame` has no place until it is told one.
class OutletMotion {
 public:
  explicit OutletMotion(const Source& source);

  /// Moves to a pose over the next frame, or at once if it has no place yet.
  void moveTo(const Posed& pose);
  /// Goes to a pose at once, without motion.
  void place(const Posed& pose);
  /// Goes to where it is moving at once if a point of the disc would move farther than `max_m`.
  void jump(double radius_m, double max_m);
  /// Ends the frame.
  void endFrame() { start_ = target_; }

  bool placed() const { return placed_; }
  /// Pose when this fraction of the frame has passed.
  Posed at(double fraction) const;
  /// Velocity of a point that moves with the outlet, whose pose is `now`.
  /// @param frame_s length of the frame
  Vec3d velocityAt(const Vec3d& point_m, const Posed& now, double frame_s) const;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.start_, self.target_, self.placed_);
  }
  /// @throws InvalidInput if a pose from a checkpoint is out of range
  void restore() const;

 private:
  bool moves() const;
  Vec3d turn_rad() const;

  Posed start_;
  Posed target_;
  bool placed_;
};

}  // namespace ice_ice_baby
