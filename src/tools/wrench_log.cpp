#include "wrench_log.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

void addTo(std::vector<ColliderWrench>& sum, const std::vector<ColliderWrench>& wrenches) {
  for (std::size_t c = 0; c < sum.size(); ++c) {
    sum[c].force_n += wrenches[c].force_n;
    sum[c].torque_n_m += wrenches[c].torque_n_m;
  }
}

std::vector<ColliderWrench> meanOf(std::vector<ColliderWrench> sum, std::size_t count) {
  for (ColliderWrench& wrench : sum) {
    wrench.force_n /= double(std::max<std::size_t>(count, 1));
    wrench.torque_n_m /= double(std::max<std::size_t>(count, 1));
  }
  return sum;
}

}  // namespace

WrenchLog::WrenchLog(Simulation& simulation)
    : simulation_(simulation),
      half_second_(static_cast<std::size_t>(
          std::max(1.0, std::ceil(0.5 * simulation.scene().solver.frame_rate_hz)))) {
  simulation_.measureWrenches(true);
  sum_ = simulation_.wrenches();
}

void WrenchLog::add() {
  frames_.push_back(simulation_.wrenches());
  if (frames_.size() > half_second_) frames_.pop_front();
  addTo(sum_, frames_.back());
  ++count_;
  simulation_.measureWrenches(true);
}

std::vector<ColliderWrench> WrenchLog::takeSample() {
  std::vector<ColliderWrench> sample = meanOf(sum_, count_);
  sum_ = simulation_.wrenches();
  count_ = 0;
  return sample;
}

std::vector<ColliderWrench> WrenchLog::lastHalfSecond() const {
  std::vector<ColliderWrench> sum = simulation_.wrenches();
  for (const auto& frame : frames_) addTo(sum, frame);
  return meanOf(std::move(sum), frames_.size());
}

}  // namespace ice_ice_baby
