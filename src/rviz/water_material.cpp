#include "water_material.h"

#include <OGRE/OgreHighLevelGpuProgram.h>
#include <OGRE/OgreHighLevelGpuProgramManager.h>
#include <OGRE/OgreMaterialManager.h>
#include <OGRE/OgreResourceGroupManager.h>
#include <OGRE/OgreTechnique.h>

#include <string>

namespace ice_ice_baby {
namespace {

const std::string& kGroup = Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME;
constexpr const char* kVertexProgram = "ice_ice_baby/surface_vertex";
constexpr const char* kFragmentProgram = "ice_ice_baby/surface_fragment";

constexpr const char* kVertexSource = R"(#version 120
uniform mat4 to_screen, to_world;
uniform vec3 eye;
uniform float behind;
varying vec3 place, normal;
varying vec4 colour;
void main() {
  place = (to_world * gl_Vertex).xyz;
  gl_Position = to_screen * vec4(place + behind * normalize(place - eye), 1.0);
  normal = mat3(to_world) * gl_Normal;
  colour = gl_Color;
}
)";

// Schlick's approximation of what water reflects: 2 % of what comes head-on, all of what grazes.
constexpr const char* kFragmentSource = R"(#version 120
uniform vec3 eye;
uniform float opacity;
varying vec3 place, normal;
varying vec4 colour;
void main() {
  vec3 to_eye = normalize(eye - place);
  vec3 n = normalize(normal);
  if (dot(n, to_eye) < 0.0) n = -n;
  vec3 to_light = normalize(vec3(0.35, -0.45, 0.82));
  float fresnel = 0.02 + 0.98 * pow(1.0 - dot(n, to_eye), 5.0);
  float clear = 1.0 - opacity;
  vec3 mirrored = reflect(-to_eye, n);
  vec3 sky = mix(vec3(0.34, 0.40, 0.47), vec3(0.88, 0.95, 1.0), smoothstep(-0.4, 0.7, mirrored.z));
  float lit = 0.5 + 0.5 * dot(n, to_light);
  float glint = pow(max(dot(mirrored, to_light), 0.0), 80.0);
  vec3 body = mix(colour.rgb, vec3(0.55, 0.82, 0.98), 0.5 * clear) * (0.28 + 0.85 * lit * lit);
  float share = mix(0.15, 0.9, clear) * fresnel + 0.15 * clear;
  gl_FragColor = vec4(mix(body, sky, share) + (0.1 + clear) * glint,
                      clamp(mix(opacity, 1.0, fresnel) + glint, 0.0, 1.0));
}
)";

Ogre::HighLevelGpuProgramPtr program(const char* name, const char* source,
                                     Ogre::GpuProgramType type) {
  auto& manager = Ogre::HighLevelGpuProgramManager::getSingleton();
  if (manager.resourceExists(name, kGroup)) return manager.getByName(name, kGroup);
  const auto made = manager.createProgram(name, kGroup, "glsl", type);
  made->setSource(source);
  return made;
}

void shade(Ogre::Pass* pass) {
  program(kVertexProgram, kVertexSource, Ogre::GPT_VERTEX_PROGRAM);
  program(kFragmentProgram, kFragmentSource, Ogre::GPT_FRAGMENT_PROGRAM);
  pass->setVertexProgram(kVertexProgram);
  pass->setFragmentProgram(kFragmentProgram);
  const auto vertex = pass->getVertexProgramParameters();
  vertex->setNamedAutoConstant("to_screen", Ogre::GpuProgramParameters::ACT_VIEWPROJ_MATRIX);
  vertex->setNamedAutoConstant("eye", Ogre::GpuProgramParameters::ACT_CAMERA_POSITION);
  vertex->setNamedConstant("behind", 0.0F);
  vertex->setNamedAutoConstant("to_world", Ogre::GpuProgramParameters::ACT_WORLD_MATRIX);
  pass->getFragmentProgramParameters()->setNamedAutoConstant(
      "eye", Ogre::GpuProgramParameters::ACT_CAMERA_POSITION);
}

void blend(Ogre::Pass* pass) {
  pass->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  pass->setDepthWriteEnabled(false);
  shade(pass);
}

/// The far sides, then, through them, the nearest one alone: so the order of the triangles does not
/// matter, and deep water looks darker than shallow.
void drawInLayers(Ogre::Technique* technique) {
  Ogre::Pass* far = technique->getPass(0);
  blend(far);
  far->setCullingMode(Ogre::CULL_ANTICLOCKWISE);
  Ogre::Pass* depth = technique->createPass();
  shade(depth);
  depth->setColourWriteEnabled(false);
  Ogre::Pass* near = technique->createPass();
  blend(near);
}

}  // namespace

Ogre::MaterialPtr makeSurfaceMaterial(Phase phase) {
  static int count = 0;
  const auto material = Ogre::MaterialManager::getSingleton().create(
      "ice_ice_baby/surface_" + std::to_string(count++), kGroup);
  if (phase == Phase::kWater) {
    drawInLayers(material->getTechnique(0));
  } else {
    shade(material->getTechnique(0)->getPass(0));
  }
  setOpacity(material, 1.0F);
  return material;
}

void setOpacity(const Ogre::MaterialPtr& material, float opacity) {
  Ogre::Technique* technique = material->getTechnique(0);
  for (unsigned short k = 0; k < technique->getNumPasses(); ++k) {
    technique->getPass(k)->getFragmentProgramParameters()->setNamedConstant("opacity", opacity);
  }
}

void setFarSidesBehind(const Ogre::MaterialPtr& material, float behind_m) {
  material->getTechnique(0)->getPass(0)->getVertexProgramParameters()->setNamedConstant("behind",
                                                                                        behind_m);
}

}  // namespace ice_ice_baby
