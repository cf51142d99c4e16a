// Particles seen as one smooth surface of a translucent or opaque body.
#pragma once

#include <vector>

#include "pictures/canvas.h"

namespace ice_ice_baby {

/// Every particle is drawn as a ball that overlaps its neighbours; the depths of the nearest ones
/// are then smoothed, as screen-space rendering of fluids does (van der Laan, Green, Sainz 2009).
class SurfaceLayer {
 public:
  explicit SurfaceLayer(float spacing_m) : spacing_m_(spacing_m) {}

  void clear(const Canvas& canvas);
  /// @param opaque depths of what hides the layer, one per pixel
  void add(const Canvas& canvas, const Eigen::Vector3f& centre, Colour colour,
           const std::vector<float>& opaque);
  void smooth(const Canvas& canvas);

  bool at(std::size_t k) const { return thickness_m_[k] > 0.0f; }
  /// Of the front, m; beyond everything where there is none.
  const std::vector<float>& depths() const { return depths_; }
  /// How much of it lies behind a pixel, m.
  float thickness_m(std::size_t k) const { return thickness_m_[k]; }
  /// The mean of all that lies behind a pixel.
  Colour colour(std::size_t k) const;
  /// Of the front, in the axes of the picture: right, down, into it.
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
