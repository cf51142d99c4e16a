// The surface of the water as a process of its own.
#include <ros/console.h>
#include <ros/init.h>

#include <cstdlib>

#include "surface_node.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "surface");
  const ros::NodeHandle node, node_private("~");  // nothing is logged after the last handle
  try {
    const ice_ice_baby::SurfaceNode surface(node, node_private);
    ros::waitForShutdown();
  } catch (const std::exception& e) {
    ROS_FATAL("%s", e.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
