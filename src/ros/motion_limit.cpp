#include "motion_limit.h"

#include "turns.h"

namespace ice_ice_baby {

namespace {

/// Rounding, and not a motion, which would wake ice that sleeps.
constexpr double kStill_m = 1e-9, kStill_rad = 1e-9;

}  // namespace

void MotionLimit::start(const Posed& pose) {
  pose_ = wanted_ = pose;
  velocity_m_s_ = Vec3d::Zero();
}

MotionLimit::Step MotionLimit::step(const Posed& wanted, double step_s) {
  const double change_m_s = bounds_.acceleration_m_s2 * step_s;
  const Vec3d along = bounded((wanted.position - wanted_.position) / step_s, bounds_.speed_m_s);
  Vec3d velocity = (wanted.position - pose_.position) / step_s;
  Step done{wanted, 0.0, 0.0};
  // In the step after this one it has to be able to go on along with the wanted pose.
  const bool free = velocity.norm() <= bounds_.speed_m_s &&
                    (velocity - velocity_m_s_).norm() <= change_m_s &&
                    (velocity - along).norm() <= change_m_s;
  if (!free) {
    const Vec3d rest = wanted.position - pose_.position - along * step_s;
    const double closing = stoppingSpeed(rest.norm(), bounds_.acceleration_m_s2, step_s);
    velocity = bounded(along + bounded(rest / step_s, closing), bounds_.speed_m_s);
    velocity = velocity_m_s_ + bounded(velocity - velocity_m_s_, change_m_s);
    done.pose.position = pose_.position + velocity * step_s;
    done.behind_m = (wanted.position - done.pose.position).norm();
  }
  const Vec3d turn = turnOf(pose_.rotation.transpose() * wanted.rotation);
  const bool still = (wanted.position - pose_.position).norm() < kStill_m &&
                     turn.norm() < kStill_rad && velocity.norm() <= change_m_s;
  if (still) {
    velocity_m_s_ = Vec3d::Zero();
    return {pose_, 0.0, 0.0};
  }
  const double max_rad = bounds_.turning_rad_s * step_s;
  if (turn.norm() > max_rad) {
    done.pose.rotation = pose_.rotation * rotationBy(bounded(turn, max_rad));
    done.behind_rad = turn.norm() - max_rad;
  }
  velocity_m_s_ = velocity;
  pose_ = done.pose;
  wanted_ = wanted;
  return done;
}

}  // namespace ice_ice_baby
