// Particles in rviz as they look: translucent water, opaque ice, a haze of steam.
#pragma once

#ifndef Q_MOC_RUN
#include <ice_ice_baby/State.h>
#include <rviz/message_filter_display.h>
#include <sensor_msgs/PointCloud2.h>
#endif

#include <array>
#include <iterator>
#include <memory>

#include "phase_points.h"

namespace rviz {
class FloatProperty;
}

namespace ice_ice_baby {

/// Draws one cloud as three. rviz draws a cloud with an opacity per point without depth, so that
/// what is behind covers what is before; one opacity per phase leaves ice its depth.
class ParticlesDisplay : public rviz::MessageFilterDisplay<sensor_msgs::PointCloud2> {
  Q_OBJECT

 public:
  ParticlesDisplay();
  ~ParticlesDisplay() override;

  void onInitialize() override;
  void reset() override;

 private Q_SLOTS:
  void restyle();

 private:
  void subscribe() override;
  void unsubscribe() override;
  void processMessage(const sensor_msgs::PointCloud2::ConstPtr& message) override;

  rviz::FloatProperty* size_m_;
  std::array<rviz::FloatProperty*, std::size(kPhases)> alphas_;               ///< by indexOf(Phase)
  std::array<std::unique_ptr<rviz::PointCloud>, std::size(kPhases)> clouds_;  ///< by indexOf(Phase)
  PhasePoints points_;
  ros::Subscriber states_;
  float spacing_m_ = 0.018F;  ///< of the scene, once the state that comes beside the cloud tells it
};

}  // namespace ice_ice_baby
