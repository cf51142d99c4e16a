#include "pictures/surface_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"

namespace ice_ice_baby {

namespace {

constexpr float kFar = std::numeric_limits<float>::max();
/// Radius of a sphere and range of the smoothing, in spacings. Depths that differ by more than the
/// last belong to different objects.
constexpr float kSphere = 0.72f;
constexpr float kReach = 1.6f;
constexpr float kApart = 2.5f;

}  // namespace

void SurfaceLayer::clear(const Canvas& canvas) {
  const std::size_t count = std::size_t(canvas.width()) * std::size_t(canvas.height());
  depths_.assign(count, kFar);
  thickness_m_.assign(count, 0.0f);
  colours_.assign(count, {0, 0, 0});
  reach_px_ = 1;
}

void SurfaceLayer::add(const Canvas& canvas, const Eigen::Vector3f& centre, Colour colour,
                       const std::vector<float>& opaque) {
  const Projected p = canvas.project(centre);
  const float radius_m = kSphere * spacing_m_;
  if (p.depth < 2 * radius_m) return;
  reach_px_ = std::max(reach_px_, int(kReach * spacing_m_ * p.scale));
  const float r = std::max(0.5f, radius_m * p.scale);
  // Scaled so that overlapping spheres have the thickness of the water they represent.
  const float chord_m = 2 * radius_m / (4.18879f * kSphere * kSphere * kSphere);
  const int right = std::min(canvas.width() - 1, int(p.x + r));
  const int bottom = std::min(canvas.height() - 1, int(p.y + r));
  for (int y = std::max(0, int(p.y - r)); y <= bottom; ++y) {
    for (int x = std::max(0, int(p.x - r)); x <= right; ++x) {
      const float u = (float(x) + 0.5f - p.x) / r, v = (float(y) + 0.5f - p.y) / r;
      const float rest = 1 - u * u - v * v;
      if (rest <= 0) continue;
      const float n = std::sqrt(rest);
      const std::size_t k = std::size_t(y) * std::size_t(canvas.width()) + std::size_t(x);
      const float depth = p.depth - n * radius_m;
      if (depth > opaque[k]) continue;
      depths_[k] = std::min(depths_[k], depth);
      const float thickness = n * chord_m;
      thickness_m_[k] += thickness;
      Colour& sum = colours_[k];
      sum = {sum.red + thickness * colour.red, sum.green + thickness * colour.green,
             sum.blue + thickness * colour.blue};
    }
  }
}

/// Gaussian filter along rows, then along columns, twice.
void SurfaceLayer::smooth(const Canvas& canvas) {
  std::vector<float> bell(std::size_t(reach_px_) + 1);
  for (std::size_t k = 0; k < bell.size(); ++k) {
    bell[k] = std::exp(-4.5f * float(k * k) / float(reach_px_ * reach_px_));
  }
  const int width = canvas.width(), height = canvas.height();
  const float apart_m = kApart * spacing_m_;
  const auto pass = [&](const std::vector<float>& from, std::vector<float>& to, bool rows) {
    to = from;
    parallelFor(std::size_t(height), [&](std::size_t y) {
      for (int x = 0; x < width; ++x) {
        const std::size_t k = y * std::size_t(width) + std::size_t(x);
        if (from[k] == kFar) continue;
        const int at = rows ? x : int(y), last = (rows ? width : height) - 1;
        const int first = std::max(-reach_px_, -at), end = std::min(reach_px_, last - at);
        const std::ptrdiff_t stride = rows ? 1 : width;
        float sum = 0.0f, weight = 0.0f;
        for (int j = first; j <= end; ++j) {
          const float depth = from[std::size_t(std::ptrdiff_t(k) + j * stride)];
          if (std::abs(depth - from[k]) > apart_m) continue;
          sum += bell[std::size_t(std::abs(j))] * depth;
          weight += bell[std::size_t(std::abs(j))];
        }
        to[k] = sum / weight;
      }
    });
  };
  for (int k = 0; k < 2; ++k) {
    pass(depths_, scratch_, true);
    pass(scratch_, depths_, false);
  }
}

Colour SurfaceLayer::colour(std::size_t k) const {
  const float share = 1.0f / std::max(thickness_m_[k], 1e-9f);
  const Colour& sum = colours_[k];
  return {share * sum.red, share * sum.green, share * sum.blue};
}

/// Depth of a pixel, or `depth` if the pixel belongs to another object.
float SurfaceLayer::near(const Canvas& canvas, int x, int y, float depth) const {
  if (x < 0 || y < 0 || x >= canvas.width() || y >= canvas.height()) return depth;
  const float there = depths_[std::size_t(y) * std::size_t(canvas.width()) + std::size_t(x)];
  return std::abs(there - depth) > kApart * spacing_m_ ? depth : there;
}

Eigen::Vector3f SurfaceLayer::normal(const Canvas& canvas, int x, int y) const {
  const float depth = depths_[std::size_t(y) * std::size_t(canvas.width()) + std::size_t(x)];
  const float focal = canvas.focal_px();
  const float per_x = (near(canvas, x + 1, y, depth) - near(canvas, x - 1, y, depth)) / 2;
  const float per_y = (near(canvas, x, y + 1, depth) - near(canvas, x, y - 1, depth)) / 2;
  const float u = (float(x) + 0.5f - 0.5f * float(canvas.width())) / focal;
  const float v = (float(y) + 0.5f - 0.5f * float(canvas.height())) / focal;
  const Eigen::Vector3f along_x(depth / focal + u * per_x, v * per_x, per_x);
  const Eigen::Vector3f along_y(u * per_y, depth / focal + v * per_y, per_y);
  return along_y.cross(along_x).normalized();
}

}  // namespace ice_ice_baby
