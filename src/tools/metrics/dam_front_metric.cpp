#include "metrics/dam_front_metric.h"

#include <algorithm>
#include <cmath>

#include "metrics/block_in_container.h"

namespace ice_ice_baby {

namespace {

/// Front at T = 4, the last time compared: about 5 widths in the experiment.
constexpr double kRoomInWidths = 5.0;

/// Between 1.125 and 2.25 inches.
constexpr double kBetweenTheColumns_m = 0.04;

bool isTheExperiment(const BlockInContainer& block, double spacing_m) {
  const double little_m = 0.6 * spacing_m;
  const double width_m = block.block_size_m.x();
  const bool stands = block.min_gap_m.maxCoeff() < little_m && block.max_gap_m.y() < little_m;
  const bool shaped = std::abs(block.block_size_m.z() - 2 * width_m) < spacing_m;
  return stands && shaped && block.container_size_m.x() >= kRoomInWidths * width_m;
}

}  // namespace

std::unique_ptr<DamFrontMetric> DamFrontMetric::forScene(const FrameView& start) {
  const auto block = blockInContainer(start);
  if (!block || start.particles.empty()) return nullptr;
  if (!isTheExperiment(*block, start.scene().fluid.spacing_m)) return nullptr;
  auto recorder = std::make_unique<DamFrontMetric>();
  recorder->wall_x_m_ = block->floor_m.x();
  recorder->width_m_ = block->block_size_m.x();
  recorder->gravity_m_s2_ = -start.scene().gravity_m_s2.z();
  return recorder;
}

void DamFrontMetric::add(const FrameView& frame) {
  double front_m = wall_x_m_;
  for (const ParticleSample& p : frame.particles) front_m = std::max(front_m, double(p.x));
  front_m += frame.scene().fluid.spacing_m / 2 - wall_x_m_;
  const double unit_s = std::sqrt(width_m_ / (2 * gravity_m_s2_));
  run_.push_back({frame.report().time_s / unit_s, front_m / width_m_});
}

void DamFrontMetric::report(std::vector<ErrorMetric>& metrics) const {
  const auto& measured = width_m_ < kBetweenTheColumns_m ? martinMoyceNarrow() : martinMoyceWide();
  metrics.push_back({"front_error", frontError(run_, measured)});
}

}  // namespace ice_ice_baby
