// Regular stamps for frames that begin at irregular times.
#pragma once

namespace ice_ice_baby {

/// A frame that begins late has its stamp nearly where it would be on time; otherwise colliders
/// that follow tf would move unevenly. Frames that are slower than they should be are averaged.
class FrameStamps {
 public:
  /// @param begin_s when the frame begins, s @returns its stamp, s; not before that of the last one
  /// unless the clock jumped back
  double next(double begin_s);
  /// The next frame has no frame before it.
  void restart() { frames_ = 0; }

 private:
  int frames_ = 0;  ///< up to 2
  double stamp_s_ = 0.0;
  double period_s_ = 0.0;
};

}  // namespace ice_ice_baby
