// Changes the temperature of the scene to the argument, in degrees Celsius, within 2 s.
#include <ice_ice_baby/SetTemperature.h>
#include <ros/ros.h>

#include <cstdlib>

int main(int argc, char** argv) {
  ros::init(argc, argv, "set_temperature");
  const ros::NodeHandle node;
  ice_ice_baby::SetTemperature call;
  call.request.temperature = argc > 1 ? std::atof(argv[1]) : 20.0;
  call.request.ramp_s = 2.0;
  ros::service::waitForService("/ice_ice_baby/set_temperature");
  ros::service::call("/ice_ice_baby/set_temperature", call);
  ROS_INFO("%s", call.response.message.c_str());
  return call.response.success ? 0 : 1;
}
