// The simulation as its users see it: the node, the tools and the tests hold this interface only.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ice_ice_baby/samples.h"
#include "ice_ice_baby/scene.h"
#include "ice_ice_baby/step_report.h"

namespace ice_ice_baby {

class StateWriter;

enum class Precision { kFloat, kDouble };

/// So many torches and sprays may be at work at once.
constexpr std::size_t kMaxHeatedRegions = 100;

/// What one stage of the step has cost since the start.
struct StageStats {
  std::string name;
  std::uint64_t calls = 0;
  double time_s = 0.0;
  std::size_t bytes = 0;  ///< memory that the stage holds now
};

/// A torch or a freezing spray: power spread evenly, by mass, over the particles in a region.
struct HeatedRegion {
  BlockShape shape = BlockShape::kSphere;  ///< kBox, or kSphere: the ellipsoid that just fits in it
  Vec3d centre_m = Vec3d::Zero();
  Vec3d size_m = Vec3d::Ones();  ///< of the box
  double power_w = 0.0;          ///< below 0 it cools; no particle leaves kTemperatureRange_c
  double duration_s = 0.0;       ///< simulated; thermal.speedup multiplies the energy as all heat

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.shape, self.centre_m, self.size_m, self.power_w, self.duration_s);
  }
};

/// A run of Algorithm 1 over one scene. Not thread safe: one thread steps and asks.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Simulates one frame, 1 / solver.frame_rate_hz of time.
  /// @throws InvalidInput where so much water came together that the lists of neighbours take too
  /// much memory; the frame is then done in part, and the next one may be tried
  virtual const StepReport& advanceFrame() = 0;

  virtual const StepReport& report() const = 0;
  virtual const Scene& scene() const = 0;

  /// Goes to `celsius` over `ramp_s` seconds from now on.
  /// @param target "": the whole scene, with heat its air, and the scene's own schedule is
  /// cancelled; with heat also the name of a collider, whose surface has a temperature from then on
  /// @throws InvalidInput outside [-273.15, 1000] degrees C or [0, 1e6] s, for an unknown collider,
  /// and for any collider without heat
  virtual void setTemperature(double celsius, double ramp_s, const std::string& target = "") = 0;

  /// Heats or cools a region from now on. @throws InvalidInput without heat, outside the ranges of
  /// requireHeatedRegion, and when kMaxHeatedRegions are at work already
  virtual void heatRegion(const HeatedRegion& region) = 0;

  /// @throws InvalidInput outside [-1e4, 1e4] m/s^2
  virtual void setGravity(const Vec3d& gravity_m_s2) = 0;

  /// Moves a collider over the next frame; `name` is that of the scene.
  /// @throws InvalidInput for an unknown name or a pose that is not finite or too far
  virtual void moveCollider(const std::string& name, const Posed& pose) = 0;

  /// Pose of a collider now. @throws InvalidInput for an unknown name
  virtual Posed colliderPose(const std::string& name) const = 0;

  /// Every `stride`-th particle, ordered by id.
  virtual void sample(std::vector<ParticleSample>& out, std::size_t stride = 1) const = 0;

  /// Volume of every particle over that of water at rest, ordered by id: more for ice, 0 for steam.
  virtual void sampleRelativeVolumes(std::vector<float>& out) const = 0;

  /// Every spring, up to `limit` of them, evenly thinned.
  virtual void sampleSprings(std::vector<SpringSample>& out, std::size_t limit) const = 0;

  /// Stages that this scene holds now, in the order of Algorithm 1.
  virtual std::vector<StageStats> stages() const = 0;

  /// Hash of the bits of all that decides on the frames to come, the scene included. Two
  /// simulations with the same hash go on alike.
  virtual std::uint64_t stateHash() const = 0;

  virtual Precision precision() const = 0;
  /// Writes all that is hashed and the report: encodeCheckpoint makes a checkpoint of it.
  virtual void write(StateWriter& writer) const = 0;
};

/// @param threads threads to use, 0: all of the machine's
/// @throws InvalidInput for a scene that validate() refuses or that this machine has no memory for,
/// and for more than 1024 threads
std::unique_ptr<Simulation> makeSimulation(const Scene& scene,
                                           Precision precision = Precision::kFloat,
                                           int threads = 0);

/// The checks that setTemperature, setGravity and moveCollider make, for callers that queue them.
void requireTemperature(double celsius, double ramp_s);
void requireTarget(const Scene& scene, const std::string& target);
/// Sizes 0 ... 200 m, power up to 1e9 W either way, duration 0 ... 1e6 s.
void requireHeatedRegion(const Scene& scene, const HeatedRegion& region);
void requireGravity(const Vec3d& gravity_m_s2);

}  // namespace ice_ice_baby
