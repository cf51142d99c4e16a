// A scene as plain data, as read from YAML. config/default.yaml describes every key.
#pragma once

#include <string>
#include <vector>

#include "ice_ice_baby/camera_params.h"
#include "ice_ice_baby/collider_params.h"
#include "ice_ice_baby/flow_params.h"
#include "ice_ice_baby/params.h"
#include "ice_ice_baby/solid_params.h"

namespace ice_ice_baby {

enum class BlockShape { kBox, kSphere, kCylinder };
inline std::vector<std::string> choices(BlockShape) { return {"box", "sphere", "cylinder"}; }

/// Water on a cubic lattice that fills a box, or the largest sphere or upright cylinder in it (an
/// ellipsoid or elliptic cylinder if the sides differ), rotated with its lattice about its centre.
/// With `sheet`, a cloth joined by springs that never melt.
struct Block {
  BlockShape shape = BlockShape::kBox;
  Vec3d min_m = Vec3d::Zero();
  Vec3d max_m = Vec3d::Zero();
  Vec3d rpy_deg = Vec3d::Zero();
  Vec3d velocity_m_s = Vec3d::Zero();
  Mat3<double> velocity_gradient_1_s = Mat3<double>::Zero();  ///< one row per velocity component
  Vec3d angular_velocity_rad_s = Vec3d::Zero();
  double celsius = 20.0;  ///< below freezing: starts as one body of ice; thermal scenes only
  bool sheet = false;
  bool carve = false;                   ///< leaves out particles that would touch a collider
  Vec3d copies = Vec3d::Ones();         ///< along x, y, z; expanded to blocks when read
  Vec3d copies_step_m = Vec3d::Zero();  ///< from one copy to the next
  std::string frame;  ///< collider in whose frame the block is given; "" once a scene is read

  Vec3d centre_m() const { return (min_m + max_m) / 2; }

  /// Initial velocity of water at `point_m`.
  Vec3d velocityAt(const Vec3d& point_m) const {
    const Vec3d arm = point_m - centre_m();
    return velocity_m_s + velocity_gradient_1_s * arm + angular_velocity_rad_s.cross(arm);
  }
};

/// Box without walls in which particles are counted; the water does not notice it.
struct Gauge {
  std::string name;
  Vec3d position_m = Vec3d::Zero();  ///< of its centre, in `frame`
  Vec3d rpy_deg = Vec3d::Zero();
  Vec3d size_m = Vec3d::Constant(0.1);
  std::string frame;  ///< collider that it moves with; "": it stands still in the scene
};

/// Largest number of gauges in a scene.
constexpr std::size_t kMaxGauges = 50;

/// Region that heats what is in it while it is active, or cools it: a heat gun, a freezing spray.
/// The power is distributed over the particles in it in proportion to their mass.
struct HeatRegionParams {
  std::string name;
  BlockShape shape = BlockShape::kSphere;  ///< kBox, or kSphere: ellipsoid that fits into the box
  Vec3d position_m = Vec3d::Zero();        ///< of its centre, in `follow_frame` if it has one
  Vec3d rpy_deg = Vec3d::Zero();
  Vec3d size_m = Vec3d::Constant(0.1);  ///< of the box
  double power_w = 0.0;                 ///< negative: cools; never 0 in a valid scene
  bool active = true;
  std::string follow_frame;

  /// Pose in the scene frame, or in `follow_frame`.
  Posed pose() const { return poseOf(position_m, rpy_deg); }
};

/// Largest number of heat regions in a scene.
constexpr std::size_t kMaxHeatRegions = 50;

/// Scheduled change of temperature. A call of setTemperature cancels the remaining schedule.
struct TemperatureEvent {
  double at_s = 0.0;
  double celsius = 20.0;
  double ramp_s = 0.0;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.at_s, self.celsius, self.ramp_s);
  }
};

/// Bounds of the substeps per frame that an error may take.
constexpr int kMinSubsteps = 2, kMaxSubsteps = 64;

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
  BoundsParams bounds;
  LimitParams limits;
  std::vector<TemperatureEvent> schedule;
  std::vector<Block> blocks;
  std::vector<Gauge> gauges;
  std::vector<Source> sources;
  std::vector<Drain> drains;
  std::vector<HeatRegionParams> heat_regions;
  std::vector<Solid> solids;
  std::vector<Camera> cameras;

  /// Support radius h in force, m, with 0 resolved.
  double supportRadius_m() const;
  /// Substeps per frame in force; those of the first frame if their number is adapted.
  int substeps() const;
  /// Substeps per frame that an adapted number never falls below: 3, 5 or 10 by quality,
  /// kMinSubsteps with a target error or a budget.
  int fewestSubsteps() const;
  /// Substeps per frame in which gravity moves water by at most 0.008 spacings each; at most
  /// kMaxSubsteps.
  int substepsForFall() const;
  /// Mean density error that the scene asks for, as a fraction; 0 with the preset of the paper or a
  /// solver.budget.
  double promisedError() const;
  /// Whether the number of substeps follows the error or the time that frames take.
  bool adaptsSubsteps() const {
    return solver.target_error > 0.0 || solver.budget > 0.0 || solver.substeps == 0;
  }
  /// Whether a block starts as ice: in a thermal scene, below the freezing point.
  bool startsFrozen(const Block& block) const;
  /// Lattice spacing of a block, m; that of ice if it starts frozen.
  double spacing_m(const Block& block) const;
  /// Factor on lambda in force, with 0 resolved; derived in doc/algorithm.md.
  double relaxation() const;
  /// Whether particles differ in phase: with heat, or with solids.
  bool hasPhases() const { return thermal.enabled || !solids.empty(); }
};

constexpr Range kGravityRange_m_s2{-1e4, 1e4};

/// Number of particles that the scene spawns. A sphere or cylinder whose box holds more than four
/// times limits.max_particles counts as the whole box, because the scene exceeds the limit anyway.
/// Blocks that hold more than that all together count whole, even with `carve`.
std::int64_t particleCount(const Scene& scene);

/// Checks every value against its range, and combinations of values: freezing below onset, a kernel
/// that reaches a sensible number of neighbours, constants that can be a fluid, and water that does
/// not overlap anything at the start (requireFreeSpawn).
/// @throws InvalidInput
void validate(const Scene& scene);

/// Sets the keys that define the method to those of the paper; the default preset changes nothing.
/// The paper's h = 0.03 m and m = 1 kg hold at its spacing of 0.0211 m. At another spacing h scales
/// with the spacing and m with its cube, which is the same method at another scale.
void applyPreset(Scene& scene, Preset preset, double spacing_m);

}  // namespace ice_ice_baby
