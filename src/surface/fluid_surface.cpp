#include "fluid_surface.h"

#include <cmath>

#include "base/parallel.h"
#include "level_mesh.h"
#include "smoothed_volume.h"

namespace ice_ice_baby {

namespace {

/// Shares of the way to the mean of its neighbours that a vertex moves, there and back, which
/// smooths without shrinking (G. Taubin, A signal processing approach to fair surface design,
/// 1995).
constexpr float kThere = 0.5f, kBack = -0.53f;

std::vector<const ParticleSample*> ofPhase(const std::vector<ParticleSample>& particles,
                                           Phase phase) {
  std::vector<const ParticleSample*> found;
  for (const ParticleSample& p : particles) {
    if (p.phase == phase) found.push_back(&p);
  }
  return found;
}

/// Calls visit(a, b, c) for the corners of every triangle.
template <class Visit>
void forEachTriangle(const FluidSurface& surface, const Visit& visit) {
  const auto at = [&](Index corner) { return Vec3d(surface.vertices[corner].cast<double>()); };
  for (const auto& t : surface.triangles) visit(at(t[0]), at(t[1]), at(t[2]));
}

void moveToNeighbours(FluidSurface& surface, float share) {
  std::vector<Vec3<float>> sum(surface.vertices.size(), Vec3<float>::Zero());
  std::vector<float> count(surface.vertices.size(), 0.0f);
  for (const auto& corners : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum[corners[k]] += surface.vertices[corners[(k + 1) % 3]];
      count[corners[k]] += 1;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) {
    if (count[v] > 0) surface.vertices[v] += share * (sum[v] / count[v] - surface.vertices[v]);
  }
}

/// Each the mean of the triangles around the vertex by area.
void addNormals(FluidSurface& surface) {
  surface.normals.assign(surface.vertices.size(), Vec3<float>::Zero());
  for (const auto& corners : surface.triangles) {
    const Vec3<float>&a = surface.vertices[corners[0]], &b = surface.vertices[corners[1]],
          &c = surface.vertices[corners[2]];
    const Vec3<float> twice = (b - a).cross(c - a);
    for (const Index corner : corners) surface.normals[corner] += twice;
  }
  for (Vec3<float>& normal : surface.normals) {
    const float length = normal.norm();
    normal = length > 0 ? Vec3<float>(normal / length) : Vec3<float>::UnitZ();
  }
}

/// Each the mean over the particles around the vertex by the kernel.
void addValues(const std::vector<const ParticleSample*>& particles, const SmoothedVolume& volume,
               FluidSurface& surface) {
  const std::size_t count = surface.vertices.size();
  surface.velocities.assign(count, Vec3<float>::Zero());
  surface.temperatures_c.assign(count, 0.0f);
  surface.ice_fractions.assign(count, 0.0f);
  const float reach2 = volume.reach_m() * volume.reach_m();
  parallelFor(count, [&](std::size_t v) {
    const SmoothedVolume::Block* block = volume.blockAt(surface.vertices[v]);
    if (!block) return;
    float weights = 0.0f;
    for (const Index i : block->members) {
      const ParticleSample& p = *particles[i];
      const Vec3<float> way = Vec3<float>(p.x, p.y, p.z) - surface.vertices[v];
      const float t = 1 - way.squaredNorm() / reach2;
      if (t <= 0) continue;
      const float weight = t * t * t;
      weights += weight;
      surface.velocities[v] += weight * Vec3<float>(p.vx, p.vy, p.vz);
      surface.temperatures_c[v] += weight * p.temperature_c;
      surface.ice_fractions[v] += weight * p.ice_fraction;
    }
    if (weights == 0) return;
    surface.velocities[v] /= weights;
    surface.temperatures_c[v] /= weights;
    surface.ice_fractions[v] /= weights;
  });
}

}  // namespace

FluidSurface surfaceOf(const std::vector<ParticleSample>& particles, Phase phase, double spacing_m,
                       SurfaceValues values) {
  const std::vector<const ParticleSample*> wanted = ofPhase(particles, phase);
  std::vector<Vec3<float>> positions;
  positions.reserve(wanted.size());
  for (const ParticleSample* p : wanted) positions.emplace_back(p->x, p->y, p->z);
  const SmoothedVolume volume(positions, spacing_m);
  FluidSurface surface = levelMesh(volume);
  moveToNeighbours(surface, kThere);
  moveToNeighbours(surface, kBack);
  addNormals(surface);
  if (values == SurfaceValues::kAll) addValues(wanted, volume, surface);
  return surface;
}

double FluidSurface::volume_m3() const {
  double volume = 0.0;
  forEachTriangle(*this, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    volume += a.dot(b.cross(c)) / 6;
  });
  return volume;
}

double FluidSurface::area_m2() const {
  double area = 0.0;
  forEachTriangle(*this, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    area += (b - a).cross(c - a).norm() / 2;
  });
  return area;
}

}  // namespace ice_ice_baby
