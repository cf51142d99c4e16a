// The kernel whose integral over a solid is the density that the solid adds.
#pragma once

#include <functional>
#include <vector>

namespace ice_ice_baby {

/// A radial kernel W*, chosen so that its integral over a half space is the density T of a flat
/// wall. So solids of any shape add W* integrated over them, and a flat one adds exactly T. With
/// T(s) at distance s: W*(r) = T''(r) / (2 pi r).
class WallKernel {
 public:
  /// @param half_space T(s), s >= 0 in m; dimensionless
  /// @param reach_m distance beyond which T is 0
  WallKernel(const std::function<double(double)>& half_space, double reach_m);

  double reach_m() const { return reach_m_; }
  bool operator==(const WallKernel& other) const {
    return reach_m_ == other.reach_m_ && half_space_ == other.half_space_;
  }
  /// T(s); T(0) for s < 0.
  double halfSpace(double distance_m) const { return at(half_space_, distance_m); }
  /// T'(s), 1/m.
  double slope(double distance_m) const { return at(slope_, distance_m); }
  /// W*(r), 1/m^3, for r > 0.
  double value(double distance_m) const;
  /// Integral of W* r^2 from r to infinity, in every direction the same: (T - r T') / 2 pi.
  double beyond(double distance_m) const;

 private:
  double at(const std::vector<double>& table, double distance_m) const;

  double reach_m_;
  std::vector<double> half_space_, slope_, curvature_;
};

}  // namespace ice_ice_baby
