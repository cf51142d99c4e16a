// The interface of a simulation, which the node and the tools use.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ice_ice_baby/collider_wrench.h"
#include "ice_ice_baby/samples.h"
#include "ice_ice_baby/scene.h"
#include "ice_ice_baby/solid_state.h"
#include "ice_ice_baby/step_report.h"
#include "ice_ice_baby/vessel_report.h"

namespace ice_ice_baby {

class StateWriter;

enum class Precision { kFloat, kDouble };

/// Maximum number of active heated regions.
constexpr std::size_t kMaxHeatedRegions = 100;

/// Cost of one stage of the step since the start.
struct StageStats {
  std::string name;
  std::uint64_t calls = 0;
  double time_s = 0.0;
  std::size_t bytes = 0;  ///< memory held by the stage now
};

/// A heat source or sink, such as a torch or a freezing spray. The power is distributed over the
/// particles in the region in proportion to their mass.
struct HeatedRegion {
  BlockShape shape = BlockShape::kSphere;  ///< kBox, or kSphere: ellipsoid that fits into the box
  Vec3d centre_m = Vec3d::Zero();
  Vec3d size_m = Vec3d::Ones();  ///< size of the box
  double power_w = 0.0;          ///< negative: cools; temperatures stay in kTemperatureRange_c
  double duration_s = 0.0;       ///< simulated time; thermal.speedup multiplies the energy

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.shape, self.centre_m, self.size_m, self.power_w, self.duration_s);
  }
};

/// A collider, by its name in the scene, and a pose for it.
struct ColliderPlacement {
  std::string name;
  Posed pose;
};

