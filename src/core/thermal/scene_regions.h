// The heat regions of a scene: where they are, and the heat that they owe the particles in them.
#pragma once

#include <vector>

#include "ice_ice_baby/scene.h"
#include "particles/particles.h"
#include "thermal/conductances.h"

namespace ice_ice_baby {

/// Each region adds up its energy frame by frame, so switching it between two thermal passes costs
/// or adds nothing. A pass spreads the energy over the particles that are inside then.
class SceneRegions {
 public:
  /// @param regions of the scene, with the values in force; must outlive it
  explicit SceneRegions(const std::vector<HeatRegionParams>& regions);

  /// Puts region k at a pose. One with a `follow_frame` heats nothing before.
  void move(std::size_t k, const Posed& pose);
  const Posed& pose(std::size_t k) const { return all_[k].pose; }

  /// Adds the energy of a frame.
  void addFrame(double frame_s);
  /// Whether one that owes heat has moved since the last pass, so that the next one is due now.
  bool moved() const;
  /// Adds the mean power that each particle receives in a pass of `step.dt_s` to `power_w`, after
  /// which no region owes anything. What is owed to an empty region is lost, as that of a heat gun
  /// that points at nothing.
  /// @param power_w (n) W
  template <class Real>
  void advance(const VectorField<Real>& x, const ThermalStep<Real>& step,
               std::vector<Real>& power_w);

  std::size_t bytes() const { return all_.capacity() * sizeof(Region); }

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    for (auto& one : self.all_) archive(one.pose, one.placed, one.moved, one.owed_j);
  }
  /// @throws InvalidInput if the state of a checkpoint is out of range
  void restore() const;

 private:
  struct Region {
    Posed pose;
    bool placed;
    bool moved = false;   ///< since the last pass
    double owed_j = 0.0;  ///< energy since the last pass
  };

  const std::vector<HeatRegionParams>& regions_;
  std::vector<Region> all_;
};

}  // namespace ice_ice_baby
