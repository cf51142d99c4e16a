// What the tests of surfaces share.
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "fluid_surface.h"

namespace ice_ice_baby::test {

/// Skips tests where surfaces are refused.
class SurfaceCase : public testing::Test {
 protected:
  void SetUp() override {
    if (!makesSurfaces()) GTEST_SKIP() << "this build makes no surfaces";
  }
};

/// A particle of water for every place of a lattice for which wanted(place) is true.
template <class Wanted>
std::vector<ParticleSample> waterWhere(double spacing_m, double half_m, const Wanted& wanted) {
  std::vector<ParticleSample> particles;
  const int n = static_cast<int>(half_m / spacing_m) + 1;
  for (int x = -n; x < n; ++x) {
    for (int y = -n; y < n; ++y) {
      for (int z = -n; z < n; ++z) {
        const Vec3d place = spacing_m * (Vec3d(x, y, z) + Vec3d::Constant(0.5));
        if (!wanted(place)) continue;
        ParticleSample p{};
        p.x = float(place.x());
        p.y = float(place.y());
        p.z = float(place.z());
        p.id = static_cast<std::uint32_t>(particles.size());
        particles.push_back(p);
      }
    }
  }
  return particles;
}

/// Every edge belongs to two triangles, which pass it in opposite directions.
inline bool isClosed(const FluidSurface& surface) {
  std::map<std::pair<Index, Index>, int> passed;
  for (const auto& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++passed[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : passed) {
    const auto back = passed.find({edge.second, edge.first});
    if (back == passed.end() || back->second != count) return false;
  }
  return !passed.empty();
}

}  // namespace ice_ice_baby::test
