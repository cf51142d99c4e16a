// Prints how much water each vessel holds and how high it stands.
#include <ice_ice_baby/Vessels.h>
#include <ros/ros.h>

void print(const ice_ice_baby::Vessels& message) {
  for (const ice_ice_baby::Vessel& v : message.vessels) {
    ROS_INFO("%s: %.3f l, level %.3f m", v.name.c_str(), 1000 * v.water_m3, v.level_m);
  }
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "print_vessels");
  ros::NodeHandle node;
  const ros::Subscriber subscriber = node.subscribe("/ice_ice_baby/vessels", 1, print);
  ros::spin();
}
