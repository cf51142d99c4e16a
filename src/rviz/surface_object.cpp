#include "surface_object.h"

#include <OGRE/OgreMaterialManager.h>
#include <OGRE/OgreSceneManager.h>
#include <OGRE/OgreSceneNode.h>

#include "particle_colour.h"
#include "water_material.h"

namespace ice_ice_baby {
namespace {

Ogre::ColourValue colourOf(std::uint32_t packed) {
  const Colour colour = unpacked(packed);
  return Ogre::ColourValue(colour.red, colour.green, colour.blue);
}

/// Water is drawn after everything that can be seen through it.
constexpr std::uint8_t kWaterQueue = Ogre::RENDER_QUEUE_MAIN + 1;

/// Where ice and water touch, their surfaces are the same within the noise of the particles. Ice
/// grows, and the far sides of water step back, by so many spacings, so that ice covers the water.
constexpr float kIceGrowth = 0.25F, kFarSides = 0.75F;

}  // namespace

SurfaceObject::SurfaceObject(Ogre::SceneManager& manager, Ogre::SceneNode& parent, Phase phase)
    : manager_(manager),
      phase_(phase),
      material_(makeSurfaceMaterial(phase)),
      object_(manager.createManualObject()) {
  object_->setDynamic(true);
  if (phase == Phase::kWater) object_->setRenderQueueGroup(kWaterQueue);
  parent.attachObject(object_);
}

SurfaceObject::~SurfaceObject() {
  manager_.destroyManualObject(object_);
  Ogre::MaterialManager::getSingleton().remove(material_);
}

void SurfaceObject::show(const SurfaceMesh& mesh, bool thermal, float spacing_m) {
  if (mesh.triangles.empty() || opacity_ == 0.0F) return clear();
  const float grown_m = phase_ == Phase::kIce ? kIceGrowth * spacing_m : 0.0F;
  if (phase_ == Phase::kWater) setFarSidesBehind(material_, kFarSides * spacing_m);
  object_->estimateVertexCount(mesh.vertices.size());
  object_->estimateIndexCount(3 * mesh.triangles.size());
  if (shown_) {
    object_->beginUpdate(0);
  } else {
    object_->begin(material_->getName(), Ogre::RenderOperation::OT_TRIANGLE_LIST,
                   material_->getGroup());
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Ogre::Vector3 place(mesh.vertices[v].x, mesh.vertices[v].y, mesh.vertices[v].z);
    const Ogre::Vector3 normal(mesh.normals[v].x, mesh.normals[v].y, mesh.normals[v].z);
    object_->position(place + grown_m * normal);
    object_->normal(normal);
    object_->colour(
        colourOf(surfaceColour(phase_, thermal, mesh.temperatures[v], mesh.ice_fractions[v])));
  }
  for (const Triangle& t : mesh.triangles) {
    object_->triangle(t.vertices[0], t.vertices[1], t.vertices[2]);
  }
  object_->end();
  shown_ = true;
}

void SurfaceObject::clear() {
  object_->clear();
  shown_ = false;
}

void SurfaceObject::setOpacity(float opacity) {
  opacity_ = opacity;
  if (opacity_ == 0.0F) clear();
  ice_ice_baby::setOpacity(material_, opacity);
}

}  // namespace ice_ice_baby
