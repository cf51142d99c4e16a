#include "sequences/surface_writer.h"

#include "ice_ice_baby/errors.h"
#include "particle_colour.h"
#include "sequences/collider_file.h"
#include "surface_file.h"

namespace ice_ice_baby {

namespace {

/// Steam is thin: its particles are drawn so much wider, so that they make clouds.
constexpr double kSteamWidth = 2.0;

}  // namespace

SurfaceWriter::SurfaceWriter(const std::string& folder, const std::string& format,
                             const Scene& scene)
    : folder_(folder), obj_(format == "obj") {
  if (!obj_ && format != "ply") {
    throw InvalidInput("--surface-format " + format + " must be ply or obj");
  }
  if (!makesSurfaces()) {
    throw InvalidInput("--surface needs libopenvdb-dev; install it and build again");
  }
  kept_.push_back({Phase::kWater, {folder, "water", format}});
  if (!scene.solids.empty()) solids_.emplace(folder, "solids", "obj");
  kept_.push_back({Phase::kIce, {folder, "ice", format}});
  kept_.push_back({Phase::kSteam, {folder, "steam", format}});
}

void SurfaceWriter::write(const Simulation& simulation) {
  if (kept_.front().files.empty()) writeColliders(folder_ + "/colliders.obj", simulation);
  if (solids_) writeSolids(solids_->next(simulation.report().time_s), simulation);
  simulation.sample(particles_);
  for (Kept& one : kept_) {
    const FluidSurface surface = surfaceOf(one.phase, simulation.scene());
    const bool none_yet = one.files.empty() && surface.triangles.empty();
    if (one.phase != Phase::kWater && none_yet) continue;
    const std::string path = one.files.next(simulation.report().time_s);
    obj_ ? writeObj(path, surface) : writePly(path, surface);
  }
}

FluidSurface SurfaceWriter::surfaceOf(Phase phase, const Scene& scene) const {
  const double width = phase == Phase::kSteam ? kSteamWidth : 1.0;
  FluidSurface surface = ice_ice_baby::surfaceOf(particles_, phase, width * scene.fluid.spacing_m);
  if (!scene.thermal.enabled) return surface;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    surface.colours.push_back(
        surfaceColour(phase, true, surface.temperatures_c[v], surface.ice_fractions[v]));
  }
  return surface;
}

void SurfaceWriter::finish() const {
  for (const Kept& one : kept_) {
    if (!one.files.empty()) one.files.writeIndex();
  }
}

}  // namespace ice_ice_baby
