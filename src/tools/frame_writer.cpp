#include "frame_writer.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

constexpr int kWidth = 800;
constexpr int kHeight = 600;
constexpr std::size_t kMaxSprings = 20000;
constexpr float kFar = std::numeric_limits<float>::max();

/// frame_00000.png: five digits, as write() names them.
bool isFrame(const std::string& name) {
  return name.size() == 15 && name.rfind("frame_", 0) == 0 && name.substr(11) == ".png" &&
         name.find_first_not_of("0123456789", 6) == 11;
}

Eigen::Vector3f boxCorner(const Container& c, int k) {
  const Eigen::Vector3f half(float(c.size_m.x()) / 2, float(c.size_m.y()) / 2, float(c.size_m.z()));
  return {k & 1 ? half.x() : -half.x(), k & 2 ? half.y() : -half.y(), k & 4 ? half.z() : 0.0f};
}

}  // namespace

FrameWriter::FrameWriter(std::string folder, const Scene& scene) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (!std::filesystem::is_directory(folder_)) {
    throw InvalidInput("cannot make the folder " + folder_ + " for frames: " + error.message());
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (isFrame(entry.path().filename().string())) std::filesystem::remove(entry.path(), error);
  }
  frameScene(scene);
}

/// Looks from above at a corner of everything that the scene holds, near enough to fill the
/// picture.
void FrameWriter::frameScene(const Scene& scene) {
  Eigen::AlignedBox3f bounds;
  for (const Block& block : scene.blocks) {
    bounds.extend(block.min_m.cast<float>()).extend(block.max_m.cast<float>());
  }
  for (const Container& c : scene.containers) {
    const Pose<float> pose = c.pose().cast<float>();
    for (int k = 0; k < 8; ++k) bounds.extend(pose.toWorld(boxCorner(c, k)));
  }
  for (const Sphere& s : scene.spheres) {
    const Eigen::Vector3f r = Eigen::Vector3f::Constant(float(s.radius_m));
    bounds.extend(s.position_m.cast<float>() - r).extend(s.position_m.cast<float>() + r);
  }
  if (bounds.isEmpty()) bounds.extend(Eigen::Vector3f::Zero()).extend(Eigen::Vector3f::Ones());
  const Eigen::Vector3f into = Eigen::Vector3f(0.45f, 1.0f, -0.42f).normalized();
  const Eigen::Vector3f right = into.cross(Eigen::Vector3f::UnitZ()).normalized();
  camera_.row(0) = right;
  camera_.row(1) = into.cross(right);
  camera_.row(2) = into;
  const float size = std::max(0.1f, bounds.diagonal().norm());
  eye_ = bounds.center() - 1.65f * size * into;
}

FrameWriter::Projected FrameWriter::project(const Eigen::Vector3f& point) const {
  const Eigen::Vector3f seen = camera_ * (point - eye_);
  const float scale = focal_px_ / std::max(seen.z(), 1e-3f);
  return {0.5f * kWidth + seen.x() * scale, 0.5f * kHeight + seen.y() * scale, seen.z(), scale};
}

void FrameWriter::blend(int x, int y, float depth, Color color, float opacity) {
  if (x < 0 || y < 0 || x >= kWidth || y >= kHeight) return;
  const std::size_t k = std::size_t(y) * kWidth + std::size_t(x);
  if (depth > depth_[k]) return;
  Color& pixel = pixels_[k];
  pixel = {pixel.r + opacity * (color.r - pixel.r), pixel.g + opacity * (color.g - pixel.g),
           pixel.b + opacity * (color.b - pixel.b)};
  if (opacity >= 1.0f) depth_[k] = depth;
}

