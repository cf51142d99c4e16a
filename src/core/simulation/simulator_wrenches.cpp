// What water and ice do to colliders, while somebody asks for it.
#include "simulation/simulator.h"

namespace ice_ice_baby {

template <class Real>
void Simulator<Real>::measureWrenches(bool measure) {
  if (!measure) return wrench_meter_.reset();
  if (wrench_meter_) return wrench_meter_->restart();
  wrench_meter_.emplace(scene_, colliders_, phases());
}

template <class Real>
std::vector<ColliderWrench> Simulator<Real>::wrenches() const {
  return wrench_meter_ ? wrench_meter_->mean() : std::vector<ColliderWrench>();
}

template <class Real>
void Simulator<Real>::endWrenches(double dt_s) {
  if (phase_change_) {
    wrench_meter_->addIce(phase_change_->contacts(), bodies(), scene_.gravity_m_s2, dt_s);
  }
  wrench_meter_->end(particles_, bodies(), scene_.gravity_m_s2, dt_s);
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
