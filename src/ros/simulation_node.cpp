#include "simulation_node.h"

#include <ros/console.h>

#include "ice_ice_baby/mesh_warnings.h"
#include "served_scene.h"

namespace ice_ice_baby {

namespace {

ros::NodeHandle served(ros::NodeHandle node, ros::CallbackQueue& queue) {
  node.setCallbackQueue(&queue);
  return node;
}

NodeParameters parametersOf(const ros::NodeHandle& node) {
  XmlRpc::XmlRpcValue tree;
  node.getParam(node.getNamespace(), tree);
  NodeParameters parameters = readParameters(tree, node.getNamespace());
  std::string key;
  if (node.searchParam("robot_description", key)) node.getParam(key, parameters.robot_description);
  return parameters;
}

/// With autosave the folder has to be usable from the start, without it only when save is called.
CheckpointFolder folderOf(const NodeParameters& parameters, const std::string& node) {
  const std::string& path = parameters.checkpoint_folder;
  CheckpointFolder folder =
      path.empty() ? CheckpointFolder::defaultFor(node) : CheckpointFolder(path);
  if (parameters.autosave_s > 0.0) {
    folder.create();
  } else if (const std::string why = folder.problem(); !why.empty()) {
    ROS_WARN("The service save will be refused: %s", why.c_str());
  }
  return folder;
}

Resumption resumptionOf(const NodeParameters& parameters, const CheckpointFolder& folder) {
  if (!parameters.resume) return {};
  Resumption resumed = resumeFrom(folder, parameters.threads);
  for (const std::string& line : resumed.broken) ROS_ERROR("Cannot resume: %s", line.c_str());
  return resumed;
}

/// ~scene is read even if it is not used, so that a mistake in it is always reported.
ServedScene sceneOf(const NodeParameters& parameters, const Resumption& resumed) {
  const Scene scene = loadServedScene(parameters, parameters.scene, parameters.preset);
  if (resumed.simulation) return resumed.simulation->scene();
  return {scene, parameters.scene};
}

}  // namespace

SimulationNode::SimulationNode(const ros::NodeHandle& node, const ros::NodeHandle& node_private)
    : node_(served(node, queue_)),
      private_(served(node_private, queue_)),
      parameters_(parametersOf(private_)),
      folder_(folderOf(parameters_, private_.getNamespace())),
      resumed_(resumptionOf(parameters_, folder_)),
      scene_(sceneOf(parameters_, resumed_)),
      clock_(node_, parameters_.publish_clock),
      frames_(node_, parameters_),
      handles_(private_, parameters_),
      topics_(private_, parameters_),
      simulation_(scene_, runOptions(), hooks(), std::move(resumed_.simulation)),
      services_(private_, parameters_, simulation_, topics_, clock_),
      checkpoints_(private_, parameters_, folder_, resumed_, simulation_),
      scene_loading_(private_, parameters_, simulation_),
      diagnostics_(node_, private_, parameters_,
                   {simulation_, frames_, topics_, clock_, checkpoints_}),
      spinner_(2, &queue_),
      watch_(serviceNames(), [this] { clock_.checkConflict(); }) {
  spinner_.start();
  const std::string from = resumed_.name.empty() ? "" : ", resumed from " + resumed_.name;
  const StepReport report = simulation_.snapshot().report;
  ROS_INFO("Serving scene %s with %zu particles under %s%s", scene_.scene.name.c_str(),
           report.particles, private_.getNamespace().c_str(), from.c_str());
}

std::vector<std::string> SimulationNode::serviceNames() const {
  std::vector<std::string> names = services_.names();
  for (const std::string& name : checkpoints_.names()) names.push_back(name);
  names.push_back(scene_loading_.name());
  return names;
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
    for (const std::string& line : meshWarnings(simulation.scene())) ROS_WARN("%s", line.c_str());
    handles_.sceneStarted(simulation);
    frames_.sceneStarted(simulation, clock_.stamp(), handles_.colliders());
    topics_.sceneStarted(simulation);
  };
  hooks.before_frame = [this](Simulation& simulation, const FrameBegin& frame) {
    frames_.moveFollowers(simulation, clock_.frameStamp(frame, frames_.follows()));
    handles_.move(simulation);
    topics_.frameBegins(simulation);
  };
  hooks.attach = [this](Simulation& simulation, const std::string& solid,
                        const std::string& frame) { frames_.attach(simulation, solid, frame); };
  hooks.tick = [this](const Simulation& simulation, const Snapshot& snapshot, bool settled) {
    clock_.tick(snapshot.simulated_s);
    const ros::Time stamp = clock_.stamp();
    const bool moved = frames_.publishFollowers(simulation, stamp);
    frames_.publishSolids(simulation, stamp);
    topics_.publish(simulation, snapshot, stamp, moved, settled);
  };
  return hooks;
}

}  // namespace ice_ice_baby
