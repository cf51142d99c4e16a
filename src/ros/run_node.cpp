#include "run_node.h"

#include <ros/console.h>
#include <ros/init.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>

#include "simulation_node.h"

namespace ice_ice_baby {

namespace {

/// A frame longer than this does not hold up the end of the process.
constexpr double kPatience_s = 1.0;

constexpr const char* kUsage =
    "Usage: rosrun ice_ice_baby simulation_node [_parameter:=value ...]\n"
    "Serves a scene of water that freezes and melts. `--parameters` lists the parameters.\n";

/// ros::init may wait for the master, and until ros::start nothing listens to signals.
void endAtOnce(int) { _exit(EXIT_SUCCESS); }

void endInOrder(int) { ros::requestShutdown(); }

}  // namespace

int runNode(int argc, char** argv) {
  const std::string option = argc > 1 ? argv[1] : "";
  if (option == "--parameters") {
    std::cout << parameterTable();
    return EXIT_SUCCESS;
  }
  if (option == "--help" || option == "-h") {
    std::cout << kUsage;
    return EXIT_SUCCESS;
  }
  std::signal(SIGINT, endAtOnce);
  std::signal(SIGTERM, endAtOnce);
  ros::init(argc, argv, "ice_ice_baby");
  if (argc > 1) {
    std::cerr << "Unknown argument \"" << argv[1] << "\".\n" << kUsage;
    return EXIT_FAILURE;
  }
  ros::start();  // takes over SIGINT, and waits for the master
  std::signal(SIGTERM, endInOrder);
  if (!ros::ok()) return EXIT_SUCCESS;
  std::unique_ptr<SimulationNode> node;
  try {
    node = std::make_unique<SimulationNode>(ros::NodeHandle(), ros::NodeHandle("~"));
  } catch (const std::exception& e) {
    ROS_FATAL("%s", e.what());
    return EXIT_FAILURE;
  }
  ros::waitForShutdown();
  if (node->stop(kPatience_s)) return EXIT_SUCCESS;
  std::fflush(nullptr);
  std::_Exit(EXIT_SUCCESS);  // a frame that is still under way has nothing left to save
}

}  // namespace ice_ice_baby
