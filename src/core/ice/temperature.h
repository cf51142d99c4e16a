// The paper's temperature: one value for the whole scene, and how strict the springs are at it.
#pragma once

#include <vector>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

class Temperature {
 public:
  explicit Temperature(const Scene& scene);

  /// Advances to simulated time `time_s`, which must not decrease.
  void advanceTo(double time_s);

  /// Ramps to `target_c` over `ramp_s` from now on. Cancels the schedule of the scene.
  void set(double target_c, double ramp_s);

  double celsius() const { return celsius_; }

  /// 0 at and above onset_c, rising linearly to 1 at and below freezing_c.
  double strictness() const;

  /// Lists everything but the time, which advanceTo sets.
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.schedule_, self.celsius_, self.ramp_start_s_, self.ramp_s_, self.from_c_,
            self.target_c_);
  }
  /// @throws InvalidInput when what was read is no temperature or ramp
  void restore() const;

 private:
  void startRamp(double target_c, double ramp_s, double start_s);

  TemperatureParams params_;
  std::vector<TemperatureEvent> schedule_;  ///< events still to come, by time
  double time_s_ = 0.0;
  double celsius_;
  double ramp_start_s_ = 0.0;
  double ramp_s_ = 0.0;
  double from_c_;
  double target_c_;
};

}  // namespace ice_ice_baby