/// A run of Algorithm 1 for one scene. Not thread safe.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Simulates one frame, 1 / solver.frame_rate_hz of time.
  /// @throws InvalidInput if the neighbour lists of crowded water take too much memory. The frame
  /// is then incomplete, and the next one may be tried
  virtual const StepReport& advanceFrame() = 0;

  virtual const StepReport& report() const = 0;
  virtual const Scene& scene() const = 0;

  /// Ramps a temperature to `celsius` over `ramp_s` seconds from now on.
  /// @param target "": the whole scene, or the air of a thermal scene; cancels the schedule of the
  /// scene. In a thermal scene also the name of a collider, whose surface then has a temperature
  /// @throws InvalidInput outside [-273.15, 1000] degrees C or [0, 1e6] s, for an unknown collider,
  /// and for a collider if the scene is not thermal
  virtual void setTemperature(double celsius, double ramp_s, const std::string& target = "") = 0;

  /// Heats or cools a region from now on. @throws InvalidInput if the scene is not thermal, outside
  /// the ranges of requireHeatedRegion, and if kMaxHeatedRegions are already active
  virtual void heatRegion(const HeatedRegion& region) = 0;

  /// Switches a heat region of the scene on or off and changes its power from now on. scene() has
  /// the values in force.
  /// @param power_w below 0: cools; 0: unchanged
  /// @throws InvalidInput as requireHeatRegion
  virtual void setHeatRegion(const std::string& name, bool active, double power_w = 0.0) = 0;

  /// Puts a heat region of the scene at a pose. One with a `follow_frame` heats nothing until it is
  /// there. @throws InvalidInput for an unknown name or a pose that is not finite or too far
  virtual void moveHeatRegion(const std::string& name, const Posed& pose) = 0;
  /// Pose of a heat region of the scene now. @throws InvalidInput for an unknown name
  virtual Posed heatRegionPose(const std::string& name) const = 0;

  /// Opens or closes a source and changes its flow from now on. scene() has the values in force.
  /// @param flow_l_min litres per minute; 0: unchanged
  /// @throws InvalidInput as requireSource
  virtual void setSource(const std::string& name, bool open, double flow_l_min = 0.0) = 0;

  /// Moves the outlet of a source over the next frame; water leaves with its velocity too. With
  /// more than solver.max_speed_m_s it jumps there. A source with a `follow_frame` is closed until
  /// it is moved or placed.
  /// @param pose of the disc; z is the direction of the flow
  /// @throws InvalidInput for an unknown name or a pose that is not finite or too far
  virtual void moveSource(const std::string& name, const Posed& pose) = 0;
  /// Puts the outlet of a source at a pose at once, without motion. @throws InvalidInput as
  /// moveSource
  virtual void placeSource(const std::string& name, const Posed& pose) = 0;
  /// Pose of the outlet of a source now. @throws InvalidInput for an unknown name
  virtual Posed sourcePose(const std::string& name) const = 0;

  /// @throws InvalidInput outside [-1e4, 1e4] m/s^2
  virtual void setGravity(const Vec3d& gravity_m_s2) = 0;

  /// Moves a collider to a pose over the next frame; `name` is its name in the scene.
  /// @throws InvalidInput for an unknown name or a pose that is not finite or too far
  virtual void moveCollider(const std::string& name, const Posed& pose) = 0;

  /// Places colliders at once, all together, without motion: their contents go along and keep their
  /// velocity relative to them, and water where they arrive is moved out of them.
  /// @throws InvalidInput as moveCollider, and for a name that occurs twice; nothing has changed
  /// then
  virtual void placeColliders(const std::vector<ColliderPlacement>& placements) = 0;

  /// Pose of a collider now. @throws InvalidInput for an unknown name
  virtual Posed colliderPose(const std::string& name) const = 0;

  /// Floating solids that are in the scene now, in the order of the scene.
  virtual std::vector<SolidState> solids() const = 0;
  /// Pose of a floating solid now.
  /// @throws InvalidInput for an unknown name and for a solid that has left the bounds of the scene
  virtual Posed solidPose(const std::string& name) const = 0;

  /// Moves a solid to a pose over the next frame, as a gripper does: nothing holds it up, it pushes
  /// water, ice and other solids aside, and passes through colliders. It moves no faster than
  /// solver.max_speed_m_s. It stays where it is then, until it is moved again or let go.
  /// @throws InvalidInput for an unknown name, a solid that has left the scene, or a pose that is
  /// not finite or too far
  virtual void holdSolid(const std::string& name, const Posed& pose) = 0;

  /// Lets a solid go, with the velocity that it has. No effect on one that is not held.
  /// @throws InvalidInput for an unknown name
  virtual void releaseSolid(const std::string& name) = 0;

  /// Starts to measure what water and ice do to colliders, anew if it does so already, or stops.
  /// Off, it costs nothing. It does not change the simulation and is not part of a checkpoint.
  virtual void measureWrenches(bool measure) = 0;

  /// Mean force and torque on each collider, in their order in the scene, since measuring began.
  /// The forces on all colliders together are the weight of water and ice less the change of their
  /// momentum, to rounding. Steam does not count, nor what carries water along when a collider
  /// jumps. Empty while nothing is measured; zero before the first frame.
  virtual std::vector<ColliderWrench> wrenches() const = 0;

  /// Every `stride`-th particle, ordered by id.
  virtual void sample(std::vector<ParticleSample>& out, std::size_t stride = 1) const = 0;

  /// Volume of every particle over that of water at rest, ordered by id: more for ice, 0 for steam.
  virtual void sampleRelativeVolumes(std::vector<float>& out) const = 0;

  /// Every spring, or an even selection of at most `limit`.
  virtual void sampleSprings(std::vector<SpringSample>& out, std::size_t limit) const = 0;

  /// Whether to count from now on what enters and leaves each vessel and gauge. The totals begin
  /// at 0 when counting begins, and are lost when it ends. Costs nothing while it is off.
  virtual void countFlows(bool on) = 0;

  /// Measures every vessel and gauge now, in the order containers, cups, gauges. Numbers of flows
  /// are 0 unless they are counted.
  virtual std::vector<VesselReport> vessels() const = 0;

  /// Stages that exist in this scene now, in the order of Algorithm 1.
  virtual std::vector<StageStats> stages() const = 0;

  /// Hash of all state that determines future frames, including the scene. Simulations with the
  /// same hash continue with the same bits.
  virtual std::uint64_t stateHash() const = 0;

  virtual Precision precision() const = 0;
  /// Writes the hashed state and the report, for encodeCheckpoint.
  virtual void write(StateWriter& writer) const = 0;
};

/// @param threads number of threads; 0: one per core
/// @throws InvalidInput for a scene that validate() refuses or that does not fit into memory, and
/// for more than 1024 threads
std::unique_ptr<Simulation> makeSimulation(const Scene& scene,
                                           Precision precision = Precision::kFloat,
                                           int threads = 0);

/// The checks of setTemperature, setGravity and other commands, for callers that queue these calls.
void requireTemperature(double celsius, double ramp_s);
void requireTarget(const Scene& scene, const std::string& target);
/// @throws InvalidInput for a name that is no heat region of the scene, and outside [-1e9, 1e9] W
void requireHeatRegion(const Scene& scene, const std::string& name, double power_w);
/// Checks sizes (0 to 200 m), power (-1e9 to 1e9 W) and duration (0 to 1e6 s).
void requireHeatedRegion(const Scene& scene, const HeatedRegion& region);
void requireGravity(const Vec3d& gravity_m_s2);
/// @throws InvalidInput for a name that is no source of the scene, and for a flow that is negative,
/// not finite, or faster through the disc than solver.max_speed_m_s
void requireSource(const Scene& scene, const std::string& name, double flow_l_min);

/// Number of a solid of the scene. @throws InvalidInput for an unknown name
Index requireSolid(const Scene& scene, const std::string& name);

}  // namespace ice_ice_baby
