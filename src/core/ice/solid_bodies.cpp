// Bodies that are floating solids of the scene.
#include <algorithm>

#include "ice/ice_bodies.h"

namespace ice_ice_baby {

template <class Real>
void IceBodies<Real>::makeSolid(Index b, Index solid, const Solid& params,
                                const std::vector<Vec3d>& point_m) {
  const SolidMass& mass = solids_[solid];
  const Posed frame = params.pose();
  IceBody& body = bodies_[b];
  body.solid = solid;
  body.mass_kg = mass.mass_kg;
  body.mass_particles = mass.mass_kg / particle_kg_;
  body.inertia = mass.inertia;
  body.mobility = mass.inertia.inverse();
  body.radius_m = 0.0;
  for (Index m = body.first; m < body.last; ++m) {
    offset_[m] = point_m[place_[m]] - mass.centre_m;
    outward_[m] = frame.rotation.transpose() * outward_[m];
    body.radius_m = std::max(body.radius_m, offset_[m].norm());
  }
  body.pose = {frame.toWorld(mass.centre_m), Eigen::Quaterniond(frame.rotation)};
  body.moveTo(body.pose);
  body.velocity_m_s = params.velocity_m_s;
  body.angular_momentum =
      frame.rotation *
      (mass.inertia * (frame.rotation.transpose() * params.angular_velocity_rad_s));
  body.speed_m_s = body.fastest_m_s();
}

template <class Real>
void IceBodies<Real>::labelSolids(std::vector<Index>& label) const {
  for (const IceBody& body : bodies_) {
    if (body.solid == kNone) continue;
    const auto first = place_.begin() + body.first, last = place_.begin() + body.last;
    const Index lowest = *std::min_element(first, last);
    for (auto place = first; place != last; ++place) label[*place] = lowest;
  }
}

template <class Real>
void IceBodies<Real>::keepWhole(std::vector<char>& gone) const {
  for (const IceBody& body : bodies_) {
    if (body.solid == kNone) continue;
    const auto first = place_.begin() + body.first, last = place_.begin() + body.last;
    if (std::all_of(first, last, [&](Index i) { return gone[i] != 0; })) continue;
    for (auto place = first; place != last; ++place) gone[*place] = 0;
  }
}

template <class Real>
Index IceBodies<Real>::bodyOfSolid(Index solid) const {
  const auto found = std::find_if(bodies_.begin(), bodies_.end(),
                                  [&](const IceBody& body) { return body.solid == solid; });
  return found == bodies_.end() ? kNone : static_cast<Index>(found - bodies_.begin());
}

template <class Real>
void IceBodies<Real>::grip(Index b, const Posed& pose, double time_s) {
  IceBody& body = bodies_[b];
  body.gripped = true;
  body.grip = {pose.toWorld(solids_[body.solid].centre_m), Eigen::Quaterniond(pose.rotation)};
  body.grip_s = time_s;
  body.asleep = false;
  body.still_s = 0.0;
}

/// Pose of a gripped body at the end of the substep: its share of the way that is left, within the
/// speed limit and the largest rotation.
template <class Real>
Placement IceBodies<Real>::gripped(IceBody& body) const {
  const double share = body.grip_s > dt_s_ ? dt_s_ / body.grip_s : 1.0;
  body.grip_s = std::max(0.0, body.grip_s - dt_s_);
  const Vec3d way = share * (body.grip.centre_m - body.pose.centre_m);
  const Eigen::AngleAxisd rotation(body.grip.rotation * body.pose.rotation.conjugate());
  const double angle = share * rotation.angle();
  const double turned_m = angle * body.radius_m;
  const double fastest = max_speed_m_s_ * dt_s_ / std::max(way.norm() + turned_m, 1e-300);
  const double slowed = std::min({1.0, fastest, kMaxRotation_rad / std::max(angle, 1e-300)});
  return {body.pose.centre_m + slowed * way,
          Eigen::AngleAxisd(slowed * angle, rotation.axis()) * body.pose.rotation};
}

template <class Real>
SolidState IceBodies<Real>::solidState(Index b) const {
  const IceBody& body = bodies_[b];
  const Vec3d to_origin = -(body.pose.rotation_matrix * solids_[body.solid].centre_m);
  SolidState state;
  state.pose = {body.pose.centre_m + to_origin, body.pose.rotation_matrix};
  state.angular_velocity_rad_s = body.angularVelocity();
  state.velocity_m_s = body.velocity_m_s + state.angular_velocity_rad_s.cross(to_origin);
  state.asleep = body.asleep;
  state.held = body.gripped;
  return state;
}

template <class Real>
std::size_t IceBodies<Real>::solids() const {
  std::size_t count = 0;
  forEachSolid([&](const IceBody&) { ++count; });
  return count;
}

template class IceBodies<float>;
template class IceBodies<double>;

}  // namespace ice_ice_baby
