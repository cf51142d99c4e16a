#include "thermal/thermal_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/parallel.h"
#include "colliders/clearance.h"

namespace ice_ice_baby {

namespace {

/// Safety factor on the longest stable step, for rounding.
constexpr double kSafety = 0.9;

/// Exposed area below this fraction of that of a flat surface is noise from disorder.
constexpr double kNoise = 0.25;

/// Radius of a puff of steam over that of the ball of water it came from: 12^3 = 1700 times the
/// volume.
constexpr double kPuff = 12.0;

double puffArea_m2(double volume_m3) {
  const double radius = kPuff * std::cbrt(3 * volume_m3 / (4 * M_PI));
  return 4 * M_PI * radius * radius;
}

/// The same scene with the kernel of heat, for the cover that walls give.
Scene withCubicKernel(Scene scene) {
  scene.fluid.kernel = KernelPair::kCubic;
  return scene;
}

}  // namespace

template <class Real>
ThermalSolver<Real>::ThermalSolver(const Scene& scene, const Colliders<Real>& colliders)
    : params_(scene.thermal),
      curve_(scene.thermal),
      lattice_(scene),
      walls_(scene, colliders, lattice_, curve_),
      links_(colliders, walls_, lattice_),
      colliders_(colliders),
      steam_w_k_(scene.steam.heat_transfer_w_m2k * puffArea_m2(lattice_.volume_m3)),
      touch_w_k_(scene.steam.condensation_heat_transfer_w_m2k * lattice_.spacing_m *
                 lattice_.spacing_m) {
  if (params_.air_heat_transfer_w_m2k > 0.0 && !colliders.empty()) {
    cover_.emplace(withCubicKernel(scene), colliders, lattice_.volume_m3);
  }
  if (!scene.heat_regions.empty()) scene_regions_.emplace(scene.heat_regions);
  scaleBareArea();
}

template <class Real>
void ThermalSolver<Real>::add(std::size_t count, double celsius) {
  enthalpy_.resize(enthalpy_.size() + count, curve_.enthalpy(celsius));
  received_.resize(enthalpy_.size());
}

/// A flat surface of the rest lattice has its whole area, in spite of the cut.
template <class Real>
void ThermalSolver<Real>::scaleBareArea() {
  const double top = lattice_.wallShare(lattice_.spacing_m / 2);
  double counted = 0.0;  // share of a flat surface's area that its layers have after the cut
  const int layers = static_cast<int>(lattice_.support_m / lattice_.spacing_m) + 1;
  for (int layer = 0; layer < layers; ++layer) {
    const double share = lattice_.wallShare((layer + 0.5) * lattice_.spacing_m);
    if (share > kNoise * top) counted += share;
  }
  noise_m2_ = static_cast<Real>(kNoise * top * lattice_.area_m2);
  bare_scale_ = static_cast<Real>(1 / counted);

  // A drop alone is bare all round, which the vectors of its few links do not add up to.
  constexpr double kFewLinks = 0.3;  // of those in the bulk; the corner of a cube has more
  drop_links_m_ = static_cast<Real>(kFewLinks * lattice_.links_m);
  drop_m2_ = static_cast<Real>(std::cbrt(36 * M_PI * lattice_.volume_m3 * lattice_.volume_m3));
}

template <class Real>
void ThermalSolver<Real>::advance(const Particles<Real>& particles,
                                  const Neighbours<Real>& neighbours,
                                  const ThermalStep<Real>& step) {
  const std::size_t n = enthalpy_.size();
  const double heat_s = step.dt_s * params_.speedup;
  walls_.advance(step.dt_s);
  power_w_.assign(n, 0);
  regions_.advance(particles.position, step, power_w_);
  if (scene_regions_) scene_regions_->advance(particles.position, step, power_w_);
  passes_ = 0;
  reached_speedup_ = 0.0;
  if (n == 0 || heat_s <= 0.0) return;

  measure(particles, neighbours, step);
  longest_pass_s_ = findLongestPass_s();
  const double wanted = std::ceil(heat_s / longest_pass_s_);
  passes_ = static_cast<int>(std::clamp(wanted, 1.0, double(kMaxPasses)));
  const double pass_s = std::min(heat_s / passes_, longest_pass_s_);
  reached_speedup_ = passes_ * pass_s / step.dt_s;
  parallelFor(n, [&](std::size_t i) { readCurve(i); });
  for (int pass = 0; pass < passes_; ++pass) {
    parallelFor(n, [&](std::size_t i) { sumRate(i, neighbours); });
    parallelFor(n, [&](std::size_t i) {
      apply(i, step, pass_s);
      readCurve(i);
    });
  }
}

/// What holds for all passes of a frame: links, walls in reach and the area bare to the air.
template <class Real>
void ThermalSolver<Real>::measure(const Particles<Real>& particles,
                                  const Neighbours<Real>& neighbours,
                                  const ThermalStep<Real>& step) {
  const VectorField<Real>& x = particles.position;
  resize(x.size());
  links_.begin(x, neighbours, step);
  parallelForRanges(x.size(), [&](std::size_t first, std::size_t last) {
    links_.measure(x, neighbours, {first, last}, relaxation_, open_m2_);
    meetWalls(x, first, last, step);
    for (std::size_t i = first; i < last; ++i) {
      const bool apart = step.solid(i) || (step.steam && (*step.steam)[i]);
      bare_m2_[i] = apart ? Real(0) : bareArea_m2(open_m2_.at(i), relaxation_[i]);
      relaxation_[i] = apart ? Real(0) : relaxation_kg_s(i, relaxation_[i]);
    }
  });
}

template <class Real>
void ThermalSolver<Real>::meetWalls(const VectorField<Real>& x, std::size_t first, std::size_t last,
                                    const ThermalStep<Real>& step) {
  std::fill(contact_.begin() + std::ptrdiff_t(first), contact_.begin() + std::ptrdiff_t(last),
            WallContact<Real>{});
  if (cover_) {
    const auto area = static_cast<Real>(2 / lattice_.moment_1_m3);
    cover_->forEachNear(x, first, last, [&](std::size_t i, const WallSample<Real>& wall) {
      open_m2_.add(i, area * wall.gradient);
    });
  }
  if (!walls_.active()) return;
  const Real margin = static_cast<Real>(lattice_.support_m - lattice_.spacing_m / 2);
  forEachNear(colliders_, Paths<Real>{x, x}, margin, first, last, [&](std::size_t i) {
    if (step.solid(i)) return;
    const bool steam = step.steam && (*step.steam)[i];
    contact_[i] = steam ? walls_.touching(x.at(i)) : walls_.at(x.at(i));
    power_w_[i] += contact_[i].power_w;
    if (!steam && step.volume) contact_[i].length_m *= (*step.volume)[i];
  });
}

/// Area through which air and a particle exchange heat.
template <class Real>
Real ThermalSolver<Real>::bareArea_m2(const Vec3<Real>& open_m2, Real links_m) const {
  if (params_.air_heat_transfer_w_m2k == 0.0) return 0;
  const Real area = open_m2.norm();
  const Real share = std::max(Real(0), 1 - links_m / drop_links_m_);
  return std::max(share * drop_m2_, area < noise_m2_ ? Real(0) : bare_scale_ * area);
}

/// Conductance to the air per area. Half a spacing of water lies between the centre of a particle
/// and the air.
template <class Real>
double ThermalSolver<Real>::airTransfer_w_m2k(double conductivity_w_mk) const {
  if (conductivity_w_mk == 0.0) return 0.0;
  return 1 / (1 / params_.air_heat_transfer_w_m2k + lattice_.spacing_m / (2 * conductivity_w_mk));
}

/// Bound of what a particle gains per second for each J/kg that it lies below all others.
template <class Real>
Real ThermalSolver<Real>::relaxation_kg_s(std::size_t i, Real links_m) const {
  const double conducts = curve_.steepestPotential() * double(links_m + contact_[i].length_m);
  if (bare_m2_[i] == 0) return static_cast<Real>(conducts);
  const double air_w_m2k = airTransfer_w_m2k(curve_.mostConductive());
  return static_cast<Real>(conducts + curve_.steepest() * double(bare_m2_[i]) * air_w_m2k);
}

/// Within it nothing takes a particle beyond the range of what it exchanges with.
template <class Real>
double ThermalSolver<Real>::findLongestPass_s() const {
  const Real fastest_kg_s = *std::max_element(relaxation_.begin(), relaxation_.end());
  const double longest_s = kSafety * lattice_.mass_kg / double(fastest_kg_s);
  return std::min(longest_s, std::numeric_limits<double>::max());  // infinite without exchange
}

template <class Real>
void ThermalSolver<Real>::readCurve(std::size_t i) {
  potential_[i] = static_cast<Real>(curve_.potential(curve_.temperature(enthalpy_[i])));
}

/// Pairwise terms are exactly antisymmetric, so energy is conserved to rounding.
template <class Real>
void ThermalSolver<Real>::sumRate(std::size_t i, const Neighbours<Real>& neighbours) {
  const Real own = potential_[i];
  const Real* link = links_.of(i);
  double sum = 0.0;
  for (const Index j : neighbours.of(i)) sum += double(*link++ * (potential_[j] - own));
  rate_[i] = double(links_.scale_m()) * sum;
}

template <class Real>
double ThermalSolver<Real>::fromSurfaces_w(std::size_t i, double air_c) const {
  const WallContact<Real>& wall = contact_[i];
  const double walls_w = double(wall.length_m * (wall.level - potential_[i]));
  if (bare_m2_[i] == 0) return walls_w;
  const double heat_transfer_w_m2k = airTransfer_w_m2k(curve_.conductivity(enthalpy_[i]));
  return walls_w + heat_transfer_w_m2k * double(bare_m2_[i]) * (air_c - temperature(i));
}

/// Steam exchanges heat only with air and walls, and may equilibrate within a pass; the exact
/// exponential keeps it stable.
template <class Real>
double ThermalSolver<Real>::gainOfSteam_j_kg(std::size_t i, double air_c, double pass_s) const {
  const double wall_w_k = touch_w_k_ * double(contact_[i].length_m);
  const double all_w_k = wall_w_k + steam_w_k_;
  if (all_w_k == 0.0) return 0.0;
  const double wall_c = double(contact_[i].level);
  const double end_c = wall_c + (air_c - wall_c) * (steam_w_k_ / all_w_k);
  const double gain = pass_s / lattice_.mass_kg * all_w_k * (end_c - temperature(i));
  const double max = curve_.enthalpy(end_c) - enthalpy_[i];
  return gain > 0.0 ? std::min(gain, std::max(max, 0.0)) : std::max(gain, std::min(max, 0.0));
}

template <class Real>
void ThermalSolver<Real>::apply(std::size_t i, const ThermalStep<Real>& step, double pass_s) {
  if (step.solid(i)) return;
  const bool steam = step.steam && (*step.steam)[i];
  const double per_w = pass_s / lattice_.mass_kg;
  const double gain =
      steam ? gainOfSteam_j_kg(i, step.air_c, pass_s) : per_w * fromSurfaces_w(i, step.air_c);
  const double conducted = enthalpy_[i] + per_w * rate_[i];
  enthalpy_[i] = curve_.clampToRange(conducted + gain + per_w * double(power_w_[i]));
  received_[i] += enthalpy_[i] - conducted;
}

template <class Real>
void ThermalSolver<Real>::resize(std::size_t n) {
  rate_.resize(n);
  potential_.resize(n);
  contact_.resize(n);
  bare_m2_.resize(n);
  relaxation_.resize(n);
  open_m2_.resize(n);
}

template <class Real>
void ThermalSolver<Real>::reorder(const std::vector<Index>& order) {
  permute(enthalpy_, order, rate_);
  permute(received_, order, rate_);
}

template <class Real>
double ThermalSolver<Real>::totalEnthalpy_j() const {
  return lattice_.mass_kg * std::accumulate(enthalpy_.begin(), enthalpy_.end(), 0.0);
}

template <class Real>
double ThermalSolver<Real>::heatIn_j() const {
  return lattice_.mass_kg * std::accumulate(received_.begin(), received_.end(), 0.0);
}

template <class Real>
std::size_t ThermalSolver<Real>::bytes() const {
  return (enthalpy_.capacity() + received_.capacity() + rate_.capacity()) * sizeof(double) +
         (power_w_.capacity() + bare_m2_.capacity() + potential_.capacity() +
          relaxation_.capacity()) *
             sizeof(Real) +
         contact_.capacity() * sizeof(WallContact<Real>) + open_m2_.bytes() + walls_.bytes() +
         links_.bytes() + regions_.bytes() + (scene_regions_ ? scene_regions_->bytes() : 0) +
         (cover_ ? cover_->bytes() : 0);
}

template class ThermalSolver<float>;
template class ThermalSolver<double>;

}  // namespace ice_ice_baby
