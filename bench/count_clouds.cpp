// Subscribes to a point cloud and prints how many came, when it is told to end.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstdio>

int main(int argc, char** argv) {
  ros::init(argc, argv, "count_clouds", ros::init_options::AnonymousName);
  ros::NodeHandle node;
  std::size_t count = 0;
  const auto subscriber = node.subscribe<sensor_msgs::PointCloud2>(
      argc > 1 ? argv[1] : "particles", 2,
      [&](const sensor_msgs::PointCloud2::ConstPtr&) { ++count; });
  ros::spin();
  std::printf("%zu\n", count);
  return 0;
}
