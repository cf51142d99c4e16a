// Prints the weight that presses on the bowl of scenes/stirred.yaml.
#include <geometry_msgs/WrenchStamped.h>
#include <ros/ros.h>

void print(const geometry_msgs::WrenchStamped& message) {
  ROS_INFO("bowl: %.2f N downwards", -message.wrench.force.z);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "print_wrench");
  ros::NodeHandle node;
  const ros::Subscriber subscriber = node.subscribe("/ice_ice_baby/wrenches/bowl", 1, print);
  ros::spin();
}
