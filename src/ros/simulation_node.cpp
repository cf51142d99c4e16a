#include "simulation_node.h"

#include <ros/console.h>

namespace ice_ice_baby {

namespace {

ros::NodeHandle served(ros::NodeHandle node, ros::CallbackQueue& queue) {
  node.setCallbackQueue(&queue);
  return node;
}

NodeParameters parametersOf(const ros::NodeHandle& node) {
  XmlRpc::XmlRpcValue tree;
  node.getParam(node.getNamespace(), tree);
  return readParameters(tree);
}

}  // namespace

SimulationNode::SimulationNode(const ros::NodeHandle& node, const ros::NodeHandle& node_private)
    : node_(served(node, queue_)),
      private_(served(node_private, queue_)),
      parameters_(parametersOf(private_)),
      scene_(loadScene(parameters_.scene, overridesFor(parameters_, parameters_.preset))),
      clock_(node_, parameters_.publish_clock),
      frames_(node_, parameters_, scene_),
      topics_(private_, parameters_),
      simulation_(scene_, runOptions(), hooks()),
      services_(private_, parameters_, simulation_, frames_, topics_, clock_),
      diagnostics_(node_, private_, parameters_, simulation_, frames_, topics_, clock_),
      spinner_(2, &queue_),
      watch_(services_.names(), [this] { clock_.checkConflict(); }) {
  spinner_.start();
  ROS_INFO("Scene %s with %zu particles is served under %s", scene_.name.c_str(),
           simulation_.snapshot().report.particles, private_.getNamespace().c_str());
}

RunOptions SimulationNode::runOptions() const {
  RunOptions options;
  options.precision = parameters_.precision;
  options.threads = parameters_.threads;
  options.real_time_factor = parameters_.real_time_factor;
  options.ros_time = ros::Time::isSimTime() && !parameters_.publish_clock;
  options.start_paused = parameters_.start_paused;
  return options;
}

RunHooks SimulationNode::hooks() {
  RunHooks hooks;
  hooks.started = [this](const Simulation& simulation) {
    frames_.sceneStarted(simulation, clock_.stamp());
    topics_.sceneStarted(simulation, clock_.stamp());
  };
  hooks.before_frame = [this](Simulation& simulation) { frames_.moveFollowers(simulation); };
  hooks.tick = [this](const Simulation& simulation, const Snapshot& snapshot, bool settled) {
    clock_.tick(snapshot.simulated_s);
    const ros::Time stamp = clock_.stamp();
    const bool moved = frames_.publishFollowers(simulation, stamp);
    topics_.publish(simulation, snapshot, stamp, moved, settled);
  };
  return hooks;
}

}  // namespace ice_ice_baby
