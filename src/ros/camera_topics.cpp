#include "camera_topics.h"

#include <ros/console.h>

#include <chrono>
#include <thread>
#include <utility>

#include "camera_message.h"
#include "fluid_surface.h"
#include "geometry.h"
#include "topic_name.h"

namespace ice_ice_baby {

namespace {

/// Messages that wait for a slow subscriber before the oldest is dropped.
constexpr std::uint32_t kQueue = 2;

/// Wall time that a picture waits for the transform of its stamp, in so many looks.
constexpr int kLooks = 5;
constexpr std::chrono::milliseconds kBetweenLooks{10};

void addSurface(RayScene& rays, const std::vector<ParticleSample>& samples, Phase phase,
                double spacing_m, Seen seen) {
  const FluidSurface surface = surfaceOf(samples, phase, spacing_m, SurfaceValues::kShapeOnly);
  rays.add(surface.vertices, surface.triangles, seen);
}

}  // namespace

CameraTopics::Topic::Topic(ros::NodeHandle& node, const Camera& of) : camera(of), gate(of.rate_hz) {
  const std::string name = "cameras/" + topicNameOf(camera.name);
  depth = node.advertise<sensor_msgs::Image>(name + "/depth/image_raw", kQueue);
  depth_info = node.advertise<sensor_msgs::CameraInfo>(name + "/depth/camera_info", kQueue);
  label = node.advertise<sensor_msgs::Image>(name + "/label/image_raw", kQueue);
  label_info = node.advertise<sensor_msgs::CameraInfo>(name + "/label/camera_info", kQueue);
}

bool CameraTopics::Topic::subscribed() const {
  return depth.getNumSubscribers() + label.getNumSubscribers() > 0;
}

CameraTopics::CameraTopics(const ros::NodeHandle& node, std::string scene_frame)
    : node_(node),
      scene_frame_(std::move(scene_frame)),
      listening_(node, buffer_, none_, [] {}),
      thread_({[this] { makePictures(); }}) {
  buffer_.setUsingDedicatedThread(true);
}

void CameraTopics::sceneStarted(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  if (scene.cameras.empty()) return end();
  if (!castsRays() || !makesSurfaces()) {
    ROS_ERROR("The cameras of the scene are left out: this program was built without %s",
              castsRays() ? "libopenvdb-dev" : "libembree-dev");
    return end();
  }
  const auto cameras = std::make_shared<Cameras>(scene);
  for (const Camera& camera : scene.cameras) {
    cameras->topics.push_back(std::make_unique<Topic>(node_, camera));
  }
  cameras_ = cameras;  // a topic of the same name has never been away
}

void CameraTopics::end() {
  cameras_.reset();
  listening_.want(false);
}

/// Whether there is news and it is time for it, or a subscriber is new. An eye that moves sees
/// something new of a scene that is paused, too.
bool CameraTopics::due(Topic& topic, std::uint64_t frame, bool last) {
  const std::uint32_t listeners = topic.depth.getNumSubscribers() + topic.label.getNumSubscribers();
  const bool joined = listeners > std::exchange(topic.listeners, listeners);
  if (listeners == 0) return false;
  const bool news = topic.frame != frame || !topic.camera.follow_frame.empty();
  if (!joined && !(news && topic.gate.pass(WallClock::now(), last && topic.frame != frame)))
    return false;
  topic.frame = frame;
  return true;
}

void CameraTopics::publish(const Simulation& simulation, const ros::Time& stamp, bool last) {
  if (!cameras_ || thread_.busy(0)) return;
  std::vector<const Topic*> wanted;
  bool follows = false;
  for (const auto& topic : cameras_->topics) {
    follows = follows || (topic->subscribed() && !topic->camera.follow_frame.empty());
    if (due(*topic, simulation.report().frame, last)) wanted.push_back(topic.get());
  }
  listening_.want(follows);
  if (wanted.empty()) return;
  snapshot_.stamp = stamp;
  snapshot_.spacing_m = simulation.scene().fluid.spacing_m;
  simulation.sample(snapshot_.samples, 1);
  snapshot_.places = SeenShapes::places(simulation);
  snapshot_.cameras = cameras_;
  snapshot_.due = std::move(wanted);
  thread_.request(0);
}

void CameraTopics::makePictures() {
  RayScene rays;
  addSurface(rays, snapshot_.samples, Phase::kWater, snapshot_.spacing_m, Seen::kWater);
  addSurface(rays, snapshot_.samples, Phase::kIce, snapshot_.spacing_m, Seen::kIce);
  snapshot_.cameras->shapes.addTo(rays, snapshot_.places);
  for (const Topic* topic : snapshot_.due) makePicture(rays, *topic);
  snapshot_.cameras.reset();
}

void CameraTopics::makePicture(RayScene& rays, const Topic& topic) {
  const Camera& camera = topic.camera;
  const std::optional<Posed> pose = poseNow(camera);
  if (!pose) {
    ROS_WARN_THROTTLE(10.0, "Camera %s sees nothing: tf has no frame %s", camera.name.c_str(),
                      camera.follow_frame.c_str());
    return;
  }
  std_msgs::Header header;
  header.stamp = snapshot_.stamp;
  header.frame_id =
      camera.follow_frame.empty() ? scene_frame_ + "/" + camera.name : camera.follow_frame;
  const CameraPicture picture = rays.picture(camera, *pose);
  const sensor_msgs::CameraInfo info = cameraInfo(camera, header);
  if (topic.depth.getNumSubscribers() > 0) topic.depth.publish(depthMessage(picture, header));
  if (topic.label.getNumSubscribers() > 0) topic.label.publish(labelMessage(picture, header));
  topic.depth_info.publish(info);
  topic.label_info.publish(info);
}

/// That of its stamp if it arrives soon, else the latest one.
std::optional<Posed> CameraTopics::poseNow(const Camera& camera) const {
  if (camera.follow_frame.empty()) return camera.pose();
  for (int look = 0; look <= kLooks; ++look) {
    const ros::Time when = look < kLooks ? snapshot_.stamp : ros::Time(0);
    try {
      return poseOf(buffer_.lookupTransform(scene_frame_, camera.follow_frame, when).transform);
    } catch (const tf2::TransformException&) {
      if (look < kLooks) std::this_thread::sleep_for(kBetweenLooks);
    }
  }
  return std::nullopt;
}

}  // namespace ice_ice_baby
