// What is in a scene: plain data, as read from YAML. config/default.yaml is its manual.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/params.h"

namespace ice_ice_baby {

/// Box of water at rest on a cubic lattice; with `sheet`, a cloth joined by springs that never
/// melt.
struct Block {
  Vec3d min_m = Vec3d::Zero();
  Vec3d max_m = Vec3d::Zero();
  Vec3d velocity_m_s = Vec3d::Zero();
  bool sheet = false;
};

/// Pose whose rotation is Rz(yaw) Ry(pitch) Rx(roll), as REP 103 has it.
Posed poseOf(const Vec3d& position_m, const Vec3d& rpy_deg);

/// What containers, planes and spheres share.
struct Collider {
  std::string name;
  Vec3d position_m = Vec3d::Zero();
  Vec3d rpy_deg = Vec3d::Zero();
  double friction = 0.05;
  double opacity = 0.2;
  std::string follow_frame;

  /// Pose in the scene frame.
  Posed pose() const { return poseOf(position_m, rpy_deg); }
};

/// Box that holds water: `position_m` is the centre of its inner floor, `size_m` its inner size.
struct Container : Collider {
  Vec3d size_m = Vec3d::Ones();
  double wall_m = 0.02;
  bool open_top = true;
};

/// Ground: everything below the local z = 0. With a size, a plate of that size and thickness.
struct Plane : Collider {
  double size_x_m = 0.0;
  double size_y_m = 0.0;
  double thickness_m = 0.1;

  bool infinite() const { return size_x_m == 0.0 || size_y_m == 0.0; }
};

struct Sphere : Collider {
  double radius_m = 0.1;
};

/// Temperature set at a time by the scene itself; a set_temperature from outside cancels the rest.
struct TemperatureEvent {
  double at_s = 0.0;
  double celsius = 20.0;
  double ramp_s = 0.0;
};

struct Scene {
  std::string name = "unnamed";
  std::string description;
  Preset preset = Preset::kDefault;
  double duration_s = 10.0;
  Vec3d gravity_m_s2{0.0, 0.0, -9.81};
  FluidParams fluid;
  SolverParams solver;
  TemperatureParams temperature;
  SpringParams springs;
  LimitParams limits;
  std::vector<TemperatureEvent> schedule;
  std::vector<Block> blocks;
  std::vector<Container> containers;
  std::vector<Plane> planes;
  std::vector<Sphere> spheres;

  /// Support radius h in m and spacing d in m in force, with 0 resolved.
  double supportRadius_m() const;
};

constexpr Range kGravityRange_m_s2{-1e4, 1e4};
constexpr Range kCoordinateRange_m{-kMaxCoordinate_m, kMaxCoordinate_m};

/// Lattice points that `block` holds at spacing `spacing_m`, one coordinate triple each.
/// Spawn position of the first is half a spacing inside `min_m`; a sheet is one layer thick.
Eigen::Array<std::int64_t, 3, 1> latticeSize(const Block& block, double spacing_m);

/// Particles that the scene spawns.
std::int64_t particleCount(const Scene& scene);

/// Refuses a value out of its range, and what no single key shows to be wrong: no room in memory,
/// freezing above onset, a kernel that reaches too few or too many neighbours, a set of constants
/// that cannot be a fluid.
/// @throws InvalidInput
void validate(const Scene& scene);

/// Overwrites the keys that make a method, as NUMERICS of the paper or of the default have them.
/// The paper's h = 0.03 m, m = 1 kg hold at its own spacing of 0.0211 m; at another spacing h grows
/// with it and m with its cube, which is the same method at another scale.
void applyPreset(Scene& scene, Preset preset, double spacing_m);

}  // namespace ice_ice_baby
