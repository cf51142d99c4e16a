// A picture with depth, and the camera that looks into the scene.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/types.h"
#include "particle_colour.h"

namespace ice_ice_baby {

/// Where a point lies in the picture, in pixels, how far into it in m, and pixels per m there.
struct Projected {
  float x, y, depth, scale;
};

class Canvas {
 public:
  Canvas(int width, int height, float focal_px);

  /// @param into direction of view, of length 1 and not vertical
  void look(const Eigen::Vector3f& eye, const Eigen::Vector3f& into);
  Projected project(const Eigen::Vector3f& point) const;

  void clear(Colour top, Colour bottom);
  /// Draws from now on only what is nearer, or further, than `depths`, one per pixel.
  void onlyNearer(const std::vector<float>& depths) { veil_ = &depths, nearer_ = true; }
  void onlyFurther(const std::vector<float>& depths) { veil_ = &depths, nearer_ = false; }
  void everything() { veil_ = nullptr; }

  /// Mixes a colour into a pixel unless something opaque is nearer; opacity 1 is opaque.
  void blend(int x, int y, float depth, Colour colour, float opacity);
  void drawSphere(const Eigen::Vector3f& centre, float radius_m, Colour colour);
  /// @param wide pixels
  void drawLine(const Eigen::Vector3f& a, const Eigen::Vector3f& b, Colour colour, float opacity,
                int wide = 1);
  void drawTriangle(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                    Colour colour, float opacity);

  int width() const { return width_; }
  int height() const { return height_; }
  float focal_px() const { return focal_px_; }
  const Eigen::Vector3f& eye() const { return eye_; }
  /// Pixels and their depths, m, row by row.
  std::vector<Colour>& pixels() { return pixels_; }
  std::vector<float>& depths() { return depths_; }
  const std::vector<float>& depths() const { return depths_; }

  /// Writes a PNG, `shrink` pixels wide and high becoming one. @throws InvalidInput when it cannot
  void save(const std::string& path, int shrink = 1) const;

 private:
  int width_, height_;
  float focal_px_;
  Eigen::Matrix3f camera_;  ///< rows: right, down, into the picture
  Eigen::Vector3f eye_;
  std::vector<Colour> pixels_;
  std::vector<float> depths_;
  const std::vector<float>* veil_ = nullptr;
  bool nearer_ = false;
};

}  // namespace ice_ice_baby
