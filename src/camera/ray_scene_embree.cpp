#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "ice_ice_baby/errors.h"
#include "ray_scene.h"

namespace ice_ice_baby {

namespace {

/// Rays that are cast together, so that neighbouring pixels share the work.
constexpr int kPacket = 8;
constexpr float kNothing_m = std::numeric_limits<float>::quiet_NaN();

/// Rays whose direction has length 1 along the optical axis, so that their length is the depth.
class Pixels {
 public:
  Pixels(const Camera& camera, const Posed& pose)
      : focal_(static_cast<float>(camera.focalLength())),
        centre_x_(0.5f * static_cast<float>(camera.width)),
        centre_y_(0.5f * static_cast<float>(camera.height)),
        origin_(pose.position.cast<float>()),
        axes_(pose.rotation.cast<float>()) {}

  const Vec3<float>& origin() const { return origin_; }
  /// Through the middle of a pixel.
  Vec3<float> direction(int x, int y) const {
    const Vec3<float> in_camera((static_cast<float>(x) + 0.5f - centre_x_) / focal_,
                                (static_cast<float>(y) + 0.5f - centre_y_) / focal_, 1.0f);
    return axes_ * in_camera;
  }

 private:
  const float focal_, centre_x_, centre_y_;
  const Vec3<float> origin_;
  const Mat3<float> axes_;
};

void aim(RTCRayHit8& rays, int k, const Vec3<float>& origin, const Vec3<float>& direction,
         float range_m) {
  rays.ray.org_x[k] = origin.x();
  rays.ray.org_y[k] = origin.y();
  rays.ray.org_z[k] = origin.z();
  rays.ray.dir_x[k] = direction.x();
  rays.ray.dir_y[k] = direction.y();
  rays.ray.dir_z[k] = direction.z();
  rays.ray.tnear[k] = 0.0f;
  rays.ray.tfar[k] = range_m;
  rays.ray.time[k] = 0.0f;
  rays.ray.mask[k] = -1u;
  rays.ray.flags[k] = 0;
  rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
}

}  // namespace

struct RayScene::Rays {
  // A number of threads here would hold for all of oneTBB in this process.
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);
  std::vector<Seen> seen;  ///< by number of geometry
};

bool castsRays() { return true; }

RayScene::RayScene() : rays_(std::make_unique<Rays>()) {
  if (!rays_->device) throw InvalidInput("Embree does not start on this machine");
  rtcSetSceneBuildQuality(rays_->scene, RTC_BUILD_QUALITY_LOW);  // each is cast at only once
}

RayScene::~RayScene() {
  rtcReleaseScene(rays_->scene);
  rtcReleaseDevice(rays_->device);
}

void RayScene::add(const std::vector<Vec3<float>>& vertices,
                   const std::vector<std::array<Index, 3>>& triangles, Seen seen) {
  if (triangles.empty()) return;
  RTCGeometry geometry = rtcNewGeometry(rays_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* places = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices.size()));
  auto* corners = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(unsigned), triangles.size()));
  if (!places || !corners) throw std::bad_alloc();
  for (const Vec3<float>& v : vertices) places = std::copy_n(v.data(), 3, places);
  for (const auto& t : triangles) corners = std::copy_n(t.data(), 3, corners);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(rays_->scene, geometry, static_cast<unsigned>(rays_->seen.size()));
  rtcReleaseGeometry(geometry);
  rays_->seen.push_back(seen);
}

CameraPicture RayScene::picture(const Camera& camera, const Posed& pose) {
  tbb::task_arena(1).execute([this] { rtcJoinCommitScene(rays_->scene); });
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  CameraPicture picture;
  picture.width = camera.width;
  picture.height = camera.height;
  const std::size_t count = std::size_t(camera.width) * std::size_t(camera.height);
  picture.depth_m.assign(count, kNothing_m);
  picture.seen.assign(count, Seen::kNothing);
  const Pixels pixels(camera, pose);
  std::size_t first = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; x += kPacket) {
      const int used = std::min(kPacket, camera.width - x);
      RTCRayHit8 rays;
      alignas(32) int valid[kPacket];
      for (int k = 0; k < kPacket; ++k) {
        valid[k] = k < used ? -1 : 0;
        aim(rays, k, pixels.origin(), pixels.direction(x + k, y),
            static_cast<float>(camera.range_m));
      }
      rtcIntersect8(valid, rays_->scene, &context, &rays);
      for (int k = 0; k < used; ++k, ++first) {
        const unsigned hit = rays.hit.geomID[k];
        if (hit == RTC_INVALID_GEOMETRY_ID) continue;
        picture.depth_m[first] = rays.ray.tfar[k];
        picture.seen[first] = rays_->seen[hit];
      }
    }
  }
  return picture;
}

}  // namespace ice_ice_baby
