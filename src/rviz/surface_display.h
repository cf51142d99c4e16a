// Surfaces of water and ice in rviz, with steam as a haze.
#pragma once

#ifndef Q_MOC_RUN
#include <ice_ice_baby/State.h>
#include <ice_ice_baby/Surface.h>
#include <rviz/message_filter_display.h>
#include <rviz/ogre_helpers/point_cloud.h>
#endif

#include <memory>
#include <string>

#include "ice_ice_baby/samples.h"
#include "surface_object.h"

namespace rviz {
class BoolProperty;
class FloatProperty;
}  // namespace rviz

namespace ice_ice_baby {

/// Draws the topic `surface` of a simulation. When the first state of a scene arrives beside it,
/// the current view is moved so that all of the scene is in it.
class SurfaceDisplay : public rviz::MessageFilterDisplay<Surface> {
  Q_OBJECT

 public:
  SurfaceDisplay();
  ~SurfaceDisplay() override;

  void onInitialize() override;
  void reset() override;

 private Q_SLOTS:
  void restyle();

 private:
  void subscribe() override;
  void unsubscribe() override;
  void processMessage(const Surface::ConstPtr& message) override;
  void drawSteam(const Surface& surface);
  void frame(const State& state);

  rviz::FloatProperty* water_alpha_;
  rviz::FloatProperty* ice_alpha_;
  rviz::FloatProperty* steam_alpha_;
  rviz::BoolProperty* frame_scene_;
  std::unique_ptr<SurfaceObject> water_, ice_;
  std::unique_ptr<rviz::PointCloud> steam_;
  ros::Subscriber states_;
  std::string framed_;  ///< scene that the view was moved to
};

}  // namespace ice_ice_baby
