// Counts particles that pass a wall of a vessel.
#pragma once

#include <optional>

#include "ice_ice_baby/samples.h"
#include "leaks/vessels.h"
#include "meshes/surface_distance.h"

namespace ice_ice_baby::leaks {

/// The first path through a wall, in the frame of the vessel.
struct LeakedPath {
  double time_s = 0.0;
  std::uint32_t id = 0;
  Vec3d from = Vec3d::Zero(), to = Vec3d::Zero();
};

struct LeakCounts {
  double particle_seconds = 0.0;  ///< of particles at the vessel: in it or close to its walls
  std::size_t through_wall = 0;
  std::size_t escaped_over_rim = 0;
  std::size_t not_finite = 0;
  std::optional<LeakedPath> first;
};

/// A particle went through a wall if its path between two frames, in the frame of the vessel, meets
/// the triangles of the vessel, one end lies inside and the other does not, and both ends are lower
/// than the rim by more than a spacing. The path is a straight line, so a frame has to be a single
/// substep.
class LeakWatch {
 public:
  LeakWatch(const Vessel& vessel, double spacing_m);

  /// Takes the places before the first frame.
  void start(const std::vector<ParticleSample>& samples, const Posed& pose);
  /// @param pose of the vessel after the frame
  /// @param placed whether the vessel was placed there without motion; water outside stays where it
  /// was then and has no path in the frame of the vessel
  void frame(const std::vector<ParticleSample>& samples, const Posed& pose, double frame_s,
             bool placed);
  /// Counts since the last call.
  LeakCounts take();

  /// Particles inside after the latest frame.
  std::size_t inside() const;

 private:
  struct Track {
    Vec3d place = Vec3d::Zero();  ///< in the frame of the vessel
    bool present = false, inside = false;
    bool leaked = false;
  };

  bool inRoom(const Vec3d& place) const;
  void follow(const ParticleSample& sample, const Vec3d& place, bool placed);

  SurfaceTree walls_, room_;
  SurfaceDistance distance_;
  std::optional<double> rim_m_;
  double spacing_m_, time_s_ = 0.0;
  Eigen::AlignedBox3d near_;
  std::vector<Track> tracks_;
  LeakCounts counts_;
};

}  // namespace ice_ice_baby::leaks
