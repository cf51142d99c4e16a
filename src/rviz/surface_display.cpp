#include "surface_display.h"

#include <OGRE/OgreCamera.h>
#include <OGRE/OgreSceneNode.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/bool_property.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/vector_property.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>

#include <pluginlib/class_list_macros.hpp>

#include "alpha_property.h"
#include "beside.h"
#include "framing.h"
#include "particle_colour.h"
#include "placing.h"

namespace ice_ice_baby {
namespace {

/// A particle of steam is drawn so much wider than the spacing, so that steam is a haze.
constexpr float kSteamWidth = 4.0F;

/// The point that a view turns about; null for views that have none.
rviz::VectorProperty* focusOf(rviz::ViewController& view) {
  for (int k = 0; k < view.numChildren(); ++k) {
    if (view.childAt(k)->getName() != "Focal Point") continue;
    return dynamic_cast<rviz::VectorProperty*>(view.childAt(k));
  }
  return nullptr;
}

/// Box about what the view of a scene should show, in the fixed frame.
Eigen::AlignedBox3d boxIn(const State& state, const Ogre::Vector3& position,
                          const Ogre::Quaternion& orientation) {
  Eigen::AlignedBox3d box;
  for (const double x : {state.view_low.x, state.view_high.x}) {
    for (const double y : {state.view_low.y, state.view_high.y}) {
      for (const double z : {state.view_low.z, state.view_high.z}) {
        const Ogre::Vector3 corner =
            position + orientation * Ogre::Vector3(float(x), float(y), float(z));
        box.extend(Eigen::Vector3d(corner.x, corner.y, corner.z));
      }
    }
  }
  return box;
}

/// Whether every list of a mesh has an entry for each vertex, and triangles name only those.
bool isWhole(const SurfaceMesh& mesh) {
  const std::size_t count = mesh.vertices.size();
  if (mesh.normals.size() != count || mesh.temperatures.size() != count ||
      mesh.ice_fractions.size() != count) {
    return false;
  }
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle.vertices) {
      if (v >= count) return false;
    }
  }
  return true;
}

}  // namespace

SurfaceDisplay::SurfaceDisplay()
    : water_alpha_(makeAlpha("Water Alpha", 0.55F, "Opacity of water, seen head-on.", this)),
      ice_alpha_(makeAlpha("Ice Alpha", 1.0F, "Opacity of ice.", this)),
      steam_alpha_(makeAlpha("Steam Alpha", 0.05F, "Opacity of steam.", this)),
      frame_scene_(new rviz::BoolProperty(
          "Frame Scene", true, "Move the view when a scene starts, so that all of it is seen.",
          this)) {}

SurfaceDisplay::~SurfaceDisplay() = default;

void SurfaceDisplay::onInitialize() {
  MFDClass::onInitialize();
  water_ = std::make_unique<SurfaceObject>(*scene_manager_, *scene_node_, Phase::kWater);
  ice_ = std::make_unique<SurfaceObject>(*scene_manager_, *scene_node_, Phase::kIce);
  steam_ = std::make_unique<rviz::PointCloud>();
  steam_->setRenderMode(rviz::PointCloud::RM_SPHERES);
  scene_node_->attachObject(steam_.get());
  restyle();
}

void SurfaceDisplay::reset() {
  MFDClass::reset();
  if (!water_) return;
  water_->clear();
  ice_->clear();
  steam_->clear();
}

void SurfaceDisplay::subscribe() {
  MFDClass::subscribe();
  if (!isEnabled() || topic_property_->getTopicStd().empty()) return;
  states_ = update_nh_.subscribe<State>(topicBeside(topic_property_->getTopicStd(), "state"), 1,
                                        [this](const State::ConstPtr& state) { frame(*state); });
}

void SurfaceDisplay::unsubscribe() {
  MFDClass::unsubscribe();
  states_.shutdown();
}

void SurfaceDisplay::restyle() {
  if (!water_) return;
  water_->setOpacity(water_alpha_->getFloat());
  ice_->setOpacity(ice_alpha_->getFloat());
  steam_->setAlpha(steam_alpha_->getFloat());
  context_->queueRender();
}

void SurfaceDisplay::processMessage(const Surface::ConstPtr& message) {
  Place place;
  if (!findPlace(*this, *context_, message->header, place)) return;
  if (!isWhole(message->water) || !isWhole(message->ice)) {
    setStatus(rviz::StatusProperty::Error, "Surface",
              "The message has values for other vertices than it holds");
    return;
  }
  setStatus(
      rviz::StatusProperty::Ok, "Surface",
      QString("%1 triangles").arg(message->water.triangles.size() + message->ice.triangles.size()));
  scene_node_->setPosition(place.position);
  scene_node_->setOrientation(place.orientation);
  water_->show(message->water, message->thermal, message->spacing_m);
  ice_->show(message->ice, message->thermal, message->spacing_m);
  drawSteam(*message);
  context_->queueRender();
}

void SurfaceDisplay::drawSteam(const Surface& surface) {
  std::vector<rviz::PointCloud::Point> points(surface.steam.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    points[k].position = Ogre::Vector3(surface.steam[k].x, surface.steam[k].y, surface.steam[k].z);
    points[k].setColor(kSteamColour.red, kSteamColour.green, kSteamColour.blue);
  }
  const float width_m = kSteamWidth * surface.spacing_m;
  steam_->clear();
  steam_->setDimensions(width_m, width_m, width_m);
  steam_->addPoints(points.data(), static_cast<uint32_t>(points.size()));
}

void SurfaceDisplay::frame(const State& state) {
  if (!frame_scene_->getBool() || framed_ == state.scene) return;
  rviz::ViewController* view = context_->getViewManager()->getCurrent();
  rviz::VectorProperty* focus = view != nullptr ? focusOf(*view) : nullptr;
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  if (focus == nullptr || !context_->getFrameManager()->getTransform(
                              state.header.frame_id, ros::Time(), position, orientation)) {
    return;
  }
  framed_ = state.scene;
  const Eigen::AlignedBox3d box = boxIn(state, position, orientation);
  Orbit orbit;
  orbit.yaw = view->subProp("Yaw")->getValue().toDouble();
  orbit.pitch = view->subProp("Pitch")->getValue().toDouble();
  orbit.view_angle = view->getCamera()->getFOVy().valueRadians();
  orbit.aspect = view->getCamera()->getAspectRatio();
  const Eigen::Vector3f centre = box.center().cast<float>();
  focus->setVector(Ogre::Vector3(centre.x(), centre.y(), centre.z()));
  view->subProp("Distance")->setValue(framingDistance(box, orbit));
}

}  // namespace ice_ice_baby

PLUGINLIB_EXPORT_CLASS(ice_ice_baby::SurfaceDisplay, rviz::Display)
