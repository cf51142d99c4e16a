// Private parameters of the node: each once, with default, range and meaning.
#pragma once

#include <XmlRpcValue.h>

#include <string>
#include <vector>

#include "ice_ice_baby/params.h"
#include "ice_ice_baby/scene_loader.h"
#include "ice_ice_baby/simulation.h"
#include "motion_limit.h"

namespace ice_ice_baby {

inline std::vector<std::string> choices(Precision) { return {"float", "double"}; }

struct NodeParameters {
  std::string scene = "container_splash";
  std::string preset;
  Precision precision = Precision::kFloat;
  int threads = 0;
  double real_time_factor = 1.0;
  bool start_paused = false;
  std::string frame_id = "world";
  std::string scene_frame = "ice_ice_baby/scene";
  Vec3d scene_position_m = Vec3d::Zero();
  Vec3d scene_rpy_deg = Vec3d::Zero();
  double particles_rate_hz = 30.0;
  int particles_stride = 1;
  bool particles_rgb = true;
  double springs_rate_hz = 2.0;
  int springs_max = 100000;
  double state_rate_hz = 10.0;
  double vessels_rate_hz = 10.0;
  double wrenches_rate_hz = 60.0;
  double solids_rate_hz = 60.0;
  double diagnostic_period = 1.0;
  double tf_delay_s = -1.0;
  double tf_wait_s = 0.5;
  double tf_max_speed_m_s = 5.0;
  double tf_max_acceleration_m_s2 = 100.0;
  double tf_max_turning_rad_s = 20.0;
  bool handles = false;
  std::string links;
  bool publish_clock = false;
  std::string checkpoint_folder;
  double autosave_s = 0.0;
  bool resume = false;
  std::string robot_description;    ///< text of that parameter, read once; "": there is none
  std::vector<Override> overrides;  ///< tree `~overrides`: keys that replace those of every scene
};

/// Bounds of what follows a tf frame or is dragged.
inline MotionBounds motionBounds(const NodeParameters& parameters) {
  return {parameters.tf_max_speed_m_s, parameters.tf_max_acceleration_m_s2,
          parameters.tf_max_turning_rad_s};
}

/// Lists every parameter except the tree of overrides, in the order of doc/ros_interface.md; see
/// params.h.
template <class Visitor>
void describe(NodeParameters& p, Visitor&& visit) {
  visit("scene", p.scene, "name of a scene, or path of a .yaml file");
  visit("preset", p.preset, "default or paper; \"\": the preset of the scene");
  visit("precision", p.precision, "float or double");
  visit("threads", p.threads, Range{0, 1024}, "number of solver threads; 0: one per core");
  visit("real_time_factor", p.real_time_factor, Range{0.0, 1000.0},
        "ratio of simulated to wall time; 0: as fast as possible");
  visit("start_paused", p.start_paused, "whether to start paused, until resume or step is called");
  visit("frame_id", p.frame_id, "parent tf frame of the scene");
  visit("scene_frame", p.scene_frame,
        "tf frame of the scene and of all published data; parent of the colliders' frames; the "
        "default begins with the namespace of the node, if it has one");
  visit("scene_position_m", p.scene_position_m, Range{-1e6, 1e6},
        "position of scene_frame in frame_id");
  visit("scene_rpy_deg", p.scene_rpy_deg, Range{-360.0, 360.0},
        "roll, pitch, yaw of scene_frame in frame_id");
  visit("particles_rate_hz", p.particles_rate_hz, Range{0.0, 1000.0},
        "point clouds per second of wall time, at most one per frame; 0: none");
  visit("particles_stride", p.particles_stride, Range{1, 1000000},
        "publish only every n-th particle, by id");
  visit("particles_rgb", p.particles_rgb,
        "whether points carry a colour: water blue, or by temperature with thermal.enabled, ice "
        "white, steam grey");
  visit("springs_rate_hz", p.springs_rate_hz, Range{0.0, 100.0},
        "spring markers per second of wall time; 0: none");
  visit("springs_max", p.springs_max, Range{0, 5000000},
        "maximum number of springs drawn; the others are left out evenly");
  visit("state_rate_hz", p.state_rate_hz, Range{0.0, 1000.0},
        "state messages per second of wall time, at most one per frame; 0: none");
  visit(
      "vessels_rate_hz", p.vessels_rate_hz, Range{0.0, 1000.0},
      "messages about vessels and gauges per second of wall time, at most one per frame; 0: none");
  visit("wrenches_rate_hz", p.wrenches_rate_hz, Range{0.0, 1000.0},
        "messages about each collider per second of wall time, at most one per frame; 0: none");
  visit("solids_rate_hz", p.solids_rate_hz, Range{0.0, 1000.0},
        "messages about floating solids per second of wall time, at most one per frame; 0: none");
  visit("diagnostic_period", p.diagnostic_period, Range{0.1, 3600.0},
        "interval between two messages on /diagnostics");
  visit("tf_delay_s", p.tf_delay_s, Range{-1.0, 2.0},
        "how far what follows a tf frame is behind it; negative: as "
        "little as the "
        "transforms allow, at most 0.5");
  visit("tf_wait_s", p.tf_wait_s, Range{0.0, 10.0},
        "wall time that a frame waits in simulated time for the transforms of its stamp");
  visit("tf_max_speed_m_s", p.tf_max_speed_m_s, Range{0.01, 1000.0},
        "largest speed of a collider, source or heat region that follows a tf frame or is dragged");
  visit("tf_max_acceleration_m_s2", p.tf_max_acceleration_m_s2, Range{0.1, 1e5},
        "its largest acceleration");
  visit("tf_max_turning_rad_s", p.tf_max_turning_rad_s, Range{0.01, 1000.0},
        "its largest angular velocity");
  visit("handles", p.handles,
        "whether rviz gets interactive markers that move colliders, sources and heat regions which "
        "follow no tf frame");
  visit("links", p.links,
        "links of robot_description whose collision geometry are colliders that follow them: names "
        "between commas, with * for any characters");
  visit("publish_clock", p.publish_clock,
        "whether to publish simulated time on /clock; refused if another node publishes it");
  visit("checkpoint_folder", p.checkpoint_folder,
        "the only folder that save and load use; \"\": ~/.ros/ice_ice_baby/ and the name of the "
        "node");
  visit("autosave_s", p.autosave_s, Range{0.0, 86400.0},
        "wall time between two automatic checkpoints; the last two are kept; 0: none");
  visit(
      "resume", p.resume,
      "whether to start from the newest complete checkpoint in checkpoint_folder, if there is one");
}

/// Reads the tree of private parameters.
/// @param node full name of the node, whose namespace is part of the default of ~scene_frame
/// @throws InvalidInput naming an unknown parameter, or the value and what is allowed
NodeParameters readParameters(const XmlRpc::XmlRpcValue& tree, const std::string& node = "/node");

/// Overrides with which the node and the reset service load a scene; the preset too, unless "".
std::vector<Override> overridesFor(const NodeParameters& parameters, const std::string& preset);

/// Markdown table of every parameter: name, default, range, meaning.
std::string parameterTable();

}  // namespace ice_ice_baby
