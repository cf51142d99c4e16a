#include "error_faces.h"

#include "column_watch.h"
#include "dam_front_watch.h"
#include "density_watch.h"
#include "energy_watch.h"
#include "ice_watch.h"

namespace ice_ice_baby {

std::vector<std::unique_ptr<ErrorWatch>> watchesFor(const FrameView& start) {
  std::vector<std::unique_ptr<ErrorWatch>> watches;
  const auto add = [&](std::unique_ptr<ErrorWatch> watch) {
    if (watch) watches.push_back(std::move(watch));
  };
  add(std::make_unique<DensityWatch>());
  add(EnergyWatch::forScene(start));
  add(ColumnWatch::forScene(start));
  add(DamFrontWatch::forScene(start));
  add(IceWatch::forScene(start));
  for (const auto& watch : watches) watch->add(start);
  return watches;
}

}  // namespace ice_ice_baby
