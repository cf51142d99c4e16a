// How rigid ice is, and how still.
#pragma once

#include "metrics/error_metrics.h"

namespace ice_ice_baby {

/// `ice_drift_spacings`: from the frame in which the whole scene has frozen to the last frame of
/// ice, the root mean square distance of particles from the best-fit rigid motion of the piece that
/// they belong to, in spacings. Pieces are what springs joined when it froze: drops that froze in
/// the air fly on as they like. `ice_residual_speed_m_s`: root mean square speed over the last
/// half second before that frame; told only if it was frozen that long before.
class IceMetric final : public MetricRecorder {
 public:
  /// Nothing for a scene whose temperature never reaches freezing, or that is only sheets.
  static std::unique_ptr<IceMetric> forScene(const FrameView& start);

  void add(const FrameView& frame) override;
  void report(std::vector<ErrorMetric>& metrics) const override;

 private:
  explicit IceMetric(const Scene& scene);
  double drift_m() const;

  double spacing_m_;
  std::size_t window_;                            ///< frames of half a second
  std::vector<Vec3d> frozen_, last_;              ///< positions by id
  std::vector<std::vector<std::size_t>> pieces_;  ///< ids
  std::vector<double> speeds_m_s_;                ///< one per frame of ice
  bool melted_ = false;                           ///< since `last_`
};

}  // namespace ice_ice_baby
