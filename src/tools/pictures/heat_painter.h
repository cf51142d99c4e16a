// Pictures of scenes with heat: what freezes, melts and boils inside the water is seen through it.
#pragma once

#include <vector>

#include "pictures/canvas.h"
#include "pictures/surface_layer.h"

namespace ice_ice_baby {

class HeatPainter {
 public:
  /// Looks at everything that the scene holds.
  HeatPainter(const Scene& scene, Canvas& canvas);

  /// Opaque ice and colliders, water over them through which they show, tinted by its temperature,
  /// puffs of steam, and lines of text.
  void paint(const Simulation& simulation, const std::vector<ParticleSample>& particles,
             Canvas& canvas);

 private:
  void paintIce(const std::vector<ParticleSample>& particles, Canvas& canvas);
  void gatherWater(const std::vector<ParticleSample>& particles, const Canvas& canvas);
  void paintWater(Canvas& canvas);
  void paintAir(const Simulation& simulation, const std::vector<ParticleSample>& particles,
                Canvas& canvas) const;

  float spacing_m_;
  float clear_m_;  ///< thickness of water through which a third of the light comes
  SurfaceLayer ice_, water_;
  std::vector<Colour> behind_;  ///< scratch of paintWater
};

}  // namespace ice_ice_baby
