#include "pictures/frame_writer.h"

#include <algorithm>
#include <cmath>

#include "pictures/drawn_colliders.h"
#include "stage.h"

namespace ice_ice_baby {

namespace {

constexpr int kWidth = 800;
constexpr int kHeight = 600;
constexpr float kFocal_px = 900;
constexpr std::size_t kMaxSprings = 20000;

}  // namespace

FrameWriter::FrameWriter(const std::string& folder, const Scene& scene)
    : files_(folder, "frame", "png"),
      shrink_(scene.thermal.enabled ? 2 : 1),
      canvas_(kWidth * shrink_, kHeight * shrink_, kFocal_px * float(shrink_)) {
  if (scene.thermal.enabled) {
    heat_.emplace(scene, canvas_);
  } else {
    lookFromAbove(scene);
  }
}

/// Places the camera at a corner of the scene's bounds, near enough to fill the picture.
void FrameWriter::lookFromAbove(const Scene& scene) {
  const Eigen::AlignedBox3f bounds = boundsOf(scene);
  const Eigen::Vector3f into = Eigen::Vector3f(0.45f, 1.0f, -0.42f).normalized();
  const float size = std::max(0.1f, bounds.diagonal().norm());
  canvas_.look(bounds.center() - 1.65f * size * into, into);
}

void FrameWriter::paintPlainly(const Simulation& simulation) {
  canvas_.clear({0.95f, 0.96f, 0.97f}, {0.95f, 0.96f, 0.97f});
  simulation.sampleSprings(springs_, kMaxSprings);
  const float radius = float(simulation.scene().fluid.spacing_m) / 2;
  for (const ParticleSample& p : particles_) {
    if (p.phase == Phase::kSolid) continue;
    const float speed = std::sqrt(p.vx * p.vx + p.vy * p.vy + p.vz * p.vz);
    const float foam = std::min(0.55f, 0.25f * speed);
    const float white = std::max(foam, 0.85f * p.ice_fraction);
    canvas_.drawSphere({p.x, p.y, p.z}, radius,
                       {0.12f + 0.76f * white, 0.42f + 0.52f * white, 0.85f + 0.15f * white});
  }
  for (const SpringSample& s : springs_) {
    canvas_.drawLine({s.ax, s.ay, s.az}, {s.bx, s.by, s.bz}, {0.2f, 0.35f, 0.6f}, 0.5f);
  }
  drawPlainColliders(simulation, canvas_);
  drawSolids(simulation, canvas_);
}

void FrameWriter::write(const Simulation& simulation) {
  simulation.sample(particles_);
  if (heat_) {
    heat_->paint(simulation, particles_, canvas_);
  } else {
    paintPlainly(simulation);
  }
  canvas_.save(files_.next(simulation.report().time_s), shrink_);
}

}  // namespace ice_ice_baby
