// Sources and drains that the tests share.
#pragma once

#include "fixtures.h"

namespace ice_ice_baby::test {

inline Source tap(const Vec3d& position_m, double radius_m, double speed_m_s) {
  Source source;
  source.name = "tap";
  source.position_m = position_m;
  source.radius_m = radius_m;
  source.speed_m_s = speed_m_s;
  return source;
}

inline Drain outflow(const Vec3d& min_m, const Vec3d& max_m, double rate_l_min = 0.0) {
  Drain drain;
  drain.name = "outflow";
  drain.min_m = min_m;
  drain.max_m = max_m;
  drain.rate_l_min = rate_l_min;
  return drain;
}

/// A jet of the source without gravity and without anything around it.
inline Scene jet(const Source& source, double spacing_m) {
  Scene scene;
  scene.fluid.spacing_m = spacing_m;
  scene.gravity_m_s2.setZero();
  scene.sources = {source};
  return scene;
}

/// Particles per second that the source should emit.
inline double particles_1_s(const Source& source, double spacing_m) {
  return source.flowInForce_m3_s() / (spacing_m * spacing_m * spacing_m);
}

}  // namespace ice_ice_baby::test
