// Lets a paused node run and prints how many seconds that took and how many clouds came meanwhile.
//
// Usage: time_node FRAMES subscribe|alone __ns:=/sim
#include <ice_ice_baby/GetState.h>
#include <ice_ice_baby/Step.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

/// Rare enough to cost the node nothing that shows.
constexpr double kLook_s = 0.02;

ice_ice_baby::State stateOf(ros::ServiceClient& client) {
  ice_ice_baby::GetState call;
  if (!client.call(call)) {
    std::fprintf(stderr, "time_node: no answer from %s\n", client.getService().c_str());
    std::exit(EXIT_FAILURE);
  }
  return call.response.state;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "time_node", ros::init_options::AnonymousName);
  if (argc != 3) return EXIT_FAILURE;
  ros::NodeHandle node;
  std::atomic<std::size_t> clouds{0};
  ros::Subscriber subscriber;
  if (std::string(argv[2]) == "subscribe") {
    subscriber = node.subscribe<sensor_msgs::PointCloud2>(
        "particles", 2, [&](const sensor_msgs::PointCloud2::ConstPtr&) { ++clouds; });
  }
  ros::AsyncSpinner spinner(1);
  spinner.start();
  ros::service::waitForService("get_state");
  ros::ServiceClient get_state = node.serviceClient<ice_ice_baby::GetState>("get_state", true);
  while (subscriber && clouds == 0) ros::WallDuration(kLook_s).sleep();

  ice_ice_baby::Step step;
  step.request.frames = static_cast<std::uint32_t>(std::atoi(argv[1]));
  const auto target = stateOf(get_state).frame + step.request.frames;
  clouds = 0;
  const ros::WallTime start = ros::WallTime::now();
  if (!ros::service::call("step", step) || !step.response.success) return EXIT_FAILURE;
  while (stateOf(get_state).frame < target) ros::WallDuration(kLook_s).sleep();
  const double wall_s = (ros::WallTime::now() - start).toSec();
  std::printf("%.4f %zu\n", wall_s, clouds.load());
  return EXIT_SUCCESS;
}
