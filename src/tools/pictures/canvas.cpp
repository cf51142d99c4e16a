#include "pictures/canvas.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

Canvas::Canvas(int width, int height, float focal_px)
    : width_(width), height_(height), focal_px_(focal_px) {
  look({0, -1, 0}, {0, 1, 0});
}

void Canvas::look(const Eigen::Vector3f& eye, const Eigen::Vector3f& into) {
  const Eigen::Vector3f right = into.cross(Eigen::Vector3f::UnitZ()).normalized();
  camera_.row(0) = right;
  camera_.row(1) = into.cross(right);
  camera_.row(2) = into;
  eye_ = eye;
}

Projected Canvas::project(const Eigen::Vector3f& point) const {
  const Eigen::Vector3f seen = camera_ * (point - eye_);
  const float scale = focal_px_ / std::max(seen.z(), 1e-3f);
  return {0.5f * float(width_) + seen.x() * scale, 0.5f * float(height_) + seen.y() * scale,
          seen.z(), scale};
}

void Canvas::clear(Colour top, Colour bottom) {
  pixels_.resize(std::size_t(width_) * std::size_t(height_));
  depths_.assign(pixels_.size(), std::numeric_limits<float>::max());
  for (std::size_t k = 0; k < pixels_.size(); ++k) {
    pixels_[k] = mixed(top, bottom, float(k) / float(pixels_.size()));
  }
}

void Canvas::blend(int x, int y, float depth, Colour colour, float opacity) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  const std::size_t k = std::size_t(y) * std::size_t(width_) + std::size_t(x);
  if (depth > depths_[k]) return;
  if (veil_ && (depth < (*veil_)[k]) != nearer_) return;
  Colour& pixel = pixels_[k];
  pixel = {pixel.red + opacity * (colour.red - pixel.red),
           pixel.green + opacity * (colour.green - pixel.green),
           pixel.blue + opacity * (colour.blue - pixel.blue)};
  if (opacity >= 1.0f) depths_[k] = depth;
}

void Canvas::drawSphere(const Eigen::Vector3f& centre, float radius_m, Colour colour) {
  const Projected p = project(centre);
  if (p.depth < 2 * radius_m) return;
  const float r = std::max(0.5f, radius_m * p.scale);
  const int left = int(std::floor(p.x - r)), right = int(std::ceil(p.x + r));
  const int top = int(std::floor(p.y - r)), bottom = int(std::ceil(p.y + r));
  for (int y = std::max(top, 0); y <= std::min(bottom, height_ - 1); ++y) {
    for (int x = std::max(left, 0); x <= std::min(right, width_ - 1); ++x) {
      const float u = (float(x) + 0.5f - p.x) / r, v = (float(y) + 0.5f - p.y) / r;
      const float rest = 1 - u * u - v * v;
      if (rest <= 0) continue;
      const float n = std::sqrt(rest);
      const float light = 0.35f + 0.65f * std::max(0.0f, -0.45f * u - 0.65f * v + 0.61f * n);
      const float shine = std::pow(std::max(0.0f, -0.3f * u - 0.5f * v + 0.81f * n), 40.0f) * 0.35f;
      blend(x, y, p.depth - n * radius_m,
            {colour.red * light + shine, colour.green * light + shine, colour.blue * light + shine},
            1.0f);
    }
  }
}

void Canvas::drawLine(const Eigen::Vector3f& a, const Eigen::Vector3f& b, Colour colour,
                      float opacity, int wide) {
  const Projected from = project(a), to = project(b);
  const float longest = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  const int steps = std::clamp(int(longest), 1, 4000);
  for (int k = 0; k <= steps; ++k) {
    const float t = float(k) / float(steps);
    for (int n = 0; n < wide * wide; ++n) {
      blend(int(from.x + t * (to.x - from.x)) + n % wide,
            int(from.y + t * (to.y - from.y)) + n / wide, from.depth + t * (to.depth - from.depth),
            colour, opacity);
    }
  }
}

void Canvas::drawTriangle(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                          const Eigen::Vector3f& c, Colour colour, float opacity) {
  const Projected p = project(a), q = project(b), r = project(c);
  if (std::min({p.depth, q.depth, r.depth}) < 1e-2f) return;
  const float area = (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
  if (std::abs(area) < 1e-6f) return;
  const int left = std::max(0, int(std::min({p.x, q.x, r.x})));
  const int right = std::min(width_ - 1, int(std::max({p.x, q.x, r.x})));
  const int bottom = std::min(height_ - 1, int(std::max({p.y, q.y, r.y})));
  for (int y = std::max(0, int(std::min({p.y, q.y, r.y}))); y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const float u = float(x) + 0.5f - p.x, v = float(y) + 0.5f - p.y;
      const float to_q = (u * (r.y - p.y) - v * (r.x - p.x)) / area;
      const float to_r = (v * (q.x - p.x) - u * (q.y - p.y)) / area;
      if (to_q < 0 || to_r < 0 || to_q + to_r > 1) continue;
      // The inverse of the depth is linear in picture coordinates.
      const float inverse = (1 - to_q - to_r) / p.depth + to_q / q.depth + to_r / r.depth;
      blend(x, y, 1 / inverse, colour, opacity);
    }
  }
}

void Canvas::save(const std::string& path, int shrink) const {
  const int width = width_ / shrink, height = height_ / shrink;
  std::vector<unsigned char> bytes;
  bytes.reserve(std::size_t(width) * std::size_t(height) * 3);
  const auto push = [&](float value) {
    bytes.push_back(static_cast<unsigned char>(255.0f * std::clamp(value, 0.0f, 1.0f)));
  };
  const float share = 1.0f / float(shrink * shrink);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Colour sum{0, 0, 0};
      for (int k = 0; k < shrink * shrink; ++k) {
        const int column = x * shrink + k % shrink, row = y * shrink + k / shrink;
        const Colour& c = pixels_[std::size_t(row) * std::size_t(width_) + std::size_t(column)];
        sum = {sum.red + share * c.red, sum.green + share * c.green, sum.blue + share * c.blue};
      }
      push(sum.red), push(sum.green), push(sum.blue);
    }
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = png_uint_32(width);
  image.height = png_uint_32(height);
  image.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_file(&image, path.c_str(), 0, bytes.data(), 0, nullptr)) {
    throw InvalidInput("cannot write the frame " + path + ": " + image.message);
  }
}

}  // namespace ice_ice_baby
