// What a camera can see, as triangles, and the picture that it takes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ice_ice_baby/camera_params.h"
#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// What a pixel shows.
enum class Seen : std::uint8_t { kNothing, kWater, kIce, kSolid };

inline std::vector<std::string> choices(Seen) { return {"nothing", "water", "ice", "solid"}; }

/// Row by row from the top left.
struct CameraPicture {
  int width = 0, height = 0;
  std::vector<float> depth_m;  ///< along the optical axis; NaN where nothing is within the range
  std::vector<Seen> seen;
};

/// Whether this program was built with libembree-dev, without which cameras are left out.
bool castsRays();

/// Triangles that a ray can hit. Rays are cast by Embree, on the calling thread alone, so that the
/// solver keeps the others.
class RayScene {
 public:
  /// @throws InvalidInput if this program casts no rays
  RayScene();
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Adds a mesh in the frame of the scene; m. One without triangles adds nothing.
  void add(const std::vector<Vec3<float>>& vertices,
           const std::vector<std::array<Index, 3>>& triangles, Seen seen);

  /// What has been added, as seen by a camera in its optical frame. @param pose of that frame
  CameraPicture picture(const Camera& camera, const Posed& pose);

 private:
  struct Rays;
  std::unique_ptr<Rays> rays_;
};

}  // namespace ice_ice_baby
