// The colliders and floating solids of a scene as a camera sees them.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/simulation.h"
#include "ray_scene.h"

namespace ice_ice_baby {

/// Glass is clear: containers and cups below an opacity of one half are not seen, and neither is
/// any other shape with an opacity of 0.
class SeenShapes {
 public:
  explicit SeenShapes(const Scene& scene);

  struct Places {
    std::vector<Posed> colliders;    ///< in the order of forEachCollider
    std::vector<SolidState> solids;  ///< those still in the scene
  };
  static Places places(const Simulation& simulation);

  void addTo(RayScene& rays, const Places& places) const;

 private:
  struct Shape {
    std::vector<Vec3<float>> vertices;
    std::vector<std::array<Index, 3>> triangles;
  };
  static void add(RayScene& rays, const Shape& shape, const Posed& pose);

  std::vector<Shape> colliders_;  ///< in the same order, empty if not seen
  std::vector<std::pair<std::string, Shape>> solids_;
};

}  // namespace ice_ice_baby
