#include "metrics/energy_metric.h"

#include <algorithm>
#include <cmath>

#include "metrics/cloud_moments.h"

namespace ice_ice_baby {

std::unique_ptr<EnergyMetric> EnergyMetric::forScene(const FrameView& start) {
  if (start.particles.empty()) return nullptr;
  const Vec3d gravity = start.scene().gravity_m_s2;
  double lowest = std::numeric_limits<double>::max(), highest = -lowest;
  for (const ParticleSample& p : start.particles) {
    const double work = gravity.dot(positionOf(p));
    lowest = std::min(lowest, work);
    highest = std::max(highest, work);
  }
  const double across_a_particle = gravity.norm() * start.scene().fluid.spacing_m;
  const double mass_kg = massOfParticle_kg(start.scene()) * double(start.particles.size());
  const double scale_j =
      mass_kg * (highest - lowest + across_a_particle) + start.report().kinetic_energy_j;
  if (!(scale_j > 0.0)) return nullptr;
  return std::unique_ptr<EnergyMetric>(new EnergyMetric(scale_j));
}

void EnergyMetric::add(const FrameView& frame) {
  const StepReport& report = frame.report();
  const double before_j = end_j_;
  end_j_ = report.kinetic_energy_j + report.potential_energy_j + report.elastic_energy_j;
  if (std::isnan(start_j_)) start_j_ = end_j_;
  const std::uint64_t moved = report.spilled + report.poured + report.drained;
  if (moved != moved_) {  // what left took its energy along, and what came brought it
    start_j_ += end_j_ - before_j;
    min_j_ += end_j_ - before_j;
    moved_ = moved;
  }
  min_j_ = std::min(min_j_, end_j_);
  rise_j_ = std::max(rise_j_, end_j_ - min_j_);
}

void EnergyMetric::report(std::vector<ErrorMetric>& metrics) const {
  metrics.push_back({"energy_drift", (end_j_ - start_j_) / scale_j_});
  metrics.push_back({"energy_rise", rise_j_ / scale_j_});
}

}  // namespace ice_ice_baby
