#include "pictures/heat_painter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "pictures/caption.h"
#include "pictures/drawn_colliders.h"
#include "stage.h"

namespace ice_ice_baby {

namespace {

constexpr Colour kSky{0.07f, 0.10f, 0.15f};
constexpr Colour kGround{0.24f, 0.29f, 0.35f};
constexpr Colour kIceShadow{0.36f, 0.54f, 0.74f};
constexpr Colour kFoam{0.86f, 0.94f, 1.0f};

Colour colourOf(const ParticleSample& p) {
  const float speed = std::sqrt(p.vx * p.vx + p.vy * p.vy + p.vz * p.vz);
  const Colour water = mixed(waterColour(p.temperature_c), kFoam, std::min(0.5f, 0.22f * speed));
  return mixed(water, kIceColour, whiteness(p));
}

float lightOn(const Eigen::Vector3f& normal) {
  return std::max(0.0f, -normal.dot(Eigen::Vector3f(0.45f, 0.65f, 0.61f)));
}

float shineOn(const Eigen::Vector3f& normal, float sharp) {
  return std::pow(std::max(0.0f, -normal.dot(Eigen::Vector3f(0.25f, 0.55f, 0.797f))), sharp);
}

std::string captionOf(const StepReport& report) {
  char text[96];
  std::snprintf(text, sizeof text, "%5.1f s   mean %.1f ^C   ice %.0f %%", report.time_s,
                report.mean_celsius, 100 * report.strictness);
  std::string line = text;
  const auto add = [&](const char* what, std::size_t count) {
    if (count > 0) line += "   " + std::string(what) + " " + std::to_string(count);
  };
  add("bodies", report.ice_bodies);
  add("steam", report.steam_particles);
  return line;
}

}  // namespace

HeatPainter::HeatPainter(const Scene& scene, Canvas& canvas)
    : spacing_m_(float(scene.fluid.spacing_m)), ice_(spacing_m_), water_(spacing_m_) {
  const double volume_m3 = double(particleCount(scene)) * std::pow(scene.fluid.spacing_m, 3);
  clear_m_ = float(std::cbrt(volume_m3));
  const Eigen::AlignedBox3f bounds = stageOf(scene);
  const Eigen::Vector3f into = Eigen::Vector3f(0.42f, 1.0f, -0.36f).normalized();
  // Back until the picture holds all of it, with room for the text.
  for (float away = 0.5f * bounds.diagonal().norm();; away *= 1.02f) {
    canvas.look(bounds.center() - away * into, into);
    bool inside = true;
    for (int k = 0; k < 8; ++k) {
      const Projected p =
          canvas.project(bounds.corner(static_cast<Eigen::AlignedBox3f::CornerType>(k)));
      inside = inside && std::abs(p.x / float(canvas.width()) - 0.5f) < 0.47f &&
               std::abs(p.y / float(canvas.height()) - 0.5f) < 0.43f;
    }
    if (inside) break;
  }
}

void HeatPainter::paint(const Simulation& simulation, const std::vector<ParticleSample>& particles,
                        Canvas& canvas) {
  canvas.everything();
  canvas.clear(kSky, kGround);
  drawOpaqueColliders(simulation, canvas);
  drawSolids(simulation, canvas);
  paintIce(particles, canvas);
  gatherWater(particles, canvas);
  canvas.onlyFurther(water_.depths());
  paintAir(simulation, particles, canvas);
  paintWater(canvas);
  canvas.onlyNearer(water_.depths());
  paintAir(simulation, particles, canvas);
  canvas.everything();
  constexpr Colour kText{0.9f, 0.93f, 0.96f};
  drawText(canvas, 28, 28, 4, simulation.scene().name, kText);
  drawText(canvas, 28, canvas.height() - 52, 4, captionOf(simulation.report()), kText);
}

void HeatPainter::paintIce(const std::vector<ParticleSample>& particles, Canvas& canvas) {
  ice_.clear(canvas);
  for (const ParticleSample& p : particles) {
    if (p.phase == Phase::kIce) ice_.add(canvas, {p.x, p.y, p.z}, colourOf(p), canvas.depths());
  }
  ice_.smooth(canvas);
  for (std::size_t k = 0; k < canvas.pixels().size(); ++k) {
    if (!ice_.at(k)) continue;
    const std::size_t width = std::size_t(canvas.width());
    const Eigen::Vector3f normal = ice_.normal(canvas, int(k % width), int(k / width));
    const Colour lit = mixed(kIceShadow, ice_.colour(k), 0.15f + 0.95f * lightOn(normal));
    canvas.pixels()[k] = mixed(lit, {1, 1, 1}, 0.5f * shineOn(normal, 60.0f));
    canvas.depths()[k] = std::min(canvas.depths()[k], ice_.depths()[k]);
  }
}

void HeatPainter::gatherWater(const std::vector<ParticleSample>& particles, const Canvas& canvas) {
  water_.clear(canvas);
  for (const ParticleSample& p : particles) {
    if (p.phase != Phase::kWater) continue;
    water_.add(canvas, {p.x, p.y, p.z}, colourOf(p), canvas.depths());
  }
  water_.smooth(canvas);
}

/// Light that comes from behind, bent at the surface and absorbed, and what the water adds.
void HeatPainter::paintWater(Canvas& canvas) {
  behind_ = canvas.pixels();
  const int width = canvas.width(), height = canvas.height();
  for (std::size_t k = 0; k < behind_.size(); ++k) {
    if (!water_.at(k)) continue;
    const int x = int(k % std::size_t(width)), y = int(k / std::size_t(width));
    const Eigen::Vector3f normal = water_.normal(canvas, x, y);
    const float through = std::exp(-water_.thickness_m(k) / clear_m_);
    const float bend = 0.02f * float(width) * (1 - through);
    const int from_x = std::clamp(x + int(bend * normal.x()), 0, width - 1);
    const int from_y = std::clamp(y + int(bend * normal.y()), 0, height - 1);
    const Colour behind = behind_[std::size_t(from_y) * std::size_t(width) + std::size_t(from_x)];
    const Colour own =
        mixed({0, 0, 0}, mixed(water_.colour(k), kFoam, 0.1f), 0.6f + 0.4f * lightOn(normal));
    Colour seen = mixed(own, behind, 0.85f * through);
    const float grazing = std::pow(1 - std::max(0.0f, -normal.z()), 3.0f);
    // A rim so thin that its normal is chance neither mirrors nor shines.
    const float body = std::min(1.0f, water_.thickness_m(k) / (2 * spacing_m_));
    seen = mixed(seen, {0.62f, 0.74f, 0.86f}, 0.45f * body * grazing);
    canvas.pixels()[k] = mixed(seen, {1, 1, 1}, 0.7f * body * shineOn(normal, 90.0f));
  }
}

/// What is drawn over and under the water alike: steam, and colliders that one sees through.
void HeatPainter::paintAir(const Simulation& simulation,
                           const std::vector<ParticleSample>& particles, Canvas& canvas) const {
  drawClearColliders(simulation, canvas);
  for (const ParticleSample& p : particles) {
    if (p.phase != Phase::kSteam) continue;
    const Projected at = canvas.project({p.x, p.y, p.z});
    const float r = std::max(1.0f, 0.9f * spacing_m_ * at.scale);
    for (int y = int(at.y - r); y <= int(at.y + r); ++y) {
      for (int x = int(at.x - r); x <= int(at.x + r); ++x) {
        const float u = (float(x) + 0.5f - at.x) / r, v = (float(y) + 0.5f - at.y) / r;
        const float rest = 1 - u * u - v * v;
        if (rest > 0) canvas.blend(x, y, at.depth, kSteamColour, 0.55f * rest);
      }
    }
  }
}

}  // namespace ice_ice_baby
