// Rigidity and residual motion of ice.
#pragma once

#include "metrics/error_metrics.h"

namespace ice_ice_baby {

/// `ice_drift_spacings`: root mean square distance of the particles from the best-fit rigid motion
/// of their piece, in spacings, from the frame in which the whole scene has frozen to the last
/// frame of ice. Pieces are particles joined by springs when the scene froze, so separate drops may
/// move apart. `ice_residual_speed_m_s`: root mean square speed over the last half second before
/// that frame; reported only if the scene was frozen that long.
class IceMetric final : public MetricRecorder {
 public:
  /// Null for a scene whose temperature never reaches freezing, or that consists of sheets.
  static std::unique_ptr<IceMetric> forScene(const FrameView& start);

  void add(const FrameView& frame) override;
  void report(std::vector<ErrorMetric>& metrics) const override;

 private:
  explicit IceMetric(const Scene& scene);
  double drift_m() const;

  double spacing_m_;
  std::size_t window_;                            ///< number of frames in half a second
  std::vector<Vec3d> frozen_, last_;              ///< positions in the order of ids
  std::vector<std::vector<std::size_t>> pieces_;  ///< places in these
  std::vector<double> speeds_m_s_;                ///< one per frame of ice
  bool melted_ = false;                           ///< since `last_`
};

}  // namespace ice_ice_baby
