// How many substeps the next frame takes.
#pragma once

#include <cstdint>

#include "ice_ice_baby/scene.h"
#include "ice_ice_baby/step_report.h"

namespace ice_ice_baby {

/// Adapts the substeps per frame to the error that is promised or, with solver.budget, to the time
/// that a frame may take.
class SubstepControl {
 public:
  /// @param scene as its user wrote it: without the values that the simulator resolves
  explicit SubstepControl(const Scene& scene);

  /// Of the next frame.
  int substeps() const { return substeps_; }

  /// Notes the wall time of the frame that ends.
  void measure(const Scene& scene, double frame_wall_s);

  /// Chooses the number for the next frame.
  /// @param scene values in force; solver.target_error is the promised error, 0 for none
  /// @param report of the frame that ends
  void follow(const Scene& scene, const StepReport& report);

  /// Takes at most `max` for the next frame, but no fewer than keep water stable.
  void limit(const Scene& scene, const StepReport& report, int max);

  /// Whether the last second of frames took at most solver.budget of real time. True without one.
  bool withinBudget(const Scene& scene) const;

  /// Lists everything but the measured time, which depends on the machine.
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.substeps_, self.fewest_);
  }
  /// @throws InvalidInput for numbers out of range
  void restore() const;

 private:
  double wantedForError(const Scene& scene, const StepReport& report) const;
  double wantedForBudget(const Scene& scene, const StepReport& report) const;

  int substeps_;
  int fewest_;                   ///< that the error may bring it down to
  std::uint64_t measured_ = 0;   ///< frames, since this object exists
  double frame_wall_s_ = 0.0;    ///< mean over about a second of frames, 0 before the first
  double substep_wall_s_ = 0.0;  ///< the same, of a substep
};

}  // namespace ice_ice_baby
