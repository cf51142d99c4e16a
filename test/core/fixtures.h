// Clouds, lattices and small scenes that the tests share.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene.h"
#include "particles/neighbours.h"
#include "particles/particles.h"

namespace ice_ice_baby::test {

/// How often a test repeats what it does: under a sanitizer, which makes it ten times as slow, a
/// fifth as often.
constexpr int repeats(int count) {
#ifdef IIB_SANITIZED
  return (count + 4) / 5;
#else
  return count;
#endif
}

/// Gives the same numbers on every machine; std::uniform_real_distribution need not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * double(engine_() >> 11) * 0x1p-53;
  }
  Vec3d inBox(const Vec3d& low, const Vec3d& high) {
    Vec3d point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = uniform(low[axis], high[axis]);
    return point;
  }
  Vec3d direction() {
    for (;;) {
      const Vec3d v = inBox(-Vec3d::Ones(), Vec3d::Ones());
      if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
    }
  }
  /// A step in any direction, from a micrometre to a kilometre long.
  Vec3d anyStep() { return direction() * std::pow(10.0, uniform(-6.0, 3.0)); }

 private:
  std::mt19937_64 engine_;
};

inline std::vector<Vec3d> randomPoints(std::size_t count, const Vec3d& low, const Vec3d& high,
                                       std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3d> points(count);
  for (Vec3d& point : points) point = random.inBox(low, high);
  return points;
}

/// Lattice of n x n x n points; the first is half a spacing inside `low` on each axis.
inline std::vector<Vec3d> lattice(int n, double spacing_m, const Vec3d& low = Vec3d::Zero()) {
  std::vector<Vec3d> points;
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        points.push_back(low + spacing_m * Vec3d(x + 0.5, y + 0.5, z + 0.5));
      }
    }
  }
  return points;
}

/// Message of the InvalidInput that the work throws; "" where it throws none.
template <class Work>
std::string refusalOf(const Work& work) {
  try {
    work();
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "";
}

template <class Real>
Particles<Real> particlesAt(const std::vector<Vec3d>& points) {
  Particles<Real> particles;
  particles.position.resize(points.size());
  particles.predicted.resize(points.size());
  particles.velocity.resize(points.size());
  particles.id.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    particles.position.set(i, points[i].cast<Real>());
    particles.predicted.set(i, points[i].cast<Real>());
    particles.velocity.set(i, Vec3<Real>::Zero());
    particles.id[i] = static_cast<std::uint32_t>(i);
  }
  return particles;
}

/// Particles sorted by cell, with their neighbour lists.
template <class Real>
struct Cloud {
  Cloud(const std::vector<Vec3d>& points, double support_m, double skin_m = 0.0)
      : particles(particlesAt<Real>(points)),
        neighbours(static_cast<Real>(support_m), static_cast<Real>(skin_m)) {
    particles.reorder(neighbours.sortOrder(particles.predicted));
    neighbours.build(particles.predicted);
  }

  Particles<Real> particles;
  Neighbours<Real> neighbours;
};

template <class Real>
Vec3d sumOf(const VectorField<Real>& field) {
  Vec3d sum = Vec3d::Zero();
  for (std::size_t i = 0; i < field.size(); ++i) sum += field.at(i).template cast<double>();
  return sum;
}

template <class Real>
double sumOfNorms(const VectorField<Real>& field) {
  double sum = 0.0;
  for (std::size_t i = 0; i < field.size(); ++i) sum += double(field.at(i).norm());
  return sum;
}

inline Block blockOf(const Vec3d& low, const Vec3d& high) {
  Block block;
  block.min_m = low;
  block.max_m = high;
  return block;
}

inline Container tankOf(const Vec3d& size, bool open_top, const std::string& name = "tank") {
  Container tank;
  tank.name = name;
  tank.size_m = size;
  tank.open_top = open_top;
  return tank;
}

inline Sphere ball(const Vec3d& centre, double radius_m) {
  Sphere one;
  one.name = "ball";
  one.position_m = centre;
  one.radius_m = radius_m;
  return one;
}

/// A cube of n^3 particles at a spacing of 5 cm, without gravity.
inline Scene floatingCube(int n) {
  Scene scene;
  scene.fluid.spacing_m = 0.05;
  scene.gravity_m_s2.setZero();
  scene.blocks.push_back(blockOf(Vec3d::Zero(), Vec3d::Constant(0.05 * n)));
  return scene;
}

/// A tank filled exactly by n x n x n particles at a spacing of 5 cm.
inline Scene fullTank(int n, bool open_top = false) {
  Scene scene = floatingCube(n);
  const double edge = 0.05 * n;
  scene.gravity_m_s2 = Vec3d(0, 0, -9.81);
  scene.blocks[0] = blockOf({-edge / 2, -edge / 2, 0}, {edge / 2, edge / 2, edge});
  scene.containers.push_back(tankOf(Vec3d::Constant(edge), open_top));
  return scene;
}

/// Water that falls along one side of a closed tank and splashes hard within the first second.
inline Scene splash() {
  Scene scene;
  scene.fluid.spacing_m = 0.05;
  scene.blocks.push_back(blockOf({-0.5, -0.25, 0.1}, {-0.1, 0.25, 0.7}));
  scene.containers.push_back(tankOf({1.0, 0.5, 1.0}, false));
  return scene;
}

}  // namespace ice_ice_baby::test