void FrameWriter::drawSphere(const Eigen::Vector3f& centre, float radius_m, Color color) {
  const Projected p = project(centre);
  if (p.depth < 2 * radius_m) return;
  const float r = std::max(0.5f, radius_m * p.scale);
  const int left = int(std::floor(p.x - r)), right = int(std::ceil(p.x + r));
  const int top = int(std::floor(p.y - r)), bottom = int(std::ceil(p.y + r));
  for (int y = std::max(top, 0); y <= std::min(bottom, kHeight - 1); ++y) {
    for (int x = std::max(left, 0); x <= std::min(right, kWidth - 1); ++x) {
      const float u = (float(x) + 0.5f - p.x) / r, v = (float(y) + 0.5f - p.y) / r;
      const float rest = 1 - u * u - v * v;
      if (rest <= 0) continue;
      const float n = std::sqrt(rest);
      const float light = 0.35f + 0.65f * std::max(0.0f, -0.45f * u - 0.65f * v + 0.61f * n);
      const float shine = std::pow(std::max(0.0f, -0.3f * u - 0.5f * v + 0.81f * n), 40.0f) * 0.35f;
      blend(x, y, p.depth - n * radius_m,
            {color.r * light + shine, color.g * light + shine, color.b * light + shine}, 1.0f);
    }
  }
}

void FrameWriter::drawLine(const Eigen::Vector3f& a, const Eigen::Vector3f& b, Color color,
                           float opacity) {
  const Projected from = project(a), to = project(b);
  const float longest = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  const int steps = std::clamp(int(longest), 1, 4000);
  for (int k = 0; k <= steps; ++k) {
    const float t = float(k) / float(steps);
    blend(int(from.x + t * (to.x - from.x)), int(from.y + t * (to.y - from.y)),
          from.depth + t * (to.depth - from.depth), color, opacity);
  }
}

void FrameWriter::drawColliders(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  for (const Sphere& s : scene.spheres) {
    const Eigen::Vector3f centre = simulation.colliderPose(s.name).position.cast<float>();
    drawSphere(centre, float(s.radius_m), {0.75f, 0.45f, 0.3f});
  }
  for (const Container& c : scene.containers) {
    const Pose<float> pose = simulation.colliderPose(c.name).cast<float>();
    for (int k = 0; k < 8; ++k) {
      for (const int axis : {1, 2, 4}) {
        if (k & axis) continue;
        drawLine(pose.toWorld(boxCorner(c, k)), pose.toWorld(boxCorner(c, k | axis)),
                 {0.35f, 0.38f, 0.42f}, 0.8f);
      }
    }
  }
}

void FrameWriter::write(const Simulation& simulation) {
  pixels_.assign(std::size_t(kWidth) * kHeight, Color{0.95f, 0.96f, 0.97f});
  depth_.assign(pixels_.size(), kFar);
  simulation.sample(particles_);
  simulation.sampleSprings(springs_, kMaxSprings);
  const float radius = float(simulation.scene().fluid.spacing_m) / 2;
  for (const ParticleSample& p : particles_) {
    const float speed = std::sqrt(p.vx * p.vx + p.vy * p.vy + p.vz * p.vz);
    const float foam = std::min(0.55f, 0.25f * speed);
    const float white = std::max(foam, 0.85f * p.ice_fraction);
    drawSphere({p.x, p.y, p.z}, radius,
               {0.12f + 0.76f * white, 0.42f + 0.52f * white, 0.85f + 0.15f * white});
  }
  for (const SpringSample& s : springs_) {
    drawLine({s.ax, s.ay, s.az}, {s.bx, s.by, s.bz}, {0.2f, 0.35f, 0.6f}, 0.5f);
  }
  drawColliders(simulation);
  char name[32];
  std::snprintf(name, sizeof name, "/frame_%05zu.png", frames_++);
  save(folder_ + name);
}

void FrameWriter::save(const std::string& path) const {
  std::vector<unsigned char> bytes;
  bytes.reserve(pixels_.size() * 3);
  const auto byte = [](float value) {
    return static_cast<unsigned char>(255.0f * std::clamp(value, 0.0f, 1.0f));
  };
  for (const Color& c : pixels_) bytes.insert(bytes.end(), {byte(c.r), byte(c.g), byte(c.b)});
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = kWidth;
  image.height = kHeight;
  image.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_file(&image, path.c_str(), 0, bytes.data(), 0, nullptr)) {
    throw InvalidInput("cannot write the frame " + path + ": " + image.message);
  }
}

}  // namespace ice_ice_baby
