// Pictures of a simulation without a display: shaded spheres, as in rviz, written as PNG files.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/simulation.h"

namespace ice_ice_baby {

class FrameWriter {
 public:
  /// @param folder created when missing; frames are called frame_00000.png and so on, and frames of
  /// an earlier run are removed, so that the folder shows one run
  /// @throws InvalidInput when the folder cannot be made
  FrameWriter(std::string folder, const Scene& scene);

  /// Draws the particles, springs and edges of the containers. @throws InvalidInput when the file
  /// cannot be written
  void write(const Simulation& simulation);

 private:
  struct Color {
    float r, g, b;
  };
  struct Projected {
    float x, y, depth, scale;  ///< pixels, pixels, m, pixels per m
  };

  Projected project(const Eigen::Vector3f& point) const;
  void frameScene(const Scene& scene);
  void drawSphere(const Eigen::Vector3f& centre, float radius_m, Color color);
  void drawLine(const Eigen::Vector3f& a, const Eigen::Vector3f& b, Color color, float opacity);
  void drawColliders(const Simulation& simulation);
  void blend(int x, int y, float depth, Color color, float opacity);
  void save(const std::string& path) const;

  std::string folder_;
  std::size_t frames_ = 0;
  Eigen::Matrix3f camera_;  ///< rows: right, down, into the picture
  Eigen::Vector3f eye_;
  float focal_px_ = 900;
  std::vector<Color> pixels_;
  std::vector<float> depth_;
  std::vector<ParticleSample> particles_;
  std::vector<SpringSample> springs_;
};

}  // namespace ice_ice_baby
