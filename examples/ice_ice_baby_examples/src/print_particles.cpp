// Prints how many particles there are and how cold the coldest one is.
#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>

void print(const sensor_msgs::PointCloud2& cloud) {
  float coldest = 1000.0f;
  sensor_msgs::PointCloud2ConstIterator<float> celsius(cloud, "temperature");
  for (; celsius != celsius.end(); ++celsius) coldest = std::min(coldest, *celsius);
  ROS_INFO("%u particles, coldest %.1f degrees Celsius", cloud.width, coldest);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "print_particles");
  ros::NodeHandle node;
  const ros::Subscriber subscriber = node.subscribe("/ice_ice_baby/particles", 1, print);
  ros::spin();
}
