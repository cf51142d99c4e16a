#include "sequences/surface_writer.h"

#include "ice_ice_baby/errors.h"
#include "sequences/collider_file.h"
#include "surface_file.h"

namespace ice_ice_baby {

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
}

void SurfaceWriter::write(const Simulation& simulation) {
  if (kept_.front().files.empty()) writeColliders(folder_ + "/colliders.obj", simulation);
  if (solids_) writeSolids(solids_->next(simulation.report().time_s), simulation);
  simulation.sample(particles_);
  for (Kept& one : kept_) {
    const FluidSurface surface =
        surfaceOf(particles_, one.phase, simulation.scene().fluid.spacing_m);
    const bool none_yet = one.files.empty() && surface.triangles.empty();
    if (one.phase == Phase::kIce && none_yet) continue;
    const std::string path = one.files.next(simulation.report().time_s);
    obj_ ? writeObj(path, surface) : writePly(path, surface);
  }
}

void SurfaceWriter::finish() const {
  for (const Kept& one : kept_) {
    if (!one.files.empty()) one.files.writeIndex();
  }
}

}  // namespace ice_ice_baby
