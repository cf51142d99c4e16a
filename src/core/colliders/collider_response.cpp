// End of a path that touches one collider or several at once.
#include <algorithm>
#include <cmath>
#include <limits>

#include "colliders/colliders.h"

namespace ice_ice_baby {

namespace {

/// Maximum number of passes. A later collider may push into an earlier one; in a wedge each pass
/// halves the remaining overlap.
constexpr int kMaxPasses = 16;

/// Pushes shorter than this, in radii, need no further pass.
constexpr double kAtRest_r = 1e-4;

/// Pushes longer than this, in radii, after the last pass mean that there is no free space.
constexpr double kTrapped_r = 1e-2;

/// A path that cuts deeper than this, in radii, through a round shape does not slide around it.
constexpr double kCut_r = 0.1;

/// Free positions are searched at distances from half a radius, doubling, up to 128 radii.
constexpr int kShells = 9;

/// Nearest allowed end of a path that slides without friction.
template <class Real>
Vec3<Real> slide(const MovingShape<Real>& body, const Vec3<Real>& from, const Vec3<Real>& to) {
  const Vec3<Real> wanted = body.motion.to.toLocal(to);
  const Vec3<Real> allowed = body.shape.resolve(body.motion.from.toLocal(from), wanted);
  return allowed == wanted ? to : body.motion.to.toWorld(allowed);
}

/// Nearest allowed end of a path, with its tangential motion reduced by friction.
template <class Real>
Vec3<Real> contact(const MovingShape<Real>& body, const Vec3<Real>& from, const Vec3<Real>& to,
                   bool stick) {
  const Vec3<Real> start = body.motion.from.toLocal(from);
  const Vec3<Real> wanted = body.motion.to.toLocal(to);
  Vec3<Real> allowed = body.shape.resolve(start, wanted);
  const Vec3<Real> push = allowed - wanted;
  const Real depth = push.norm();
  if (depth == 0) return to;
  const Vec3<Real> normal = push / depth;
  const Vec3<Real> motion = allowed - start;
  const Vec3<Real> sliding = motion - motion.dot(normal) * normal;
  const Real slid = sliding.norm();
  const Real held = stick ? slid : std::min(slid, body.friction * depth);
  if (held > 0) allowed = body.shape.resolve(start, allowed - sliding * (held / slid));
  return body.motion.to.toWorld(allowed);
}

}  // namespace

/// One pass over all colliders: end = push(body, end). @return square of the longest push, m^2
template <class Real>
template <class Push>
Real Colliders<Real>::pushAll(Vec3<Real>& end, const Push& push) const {
  Real max = 0;
  for (const Index k : push_order_) {
    const Vec3<Real> pushed = push(all_[k], end);
    max = std::max(max, (pushed - end).squaredNorm());
    end = pushed;
  }
  return max;
}

template <class Real>
Vec3<Real> Colliders<Real>::respond(const Vec3<Real>& from, const Vec3<Real>& to,
                                    bool stick) const {
  Vec3<Real> end = to;
  std::size_t pushes = 0;
  const auto push = [&](const MovingShape<Real>& body, const Vec3<Real>& wanted) {
    Vec3<Real> pushed = contact(body, from, wanted, stick);
    if (pushed != wanted) ++pushes;
    return pushed;
  };
  const bool one = count() == 1;
  const Real at_rest = static_cast<Real>(kAtRest_r) * radius_m_;
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    if (pushAll(end, push) > at_rest * at_rest && !one) continue;
    return pushes < 2 || one || !cutsRound(from, end) ? end : nearestFree(from, end);
  }
  return slideFree(from, end) ? end : nearestFree(from, end);
}

/// Whether a path passes through a round shape. A particle slides around a single one, but several
/// could push it through a gap between them that is too narrow.
template <class Real>
bool Colliders<Real>::cutsRound(const Vec3<Real>& from, const Vec3<Real>& to) const {
  return std::any_of(begin(), end(), [&](const MovingShape<Real>& body) {
    return body.shape.round() &&
           body.shape.cut(body.motion.from.toLocal(from), body.motion.to.toLocal(to)) >
               static_cast<Real>(kCut_r) * radius_m_;
  });
}

/// Repeats passes without friction until no collider pushes. @return whether there is free space
template <class Real>
bool Colliders<Real>::slideFree(const Vec3<Real>& from, Vec3<Real>& end) const {
  const auto push = [&](const MovingShape<Real>& body, const Vec3<Real>& wanted) {
    return slide(body, from, wanted);
  };
  return pushFree(push, end) && !cutsRound(from, end);
}

/// The same, sliding around round shapes in any direction.
template <class Real>
bool Colliders<Real>::slideFreeAnyWay(const Vec3<Real>& from, Vec3<Real>& end) const {
  const auto push = [&](const MovingShape<Real>& body, const Vec3<Real>& wanted) {
    const bool any_way = body.shape.round();
    return slide(body, any_way ? body.motion.from.toWorld(body.motion.to.toLocal(wanted)) : from,
                 wanted);
  };
  return pushFree(push, end);
}

template <class Real>
template <class Push>
bool Colliders<Real>::pushFree(const Push& push, Vec3<Real>& end) const {
  const Real rounding = 16 * std::numeric_limits<Real>::epsilon() * end.template lpNorm<1>();
  const Real free = std::max(static_cast<Real>(kTrapped_r) * radius_m_, rounding);
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    if (pushAll(end, push) <= free * free) return true;
  }
  return false;
}

/// Part of the path, or its start, or a position beside a collider that moved there.
template <class Real>
Vec3<Real> Colliders<Real>::nearestFree(const Vec3<Real>& from, const Vec3<Real>& end) const {
  for (const double share : {0.5, 0.25, 0.0}) {
    Vec3<Real> place = from + static_cast<Real>(share) * (end - from);
    const Vec3<Real> wanted = place;
    if (slideFree(from, place) && (place - wanted).norm() <= radius_m_) return place;
  }
  Real distance = radius_m_ / 2;
  for (int shell = 0; shell < kShells; ++shell, distance *= 2) {
    Vec3<Real> best = end;
    Real nearest = std::numeric_limits<Real>::max();
    for (int k = 0; k < 27; ++k) {
      if (k == 13) continue;
      const Eigen::Vector3i way(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
      Vec3<Real> place = from + distance * way.cast<Real>().normalized();
      if (!slideFreeAnyWay(from, place) || (place - from).squaredNorm() >= nearest) continue;
      best = place;
      nearest = (place - from).squaredNorm();
    }
    if (nearest <= 4 * distance * distance) return best;
  }
  return end;
}

template Vec3<float> Colliders<float>::respond(const Vec3<float>&, const Vec3<float>&, bool) const;
template Vec3<double> Colliders<double>::respond(const Vec3<double>&, const Vec3<double>&,
                                                 bool) const;

}  // namespace ice_ice_baby
