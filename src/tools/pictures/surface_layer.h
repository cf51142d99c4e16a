// Draws particles as the smooth surface of one translucent or opaque body.
#pragma once

#include <vector>

#include "pictures/canvas.h"

namespace ice_ice_baby {

/// Draws every particle as a sphere that overlaps its neighbours, then smooths the depths of the
/// nearest ones: screen-space fluid rendering (van der Laan, Green, Sainz 2009).
class SurfaceLayer {
 public:
  explicit SurfaceLayer(float spacing_m) : spacing_m_(spacing_m) {}

  void clear(const Canvas& canvas);
  /// @param opaque depths of opaque objects in front of the layer, one per pixel
  void add(const Canvas& canvas, const Eigen::Vector3f& centre, Colour colour,
           const std::vector<float>& opaque);
  void smooth(const Canvas& canvas);

  bool at(std::size_t k) const { return thickness_m_[k] > 0.0f; }
  /// Depth of the front, m; infinite where there is none.
  const std::vector<float>& depths() const { return depths_; }
  /// Thickness of the body behind a pixel, m.
  float thickness_m(std::size_t k) const { return thickness_m_[k]; }
  /// Mean colour of the body behind a pixel.
  Colour colour(std::size_t k) const;
  /// Normal of the front in picture axes: right, down, into it.
  Eigen::Vector3f normal(const Canvas& canvas, int x, int y) const;

 private:
  float near(const Canvas& canvas, int x, int y, float depth) const;

  float spacing_m_;
  int reach_px_ = 1;
  std::vector<float> depths_;
  std::vector<float> thickness_m_;
  std::vector<Colour> colours_;  ///< times thickness
  std::vector<float> scratch_;
};

}  // namespace ice_ice_baby
