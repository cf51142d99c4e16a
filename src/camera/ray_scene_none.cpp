#include "ice_ice_baby/errors.h"
#include "ray_scene.h"

namespace ice_ice_baby {

struct RayScene::Rays {};

bool castsRays() { return false; }

RayScene::RayScene() {
  throw InvalidInput(
      "cameras need Embree, which this program was built without; install libembree-dev and build "
      "it again");
}

RayScene::~RayScene() = default;

void RayScene::add(const std::vector<Vec3<float>>&, const std::vector<std::array<Index, 3>>&,
                   Seen) {}

CameraPicture RayScene::picture(const Camera&, const Posed&) { return {}; }

}  // namespace ice_ice_baby
