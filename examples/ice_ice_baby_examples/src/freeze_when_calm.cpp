// Waits until the water is calm, then cools it to a degree below the freezing point of its scene.
#include <ice_ice_baby/SetTemperature.h>
#include <ice_ice_baby/State.h>
#include <ice_ice_baby/scene_loader.h>
#include <ros/ros.h>

void freezeWhenCalm(const ice_ice_baby::State& state) {
  if (state.frame < 100 || state.rms_speed_m_s > 0.05) return;
  const ice_ice_baby::Scene scene = ice_ice_baby::loadScene(state.scene);
  ice_ice_baby::SetTemperature call;
  call.request.temperature = scene.temperature.freezing_c - 1.0;
  ros::service::call("/ice_ice_baby/set_temperature", call);
  ROS_INFO("Calm after %.1f s: %s", state.time_s, call.response.message.c_str());
  ros::shutdown();
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "freeze_when_calm");
  ros::NodeHandle node;
  const ros::Subscriber subscriber = node.subscribe("/ice_ice_baby/state", 1, freezeWhenCalm);
  ros::spin();
}
