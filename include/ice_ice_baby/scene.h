// What is in a scene: plain data, as read from YAML. config/default.yaml is its manual.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/collider_params.h"
#include "ice_ice_baby/params.h"

namespace ice_ice_baby {

enum class BlockShape { kBox, kSphere, kCylinder };
inline std::vector<std::string> choices(BlockShape) { return {"box", "sphere", "cylinder"}; }

/// Water on a cubic lattice that fills a box, or the ball or upright cylinder that touches all
/// sides of it (an ellipsoid or an elliptic cylinder where they differ), then turned with its
/// lattice about its centre; with `sheet`, a cloth joined by springs that never melt.
struct Block {
  BlockShape shape = BlockShape::kBox;
  Vec3d min_m = Vec3d::Zero();
  Vec3d max_m = Vec3d::Zero();
  Vec3d rpy_deg = Vec3d::Zero();
  Vec3d velocity_m_s = Vec3d::Zero();
  Mat3<double> velocity_gradient_1_s = Mat3<double>::Zero();  ///< row: of one velocity component
  Vec3d angular_velocity_rad_s = Vec3d::Zero();
  double celsius = 20.0;  ///< below freezing it starts as one body of ice; only with heat
  bool sheet = false;
  Vec3d copies = Vec3d::Ones();         ///< along x, y, z; the reader makes blocks of them
  Vec3d copies_step_m = Vec3d::Zero();  ///< from one copy to the next

  Vec3d centre_m() const { return (min_m + max_m) / 2; }

  /// Velocity with which water at `point_m` starts.
  Vec3d velocityAt(const Vec3d& point_m) const {
    const Vec3d arm = point_m - centre_m();
    return velocity_m_s + velocity_gradient_1_s * arm + angular_velocity_rad_s.cross(arm);
  }
};

/// Temperature set at a time by the scene itself; a set_temperature from outside cancels the rest.
struct TemperatureEvent {
  double at_s = 0.0;
  double celsius = 20.0;
  double ramp_s = 0.0;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.at_s, self.celsius, self.ramp_s);
  }
};

struct Scene : ColliderLists {
  std::string name = "unnamed";
  std::string description;
  Preset preset = Preset::kDefault;
  double duration_s = 10.0;
  Vec3d gravity_m_s2{0.0, 0.0, -9.81};
  FluidParams fluid;
  SolverParams solver;
  TemperatureParams temperature;
  SpringParams springs;
  ThermalParams thermal;
  IceParams ice;
  SteamParams steam;
  LimitParams limits;
  std::vector<TemperatureEvent> schedule;
  std::vector<Block> blocks;

  /// Support radius h in m and spacing d in m in force, with 0 resolved.
  double supportRadius_m() const;
  /// Substeps of a frame in force, of the first one where a target error is followed.
  int substeps() const;
  /// Whether a block starts as ice: with heat, colder than where water freezes.
  bool startsFrozen(const Block& block) const;
  /// Spacing of the lattice of a block in m: that of ice where it starts frozen.
  double spacing_m(const Block& block) const;
  /// Factor on lambda in force, with 0 resolved: doc/algorithm.md derives it.
  double relaxation() const;
};

constexpr Range kGravityRange_m_s2{-1e4, 1e4};

/// Particles that the scene spawns. A ball or a cylinder in a box of more than four times
/// limits.max_particles counts as the whole box: the scene holds too many either way.
std::int64_t particleCount(const Scene& scene);

/// Refuses a value out of its range, and what no single key shows to be wrong: no room in memory,
/// freezing above onset, a kernel that reaches too few or too many neighbours, a set of constants
/// that cannot be a fluid, water that begins where something else is (requireFreeSpawn).
/// @throws InvalidInput
void validate(const Scene& scene);

/// Overwrites the keys that make a method, as NUMERICS of the paper or of the default have them.
/// The paper's h = 0.03 m, m = 1 kg hold at its own spacing of 0.0211 m; at another spacing h grows
/// with it and m with its cube, which is the same method at another scale.
void applyPreset(Scene& scene, Preset preset, double spacing_m);

}  // namespace ice_ice_baby
