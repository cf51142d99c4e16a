// How surfaces of water and ice are shaded.
#pragma once

#include <OGRE/OgreMaterial.h>

#include "ice_ice_baby/samples.h"

namespace ice_ice_baby {

/// A material of its own for one display: translucent with a bright edge for water, opaque and soft
/// for ice. The colour of each vertex is that of the surface.
Ogre::MaterialPtr makeSurfaceMaterial(Phase phase);

/// Opacity of what faces the eye, 0 ... 1; edges reflect more and hide more.
void setOpacity(const Ogre::MaterialPtr& material, float opacity);

/// Draws far sides of water so much farther away that what touches them covers them; m.
void setFarSidesBehind(const Ogre::MaterialPtr& material, float behind_m);

}  // namespace ice_ice_baby
