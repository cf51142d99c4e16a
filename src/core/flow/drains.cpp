#include "flow/drains.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ice_ice_baby {

namespace {

/// A particle in a drain. Those with the lowest come first.
struct Candidate {
  double square_m2;  ///< square of its distance from the centre
  std::uint32_t id;
  Index place;

  bool operator<(const Candidate& other) const {
    return std::tie(square_m2, id) < std::tie(other.square_m2, other.id);
  }
};

template <class Real>
std::vector<Candidate> candidatesIn(const Drain& drain, const Particles<Real>& particles,
                                    const std::vector<char>& gone, const std::vector<char>& stays) {
  const Posed pose = poseOf(drain.centre_m(), drain.rpy_deg);
  const Vec3d half_m = (drain.max_m - drain.min_m) / 2;
  std::vector<Candidate> found;
  for (Index i = 0; i < particles.owned(); ++i) {
    if (gone[i] || stays[i]) continue;
    const Vec3d local = pose.toLocal(particles.position.at(i).template cast<double>());
    if ((local.cwiseAbs() - half_m).maxCoeff() > 0.0) continue;
    found.push_back({local.squaredNorm(), particles.id[i], i});
  }
  return found;
}

}  // namespace

template <class Real>
std::size_t Drains::choose(const Scene& scene, const Particles<Real>& particles,
                           std::vector<char>& gone, const std::vector<char>& stays) {
  const double d = scene.fluid.spacing_m;
  std::size_t all = 0;
  for (std::size_t k = 0; k < scene.drains.size(); ++k) {
    const Drain& drain = scene.drains[k];
    std::vector<Candidate> found = candidatesIn(drain, particles, gone, stays);
    std::size_t take = found.size();
    if (drain.rate_l_min > 0.0) {
      const double rate_1_s = drain.rate_l_min / kLitresPerMinute / (d * d * d);
      double& allowance = allowance_[k];
      allowance += rate_1_s / scene.solver.frame_rate_hz;
      take = static_cast<std::size_t>(std::min(double(take), std::floor(allowance)));
      // A drain that ran dry does not make up for it later.
      allowance = std::min(allowance - double(take), 1.0);
      const auto last = found.begin() + static_cast<std::ptrdiff_t>(take);
      std::partial_sort(found.begin(), last, found.end());
    }
    for (std::size_t c = 0; c < take; ++c) gone[found[c].place] = true;
    all += take;
  }
  return all;
}

template std::size_t Drains::choose(const Scene&, const Particles<float>&, std::vector<char>&,
                                    const std::vector<char>&);
template std::size_t Drains::choose(const Scene&, const Particles<double>&, std::vector<char>&,
                                    const std::vector<char>&);

}  // namespace ice_ice_baby
