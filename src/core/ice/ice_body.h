// One rigid body, of ice or a floating solid: pose, momenta and inertia, in double precision for
// float and double runs.
#pragma once

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Rotation by |angle| about its direction: the exponential map.
Eigen::Quaterniond quaternionBy(const Vec3d& angle_rad);

/// Where a body is. `rotation_matrix` is the matrix of `rotation`.
struct Placement {
  Vec3d centre_m = Vec3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Mat3<double> rotation_matrix = Mat3<double>::Identity();

  Placement() = default;
  Placement(const Vec3d& centre, const Eigen::Quaterniond& rotated)
      : centre_m(centre),
        rotation(rotated.normalized()),
        rotation_matrix(rotation.toRotationMatrix()) {}

  Vec3d at(const Vec3d& offset_m) const { return centre_m + rotation_matrix * offset_m; }
  bool allFinite() const { return centre_m.allFinite() && rotation_matrix.allFinite(); }
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.centre_m, self.rotation, self.rotation_matrix);
  }
};

/// Stores angular momentum rather than angular velocity, because free rotation conserves it exactly
/// while the angular velocity of an asymmetric body changes.
struct IceBody {
  Placement pose;                          ///< at the start of the substep
  Placement next;                          ///< at the end of the substep, as computed so far
  Vec3d velocity_m_s = Vec3d::Zero();      ///< of the centre of mass
  Vec3d angular_momentum = Vec3d::Zero();  ///< kg m^2/s about the centre of mass, world axes
  double mass_kg = 0.0;
  double mass_particles = 0.0;                       ///< the same in particles of water
  Mat3<double> inertia = Mat3<double>::Zero();       ///< kg m^2, body axes
  Mat3<double> mobility = Mat3<double>::Zero();      ///< its inverse
  Mat3<double> mobility_now = Mat3<double>::Zero();  ///< in world axes at `next`
  double radius_m = 0.0;  ///< distance from the centre to the farthest member
  Index first = 0;        ///< members first ... last - 1, those at the surface first
  Index last = 0;
  Index surface_last = 0;  ///< end of the members at the surface
  Index solid = kNone;     ///< its number in the scene; kNone: ice
  Index anchor = kNone;    ///< collider that carries it
  Placement hold;          ///< in the frame of that collider
  bool gripped = false;    ///< whether it goes to `grip`, whatever touches it
  Placement grip;
  double grip_s = 0.0;     ///< time left to get there
  double speed_m_s = 0.0;  ///< upper bound for any member after the latest substep
  double still_s = 0.0;    ///< how long `speed_m_s` has been below the sleep speed
  bool asleep = false;
  bool supported = false;  ///< whether something immovable carried it in the latest substep
  Index island = kNone;    ///< lowest body of its group in contact; kNone: alone

  std::size_t count() const { return last - first; }
  /// Whether something else moves it: a collider, or a gripper.
  bool carried() const { return anchor != kNone || gripped; }
  /// Whether it is immovable: asleep, or carried.
  bool held() const { return asleep || carried(); }

  /// Angular velocity for the angular momentum at a given rotation, rad/s.
  Vec3d angularVelocityAt(const Mat3<double>& rotation_matrix) const {
    return rotation_matrix * (mobility * (rotation_matrix.transpose() * angular_momentum));
  }
  Vec3d angularVelocity() const { return angularVelocityAt(next.rotation_matrix); }
  /// Upper bound of the speed of any member, m/s.
  double fastest_m_s() const { return velocity_m_s.norm() + angularVelocity().norm() * radius_m; }

  double kineticEnergy_j() const {
    return (mass_kg * velocity_m_s.squaredNorm() + angularVelocity().dot(angular_momentum)) / 2;
  }

  void moveTo(const Placement& placement);
  /// Moves `next` by a displacement and a small rotation about the centre and counts the impulse
  /// that they stand for into the momenta, as water does: v += (x* - flight) / dt.
  void push(const Vec3d& by_m, const Vec3d& rotation_rad, double dt_s);
  /// Pose after free flight of `dt_s`: midpoint rule with constant angular momentum.
  Placement flight(double dt_s) const;
  void stop();

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.pose, self.next, self.velocity_m_s, self.angular_momentum, self.mass_kg,
            self.mass_particles, self.solid, self.inertia, self.mobility, self.mobility_now,
            self.radius_m, self.first, self.last, self.surface_last, self.anchor, self.hold,
            self.gripped, self.grip, self.grip_s, self.speed_m_s, self.still_s, self.asleep,
            self.supported, self.island);
  }
};

}  // namespace ice_ice_baby
