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
#include "successor.h"

namespace ice_ice_baby {

namespace {

/// Shutdown waits this long for the frame under way.
constexpr double kPatience_s = 1.0;
/// Longest shutdown: roscpp would wait forever for a master that accepts connections and never
/// answers.
constexpr unsigned kMaxShutdown_s = 3;

constexpr const char* kUsage =
    "Usage: rosrun ice_ice_baby simulation_node [_parameter:=value ...]\n"
    "Serves a simulation of water that freezes and melts. `--parameters` lists the parameters.\n";

/// Until ros::start, which may follow a long wait for the master, roscpp handles no signals.
void endAtOnce(int) { _exit(EXIT_SUCCESS); }

void endInOrder(int) {
  alarm(kMaxShutdown_s);
  ros::requestShutdown();
}

void endTooLate(int) {
  constexpr char kWhy[] = "The ROS master does not answer; ending without unregistering\n";
  if (write(STDERR_FILENO, kWhy, sizeof kWhy - 1) < 0) _exit(EXIT_FAILURE);
  _exit(EXIT_SUCCESS);
}

void handleSignals() {
  std::signal(SIGALRM, endTooLate);
  std::signal(SIGINT, endInOrder);
  std::signal(SIGTERM, endInOrder);
}

/// Ends the process cleanly, or at once if a frame takes too long; does not return then.
int end(std::unique_ptr<SimulationNode> node, int code) {
  alarm(kMaxShutdown_s);
  const bool ended = node->stop(kPatience_s);
  std::fflush(nullptr);
  if (!ended) std::_Exit(code);  // the unfinished frame is not needed
  node.reset();
  return code;
}

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
  handleSignals();
  if (!ros::ok()) return EXIT_SUCCESS;
  const Successor successor;
  std::unique_ptr<SimulationNode> node;
  try {
    node = std::make_unique<SimulationNode>(ros::NodeHandle(), ros::NodeHandle("~"));
  } catch (const std::exception& e) {
    ROS_FATAL("%s", e.what());
    return EXIT_FAILURE;
  }
  ros::waitForShutdown();
  return end(std::move(node), successor.registered() ? EXIT_FAILURE : EXIT_SUCCESS);
}

}  // namespace ice_ice_baby
