#include "particles_display.h"

#include <OGRE/OgreSceneNode.h>
#include <rviz/display_context.h>
#include <rviz/properties/float_property.h>

#include <pluginlib/class_list_macros.hpp>
#include <stdexcept>

#include "alpha_property.h"
#include "beside.h"
#include "placing.h"

namespace ice_ice_baby {

ParticlesDisplay::ParticlesDisplay()
    : size_m_(new rviz::FloatProperty("Size (m)", 0.0F,
                                      "Diameter of a particle; 0: the spacing of the scene.", this,
                                      SLOT(restyle()))),
      alphas_{makeAlpha("Water Alpha", 0.6F, "Opacity of water.", this),
              makeAlpha("Ice Alpha", 1.0F, "Opacity of ice.", this),
              makeAlpha("Steam Alpha", 0.12F, "Opacity of steam.", this),
              makeAlpha("Solid Alpha", 1.0F, "Opacity of floating solids.", this)} {
  size_m_->setMin(0.0F);
}

ParticlesDisplay::~ParticlesDisplay() {
  for (auto& cloud : clouds_) cloud.reset();
  if (scene_node_ != nullptr) scene_node_->removeAndDestroyAllChildren();
}

void ParticlesDisplay::onInitialize() {
  MFDClass::onInitialize();
  for (auto& cloud : clouds_) {
    cloud = std::make_unique<rviz::PointCloud>();
    cloud->setRenderMode(rviz::PointCloud::RM_SPHERES);
    // A node each, because rviz gives clouds no names and a node takes only one without.
    scene_node_->createChildSceneNode()->attachObject(cloud.get());
  }
  restyle();
}

void ParticlesDisplay::reset() {
  MFDClass::reset();
  for (auto& cloud : clouds_) {
    if (cloud) cloud->clear();
  }
}

void ParticlesDisplay::subscribe() {
  MFDClass::subscribe();
  if (!isEnabled() || topic_property_->getTopicStd().empty()) return;
  states_ = update_nh_.subscribe<State>(
      topicBeside(topic_property_->getTopicStd(), "state"), 1,
      [this](const State::ConstPtr& state) { spacing_m_ = static_cast<float>(state->spacing_m); });
}

void ParticlesDisplay::unsubscribe() {
  MFDClass::unsubscribe();
  states_.shutdown();
}

void ParticlesDisplay::restyle() {
  const float size_m = size_m_->getFloat() > 0.0F ? size_m_->getFloat() : spacing_m_;
  const float water = alphas_[indexOf(Phase::kWater)]->getFloat();
  const float ice = alphas_[indexOf(Phase::kIce)]->getFloat();
  const float freezing = water + points_.freezing * (ice - water);
  for (const Phase phase : kPhases) {
    const auto& cloud = clouds_[indexOf(phase)];
    if (!cloud) return;
    cloud->setDimensions(size_m, size_m, size_m);
    cloud->setAlpha(phase == Phase::kWater ? freezing : alphas_[indexOf(phase)]->getFloat());
  }
  context_->queueRender();
}

void ParticlesDisplay::processMessage(const sensor_msgs::PointCloud2::ConstPtr& message) {
  Place place;
  if (!findPlace(*this, *context_, message->header, place)) return;
  try {
    splitPhases(*message, points_);
  } catch (const std::invalid_argument& e) {
    setStatus(rviz::StatusProperty::Error, "Points", e.what());
    return;
  }
  setStatus(rviz::StatusProperty::Ok, "Points", QString("%1 drawn").arg(message->width));
  setStatus(
      points_.has_phases ? rviz::StatusProperty::Ok : rviz::StatusProperty::Warn, "Phase",
      points_.has_phases ? "OK" : "The cloud has no field phase: all of it is drawn as water");
  scene_node_->setPosition(place.position);
  scene_node_->setOrientation(place.orientation);
  for (const Phase phase : kPhases) {
    auto& points = points_.of[indexOf(phase)];
    clouds_[indexOf(phase)]->clear();
    clouds_[indexOf(phase)]->addPoints(points.data(), static_cast<uint32_t>(points.size()));
  }
  restyle();
}

}  // namespace ice_ice_baby

PLUGINLIB_EXPORT_CLASS(ice_ice_baby::ParticlesDisplay, rviz::Display)
