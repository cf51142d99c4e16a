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

CameraTopics::Topic::Topic(ros::NodeHandle& node, const Camera& of)
    : camera(of), joined(std::make_shared<std::atomic<bool>>(false)), gate(of.rate_hz) {
  const std::string name = "cameras/" + topicNameOf(camera.name);
  const auto joins = [flag = joined](const ros::SingleSubscriberPublisher&) { *flag = true; };
  depth = node.advertise<sensor_msgs::Image>(name + "/depth/image_raw", kQueue, joins);
  depth_info = node.advertise<sensor_msgs::CameraInfo>(name + "/depth/camera_info", kQueue);
  label = node.advertise<sensor_msgs::Image>(name + "/label/image_raw", kQueue, joins);
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

void CameraTopics::sceneStarted(const std::shared_ptr<const Scene>& scene) {
  if (scene->cameras.empty()) return end();
  if (!castsRays() || !makesSurfaces()) {
    ROS_ERROR("The cameras of the scene are left out: this program was built without %s",
              castsRays() ? "libopenvdb-dev" : "libembree-dev");
    return end();
  }
  const auto cameras = std::make_shared<Cameras>();
  cameras->scene = scene;
  for (const Camera& camera : scene->cameras) {
    cameras->topics.push_back(std::make_unique<Topic>(node_, camera));
  }
  cameras_ = cameras;  // a topic of the same name has never been away
}

void CameraTopics::end() {
  cameras_.reset();
  listening_.want(false);
}

/// Whether it is known where a camera is.
bool CameraTopics::placed(const Camera& camera) const {
  std::string why;
  if (camera.follow_frame.empty() ||
      buffer_.canTransform(scene_frame_, camera.follow_frame, ros::Time(0), &why)) {
    return true;
  }
  ROS_WARN_DELAYED_THROTTLE(10.0, "Camera %s has no place: %s", camera.name.c_str(), why.c_str());
  return false;
}

/// Whether there is news and it is time for it, or a subscriber is new. A camera that follows a
/// frame may see something else of a scene that is paused.
bool CameraTopics::due(Topic& topic, std::uint64_t frame, bool last) {
  const bool moves = !topic.camera.follow_frame.empty();
  const bool news = topic.frame != frame;
  const bool joined = topic.joined->exchange(false);
  if (!joined && !((news || moves) && topic.gate.pass(WallClock::now(), last && news))) {
    return false;
  }
  topic.frame = frame;
  return true;
}

void CameraTopics::publish(const Simulation& simulation, const ros::Time& stamp, bool last) {
  if (!cameras_ || thread_.busy(0)) return;
  std::vector<const Topic*> wanted;
  bool follows = false;
  for (const auto& topic : cameras_->topics) {
    if (!topic->subscribed()) continue;
    follows = follows || !topic->camera.follow_frame.empty();
    if (placed(topic->camera) && due(*topic, simulation.report().frame, last)) {
      wanted.push_back(topic.get());
    }
  }
  listening_.want(follows);
  if (wanted.empty()) return;
  snapshot_.stamp = stamp;
  simulation.sample(snapshot_.samples, 1);
  snapshot_.places = SeenShapes::places(simulation);
  snapshot_.cameras = cameras_;
  snapshot_.due = std::move(wanted);
  thread_.request(0);
}

void CameraTopics::makePictures() {
  const std::shared_ptr<Cameras> cameras = std::move(snapshot_.cameras);
  if (!cameras->shapes) cameras->shapes.emplace(*cameras->scene);
  const double spacing_m = cameras->scene->fluid.spacing_m;
  RayScene rays;
  addSurface(rays, snapshot_.samples, Phase::kWater, spacing_m, Seen::kWater);
  addSurface(rays, snapshot_.samples, Phase::kIce, spacing_m, Seen::kIce);
  cameras->shapes->addTo(rays, snapshot_.places);
  for (const Topic* topic : snapshot_.due) makePicture(rays, *topic);
}

void CameraTopics::makePicture(RayScene& rays, const Topic& topic) {
  const Camera& camera = topic.camera;
  std_msgs::Header header;
  header.stamp = snapshot_.stamp;
  header.frame_id =
      camera.follow_frame.empty() ? scene_frame_ + "/" + camera.name : camera.follow_frame;
  const CameraPicture picture = rays.picture(camera, poseNow(camera));
  const sensor_msgs::CameraInfo info = cameraInfo(camera, header);
  if (topic.depth.getNumSubscribers() > 0) topic.depth.publish(depthMessage(picture, header));
  if (topic.label.getNumSubscribers() > 0) topic.label.publish(labelMessage(picture, header));
  topic.depth_info.publish(info);
  topic.label_info.publish(info);
}

/// That of its stamp if it arrives soon, else the latest one. @throws tf2::TransformException
Posed CameraTopics::poseNow(const Camera& camera) const {
  if (camera.follow_frame.empty()) return camera.pose();
  const auto at = [&](const ros::Time& when) {
    return poseOf(buffer_.lookupTransform(scene_frame_, camera.follow_frame, when).transform);
  };
  for (int look = 0; look < kLooks; ++look) {
    if (buffer_.canTransform(scene_frame_, camera.follow_frame, snapshot_.stamp)) {
      return at(snapshot_.stamp);
    }
    std::this_thread::sleep_for(kBetweenLooks);
  }
  return at(ros::Time(0));
}

}  // namespace ice_ice_baby
