#include "ice_ice_baby/scene.h"

#include <algorithm>
#include <cmath>

namespace ice_ice_baby {

namespace {

/// In a substep gravity moves water at most this far, in spacings; a column of 20 x 20 x 160
/// particles of 2.5 mm is unstable from 0.011 on.
constexpr double kMaxFall_d = 0.008;

}  // namespace

Posed poseOf(const Vec3d& position_m, const Vec3d& rpy_deg) {
  const Vec3d rpy = rpy_deg * (M_PI / 180.0);
  Posed pose;
  pose.position = position_m;
  pose.rotation =
      (Eigen::AngleAxisd(rpy.z(), Vec3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vec3d::UnitY()) *
       Eigen::AngleAxisd(rpy.x(), Vec3d::UnitX()))
          .toRotationMatrix();
  return pose;
}

double Scene::supportRadius_m() const {
  return fluid.support_radius_m > 0.0 ? fluid.support_radius_m : 2.0 * fluid.spacing_m;
}

bool Scene::startsFrozen(const Block& block) const {
  return thermal.enabled && !block.sheet && block.celsius < thermal.freezing_c;
}

double Scene::spacing_m(const Block& block) const {
  return startsFrozen(block) ? fluid.spacing_m / std::cbrt(ice.density_ratio) : fluid.spacing_m;
}

int Scene::fewestSubsteps() const {
  if (solver.target_error > 0.0 || solver.budget > 0.0) return kMinSubsteps;
  switch (solver.quality) {
    case Quality::kFast:
      return 3;
    case Quality::kBalanced:
      return 5;
    case Quality::kAccurate:
      return 10;
  }
  return 5;
}

int Scene::substepsForFall() const {
  const double fall_d = gravity_m_s2.norm() / (fluid.spacing_m * std::pow(solver.frame_rate_hz, 2));
  return static_cast<int>(
      std::min<double>(std::ceil(std::sqrt(fall_d / kMaxFall_d)), kMaxSubsteps));
}

int Scene::substeps() const {
  if (solver.substeps > 0) return solver.substeps;
  if (preset == Preset::kPaper) return fewestSubsteps();
  return std::max(fewestSubsteps(), substepsForFall());
}

double Scene::promisedError() const {
  if (solver.target_error > 0.0) return solver.target_error;
  if (preset == Preset::kPaper || solver.budget > 0.0) return 0.0;
  switch (solver.quality) {
    case Quality::kFast:
      return 0.01;
    case Quality::kBalanced:
      return 0.002;
    case Quality::kAccurate:
      return 0.0003;
  }
  return 0.002;
}

double Scene::relaxation() const {
  if (solver.relaxation > 0.0) return solver.relaxation;
  // After n sweeps (1 - a)^n of a mode's error is left. With the warm start the velocity made of it
  // dies out above -1/5, which an even power never falls below.
  constexpr double kLargestEigenvalue = 2.86;
  const int n = solver.iterations;
  const double a = n % 2 == 0 ? 2.0 : 1.0 + std::pow(0.2, 1.0 / n);
  return a / kLargestEigenvalue;
}

}  // namespace ice_ice_baby
