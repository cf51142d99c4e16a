#include "measure/measured_vessels.h"

#include <algorithm>
#include <numeric>
#include <type_traits>

#include "base/parallel.h"
#include "measure/vessel_level.h"

namespace ice_ice_baby {

namespace {

/// A vessel where it is now.
struct Placed {
  VesselNumber number;
  const VesselSpace* space;
  Posed pose;
  Vec3d centre;      ///< in the scene, m
  double reach2_m2;  ///< square of its radius about the centre

  bool holds(const Vec3d& x) const {
    return (x - centre).squaredNorm() <= reach2_m2 && space->holds(pose.toLocal(x));
  }
};

template <class Real>
std::vector<Placed> placed(const MeasuredVessels& vessels, const std::vector<VesselNumber>& numbers,
                           const Colliders<Real>& colliders) {
  std::vector<Placed> all;
  for (const VesselNumber number : numbers) {
    const VesselSpace& space = vessels[number].space;
    const Posed pose = vessels.pose(number, colliders);
    const double reach_m = space.reach_m();
    all.push_back({number, &space, pose, pose.toWorld(space.centre()), reach_m * reach_m});
  }
  return all;
}

/// A collider that may displace water.
template <class Real>
class Displacer {
 public:
  Displacer(const Shape<Real>& shape, const Posed& pose) : shape_(&shape), pose_(pose) {}

  /// A point that a straight path connects with the last one, away from the surface, is on the same
  /// side of it; that is faster to find out, so ask for points in rows.
  bool holds(const Vec3d& x) {
    const Vec3<Real> now = pose_.toLocal(x).template cast<Real>();
    if (!asked_ || !shape_->clear(last_, now, Real(0))) solid_ = shape_->solid(now);
    asked_ = true;
    last_ = now;
    return solid_;
  }

 private:
  const Shape<Real>* shape_;
  Posed pose_;
  Vec3<Real> last_ = Vec3<Real>::Zero();
  bool asked_ = false, solid_ = false;
};

/// Colliders that may reach into a vessel, except the one that it is.
template <class Real>
std::vector<Displacer<Real>> solidsNear(const MeasuredVessel& vessel, bool gauge,
                                        const Vec3d& centre, const Colliders<Real>& colliders) {
  std::vector<Displacer<Real>> near;
  for (std::size_t k = 0; k < colliders.count(); ++k) {
    if (!gauge && k == vessel.collider) continue;
    const Posed pose = colliders.pose(k);
    const double apart_m = (pose.position - centre).norm();
    const double reach_m = vessel.space.reach_m();
    const double turning_m = colliders[k].shape.turningRadius(apart_m + reach_m);
    if (apart_m <= reach_m + turning_m) near.emplace_back(colliders[k].shape, pose);
  }
  return near;
}

}  // namespace

MeasuredVessels::MeasuredVessels(const Scene& scene) {
  std::vector<std::string> names;
  forEachColliderList(scene, [&](const auto& list, const ColliderKind&) {
    using Item = typename std::decay_t<decltype(list)>::value_type;
    for (const auto& item : list) {
      if constexpr (std::is_same_v<Item, Container> || std::is_same_v<Item, Cup>) {
        all_.push_back({item.name, spaceOf(item), static_cast<Index>(names.size()), {}});
      }
      names.push_back(item.name);
    }
  });
  first_gauge_ = all_.size();
  std::vector<VesselNumber> vessels(all_.size());
  std::iota(vessels.begin(), vessels.end(), VesselNumber(0));
  std::stable_sort(vessels.begin(), vessels.end(), [&](VesselNumber a, VesselNumber b) {
    return all_[a].space.capacity_m3() < all_[b].space.capacity_m3();
  });
  if (!vessels.empty()) groups_.push_back(std::move(vessels));
  for (const Gauge& gauge : scene.gauges) {
    const auto frame = std::find(names.begin(), names.end(), gauge.frame);
    const bool fixed = gauge.frame.empty() || frame == names.end();
    const Index collider = fixed ? kNone : static_cast<Index>(frame - names.begin());
    groups_.push_back({static_cast<VesselNumber>(all_.size())});
    all_.push_back({gauge.name, spaceOf(gauge), collider, poseOf(gauge.position_m, gauge.rpy_deg)});
  }
}

template <class Real>
void MeasuredVessels::locate(std::size_t group, const VectorField<Real>& position_m,
                             const Colliders<Real>& colliders,
                             std::vector<VesselNumber>& where) const {
  const std::vector<Placed> vessels = placed(*this, groups_[group], colliders);
  where.resize(position_m.size());
  parallelFor(where.size(), [&](std::size_t i) {
    const Vec3d x = position_m.at(i).template cast<double>();
    const auto found = std::find_if(vessels.begin(), vessels.end(),
                                    [&](const Placed& vessel) { return vessel.holds(x); });
    where[i] = found == vessels.end() ? kNoVessel : found->number;
  });
}

template <class Real>
double MeasuredVessels::level_m(std::size_t number, const Vec3d& up, double volume_m3,
                                const Colliders<Real>& colliders) const {
  const MeasuredVessel& vessel = all_[number];
  const Posed pose = this->pose(number, colliders);
  const Vec3d centre = pose.toWorld(vessel.space.centre());
  std::vector<Displacer<Real>> solids = solidsNear(vessel, isGauge(number), centre, colliders);
  std::vector<VesselNumber> inner;
  if (!isGauge(number)) {
    const auto& all = groups_.front();
    inner.assign(all.begin(), std::find(all.begin(), all.end(), number));
  }
  const std::vector<Placed> vessels = placed(*this, inner, colliders);
  const auto taken = [&](const Vec3d& local) {
    const Vec3d x = pose.toWorld(local);
    const auto holds = [&](auto& other) { return other.holds(x); };
    return std::any_of(vessels.begin(), vessels.end(), holds) ||
           std::any_of(solids.begin(), solids.end(), holds);
  };
  const Vec3d up_in_vessel = pose.rotation.transpose() * up;
  if (vessels.empty() && solids.empty()) {
    return levelOf_m(vessel.space, up_in_vessel, volume_m3, {});
  }
  return levelOf_m(vessel.space, up_in_vessel, volume_m3, taken);
}

template void MeasuredVessels::locate(std::size_t, const VectorField<float>&,
                                      const Colliders<float>&, std::vector<VesselNumber>&) const;
template void MeasuredVessels::locate(std::size_t, const VectorField<double>&,
                                      const Colliders<double>&, std::vector<VesselNumber>&) const;
template double MeasuredVessels::level_m(std::size_t, const Vec3d&, double,
                                         const Colliders<float>&) const;
template double MeasuredVessels::level_m(std::size_t, const Vec3d&, double,
                                         const Colliders<double>&) const;

}  // namespace ice_ice_baby
