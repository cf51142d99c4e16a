// Vectors, poses and units.
//
// Units are SI, z is up, temperatures are degrees Celsius (REP 103). A dimensional scalar carries
// its unit in its name (`_m`, `_s`, `_c`, `_kg_m3`). `i` is a particle, `j` its neighbour, `h` the
// support radius of the kernel, `d` the particle spacing.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

namespace ice_ice_baby {

template <class Real>
using Vec3 = Eigen::Matrix<Real, 3, 1>;

template <class Real>
using Mat3 = Eigen::Matrix<Real, 3, 3>;

using Vec3d = Vec3<double>;

/// Index of a particle in the state arrays, which changes whenever particles are sorted by cell.
using Index = std::uint32_t;

/// Index that means: no particle, body or collider.
constexpr Index kNone = ~Index(0);

/// Pose of a body in the scene frame: a point p of the body is at `position + rotation * p`.
template <class Real>
struct Pose {
  Vec3<Real> position = Vec3<Real>::Zero();
  Mat3<Real> rotation = Mat3<Real>::Identity();

  Vec3<Real> toWorld(const Vec3<Real>& local) const { return position + rotation * local; }
  Vec3<Real> toLocal(const Vec3<Real>& world) const {
    return rotation.transpose() * (world - position);
  }
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.position, self.rotation);
  }
  template <class Other>
  Pose<Other> cast() const {
    return {position.template cast<Other>(), rotation.template cast<Other>()};
  }
};

using Posed = Pose<double>;

}  // namespace ice_ice_baby
