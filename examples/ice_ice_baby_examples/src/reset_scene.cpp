// Starts the scene of the argument, without one the scene that is running.
#include <ice_ice_baby/Reset.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "reset_scene");
  const ros::NodeHandle node;
  ice_ice_baby::Reset call;
  if (argc > 1) call.request.scene = argv[1];
  ros::service::waitForService("/ice_ice_baby/reset");
  ros::service::call("/ice_ice_baby/reset", call);
  ROS_INFO("%s", call.response.message.c_str());
  return call.response.success ? 0 : 1;
}
