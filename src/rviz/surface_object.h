// The triangles of one surface in a scene of OGRE.
#pragma once

#include <OGRE/OgreManualObject.h>
#include <OGRE/OgreMaterial.h>
#include <ice_ice_baby/SurfaceMesh.h>

#include "ice_ice_baby/samples.h"

namespace ice_ice_baby {

class SurfaceObject {
 public:
  /// @param parent outlives this object
  SurfaceObject(Ogre::SceneManager& manager, Ogre::SceneNode& parent, Phase phase);
  ~SurfaceObject();
  SurfaceObject(const SurfaceObject&) = delete;
  SurfaceObject& operator=(const SurfaceObject&) = delete;

  /// Replaces what was shown before.
  /// @param thermal whether there is heat, which colours the water
  void show(const SurfaceMesh& mesh, bool thermal, float spacing_m);
  void clear();
  /// 0 hides it.
  void setOpacity(float opacity);

 private:
  Ogre::SceneManager& manager_;
  const Phase phase_;
  const Ogre::MaterialPtr material_;
  Ogre::ManualObject* object_;
  float opacity_ = 1.0F;
  bool shown_ = false;  ///< whether `object_` has triangles
};

}  // namespace ice_ice_baby
