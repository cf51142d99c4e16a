// Bodies of ice without water: the loop that tests of bodies and contacts run.
#pragma once

#include <algorithm>
#include <vector>

#include "fixtures.h"
#include "ice/ice_contacts.h"

namespace ice_ice_baby::test {

/// Scene without blocks or colliders, at a spacing of 5 cm.
inline Scene iceScene(double friction = 0.05) {
  Scene scene;
  scene.fluid.spacing_m = 0.05;
  scene.ice.friction = friction;
  return scene;
}

/// Points of a block of nx x ny x nz at spacing d, centred on `centre_m` and turned by rpy.
inline std::vector<Vec3d> brick(const Vec3d& size, double spacing_m, const Vec3d& centre_m,
                                const Vec3d& rpy_deg = Vec3d::Zero()) {
  const Posed pose = poseOf(centre_m, rpy_deg);
  std::vector<Vec3d> points;
  for (int z = 0; z < size.z(); ++z) {
    for (int y = 0; y < size.y(); ++y) {
      for (int x = 0; x < size.x(); ++x) {
        const Vec3d cell = Vec3d(x, y, z) - (size - Vec3d::Ones()) / 2;
        points.push_back(pose.toWorld(spacing_m * cell));
      }
    }
  }
  return points;
}

template <class Real>
struct IceRig {
  /// @param groups points of each body
  IceRig(const Scene& rig_scene, const std::vector<std::vector<Vec3d>>& groups)
      : scene(rig_scene),
        colliders(scene, scene.fluid.spacing_m / 2),
        neighbours(Real(scene.supportRadius_m()), Real(0.3 * scene.fluid.spacing_m)),
        bodies(scene),
        contacts(scene) {
    std::vector<Vec3d> points;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      points.insert(points.end(), groups[g].begin(), groups[g].end());
      group_of_id.insert(group_of_id.end(), groups[g].size(), static_cast<Index>(g));
    }
    particles = particlesAt<Real>(points);
    particles.reorder(neighbours.sortOrder(particles.predicted));
    neighbours.build(particles.predicted);
    assign();
  }

  /// Group of each particle, in the order of the particles.
  std::vector<Index> labels() const {
    std::vector<Index> label(particles.size());
    for (std::size_t i = 0; i < label.size(); ++i) label[i] = group_of_id[particles.id[i]];
    return label;
  }
  bool assign() { return bodies.assign(particles, neighbours, labels()); }

  /// Body of the particles of a group.
  IceBody& body(Index group) {
    for (Index i = 0; i < particles.size(); ++i) {
      if (group_of_id[particles.id[i]] == group) return bodies.body(bodies.bodyOf(i));
    }
    throw std::out_of_range("no such group");
  }
  /// Sets a body going before the first substep.
  void launch(Index group, const Vec3d& velocity_m_s,
              const Vec3d& angular_velocity_rad_s = Vec3d::Zero()) {
    IceBody& b = body(group);
    b.velocity_m_s = velocity_m_s;
    b.angular_momentum = b.next.rotation_matrix * b.inertia * b.next.rotation_matrix.transpose() *
                         angular_velocity_rad_s;
  }

  void sort() {
    const std::vector<Index>& order = neighbours.sortOrder(particles.predicted);
    particles.reorder(order);
    bodies.reorder(order);
    neighbours.build(particles.predicted);
  }

  void substep(double dt_s) {
    bodies.predict(particles, colliders, scene.gravity_m_s2, dt_s);
    if (neighbours.stale(particles.predicted)) sort();
    contacts.find(bodies, particles.predicted, neighbours, colliders);
    for (int k = 0; k < iterations; ++k) contacts.solve(bodies, particles.predicted);
    contacts.contain(bodies, particles.predicted);
    bodies.finish(particles);
    bodies.updateSleep({}, dt_s);
    time_s += dt_s;
  }
  /// Advances by frames at 60 Hz.
  void run(double seconds, int substeps = 6) {
    const long frames = std::lround(seconds * 60);
    for (long k = 0; k < frames * substeps; ++k) substep(1.0 / (60 * substeps));
  }

  /// Position of the particle with that id.
  Vec3d at(std::uint32_t id) const {
    const auto place = std::find(particles.id.begin(), particles.id.end(), id);
    return particles.position.at(std::size_t(place - particles.id.begin())).template cast<double>();
  }
  std::vector<Vec3d> byId() const {
    std::vector<Vec3d> points(particles.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[particles.id[i]] = particles.position.at(i).template cast<double>();
    }
    return points;
  }
  double fastest() const {
    double max_m_s = 0.0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      max_m_s = std::max(max_m_s, double(particles.velocity.at(i).norm()));
    }
    return max_m_s;
  }
  double lowest() const {
    return double(*std::min_element(particles.position.z.begin(), particles.position.z.end()));
  }
  Vec3d momentum() const {
    Vec3d sum = Vec3d::Zero();
    for (Index b = 0; b < bodies.count(); ++b) {
      sum += bodies.body(b).mass_kg * bodies.body(b).velocity_m_s;
    }
    return sum;
  }
  /// About the origin, including the spins of bodies of one particle.
  Vec3d angularMomentum() const {
    Vec3d sum = Vec3d::Zero();
    for (Index b = 0; b < bodies.count(); ++b) {
      const IceBody& one = bodies.body(b);
      sum += one.mass_kg * one.pose.centre_m.cross(one.velocity_m_s) + one.angular_momentum;
    }
    return sum;
  }
  double energy() const {
    double sum = 0.0;
    for (Index b = 0; b < bodies.count(); ++b) {
      const IceBody& one = bodies.body(b);
      sum += one.mass_kg * one.velocity_m_s.squaredNorm() / 2 +
             one.angular_momentum.dot(one.angularVelocity()) / 2;
    }
    return sum;
  }

  Scene scene;
  Particles<Real> particles;
  Colliders<Real> colliders;
  Neighbours<Real> neighbours;
  IceBodies<Real> bodies;
  IceContacts<Real> contacts;
  std::vector<Index> group_of_id;
  int iterations = 2;
  double time_s = 0.0;
};

}  // namespace ice_ice_baby::test
