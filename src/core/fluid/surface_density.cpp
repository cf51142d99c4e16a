#include "fluid/surface_density.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "base/recent_results.h"
#include "fluid/sample_sum.h"

namespace ice_ice_baby {

namespace {

/// Distance of the nodes in spacings. Centres of particles stay two of them off the surface.
constexpr double kEdge_d = 0.25;

/// Nodes closer to the surface than this, in spacings, follow from the density at that distance:
/// the samples are too far apart for them, and beyond the surface stand nodes of its other side.
constexpr double kNearest_d = 1.75 * kEdge_d;

/// From here on, in spacings, the coarse samples are close enough to each other.
constexpr double kCoarse_d = 0.8;

/// In place of a coefficient of a node that is not close to the surface.
constexpr double kFar = std::numeric_limits<double>::infinity();

/// Nodes along the side of a part, an eighth of a block, for which samples are sought together.
constexpr int kPart = BlockIndex::kBlock / 2;
constexpr std::size_t kParts = 8;  ///< of a block

/// Lowest nodes of the parts of a block, along each axis.
BlockIndex::Node cornerOfPart(int part) {
  return kPart * BlockIndex::Node(part & 1, part >> 1 & 1, part >> 2);
}

/// Part of its block in which a node lies.
std::size_t partOf(const BlockIndex::Node& node) {
  const auto upper = [&](int axis) { return node[axis] % BlockIndex::kBlock / kPart; };
  return std::size_t(upper(0) + 2 * upper(1) + 4 * upper(2));
}

/// Density at a point near the surface.
class DensityField {
 public:
  DensityField(const Surface& surface, const WallKernel& kernel, const BlockIndex& blocks,
               double spacing_m)
      : surface_(surface),
        kernel_(kernel),
        blocks_(blocks),
        nearest_m_(kNearest_d * spacing_m),
        coarse_m_(kCoarse_d * spacing_m),
        part_m_(kPart * blocks.edge_m()),
        parts_beside_(static_cast<int>(std::ceil(kernel.reach_m() / part_m_))),
        coarse_(kParts * blocks.inUse()),
        fine_(kParts * blocks.inUse()),
        sample_kernel_(kernel) {
    const SurfaceSamples samples = samplesOf(surface, spacing_m);
    sort(samples.coarse, coarse_);
    sort(samples.fine, fine_);
  }

  /// The samples that reach the nodes of a part; the fine ones only if a node may need them.
  struct Samples {
    SampleColumns coarse, fine;
  };
  /// @param low the lowest node of the part
  Samples around(const BlockIndex::Node& low) const {
    const double half = (kPart - 1) * blocks_.edge_m() / 2;
    const Vec3d centre = blocks_.place(low) + Vec3d::Constant(half);
    const double half_diagonal = std::sqrt(3.0) * half;
    Samples found{around(low, centre, half_diagonal, coarse_), {}};
    if (surface_.atLeast(centre) < coarse_m_ + half_diagonal) {
      found.fine = around(low, centre, half_diagonal, fine_);
    }
    return found;
  }

  /// The density at a node, and the coefficient of the spline if it is close to the surface.
  struct Node {
    double value = 0.0;
    double coefficient = kFar;
  };
  Node at(const Vec3d& x, const Samples& samples) const {
    const double whole = 2 * kernel_.halfSpace(0.0);
    const bool inside = surface_.encloses(x);
    if (surface_.atLeast(x) >= kernel_.reach_m()) return {inside ? whole : 0.0, kFar};
    const SurfacePoint near = surface_.closest(x, kernel_.reach_m());
    if (!near.found()) return {inside ? whole : 0.0, kFar};
    if (near.distance_m >= nearest_m_) {
      // No centre of a particle is so deep in a solid: there, that of a flat wall will do.
      if (inside) return {whole - kernel_.halfSpace(near.distance_m), kFar};
      const bool far = near.distance_m >= coarse_m_;
      return {density(x, false, far ? samples.coarse : samples.fine), kFar};
    }
    const Vec3d away = near.distance_m > 0
                           ? Vec3d((x - near.point) / near.distance_m)
                           : surface_.tree().triangle(near.triangle).normal().normalized();
    const Vec3d farther = near.point + nearest_m_ * away;
    const double share =
        density(farther, surface_.encloses(farther), samples.fine) / kernel_.halfSpace(nearest_m_);
    return {share * kernel_.halfSpace(near.distance_m), share * flatCoefficient(near.distance_m)};
  }

 private:
  using Sorted = std::vector<std::vector<SurfaceSample>>;  ///< by the part in which they lie

  void sort(const std::vector<SurfaceSample>& samples, Sorted& sorted) const {
    for (const SurfaceSample& sample : samples) {
      const BlockIndex::Node node = blocks_.nearest(sample.point);
      sorted[kParts * blocks_.blockOf(node) + partOf(node)].push_back(sample);
    }
  }

  SampleColumns around(const BlockIndex::Node& low, const Vec3d& centre, double half_diagonal,
                       const Sorted& sorted) const {
    SampleColumns found;
    const bool closed = surface_.topology().closed();
    const double far = half_diagonal + kernel_.reach_m();
    const double far_part = far + std::sqrt(3.0) * part_m_ / 2;
    const int side = 2 * parts_beside_ + 1;
    for (int k = 0; k < side * side * side; ++k) {
      const BlockIndex::Node beside =
          BlockIndex::Node(k % side, k / side % side, k / (side * side)).array() - parts_beside_;
      if ((part_m_ * beside.cast<double>()).norm() > far_part) continue;
      const BlockIndex::Node node = low + kPart * beside;
      const Index block = blocks_.blockOf(node);
      if (block == BlockIndex::kAbsent) continue;
      for (const SurfaceSample& sample : sorted[kParts * block + partOf(node)]) {
        if ((sample.point - centre).squaredNorm() < far * far) found.add(sample, closed);
      }
    }
    found.pad();
    return found;
  }

  double density(const Vec3d& x, bool inside, const SampleColumns& samples) const {
    return std::max(sample_kernel_.sum(x, inside, samples), 0.0);
  }
  /// Of the spline beside a flat wall: T - edge^2 T'' / 8, as in `interpolate`.
  double flatCoefficient(double distance_m) const {
    const double bend = 2 * M_PI * distance_m * kernel_.value(std::max(distance_m, 1e-9));
    return kernel_.halfSpace(distance_m) - blocks_.edge_m() * blocks_.edge_m() / 8 * bend;
  }

  const Surface& surface_;
  const WallKernel& kernel_;
  const BlockIndex& blocks_;
  double nearest_m_;
  double coarse_m_;
  double part_m_;     ///< side of a part
  int parts_beside_;  ///< that hold samples which reach a part
  Sorted coarse_, fine_;
  SampleKernel sample_kernel_;
};

/// Memory of densities that may be kept after their scene.
constexpr std::size_t kKept_bytes = 256 << 20;

/// A density and what it was computed from.
template <class Real>
struct KeptDensity {
  std::shared_ptr<const Surface> surface;
  WallKernel kernel;
  double spacing_m;
  SurfaceDensity<Real> density;

  std::size_t bytes() const { return density.bytes(); }
};

}  // namespace

template <class Real>
std::shared_ptr<const SurfaceDensity<Real>> SurfaceDensity<Real>::shared(const Surface& surface,
                                                                         const WallKernel& kernel,
                                                                         double spacing_m) {
  using Kept = KeptDensity<Real>;
  static RecentResults<Kept> kept(kKept_bytes);
  const std::shared_ptr<const Kept> found = kept.find(
      [&](const Kept& one) {
        return one.surface.get() == &surface && one.spacing_m == spacing_m && one.kernel == kernel;
      },
      [&] {
        return std::make_shared<const Kept>(Kept{surface.shared_from_this(), kernel, spacing_m,
                                                 SurfaceDensity(surface, kernel, spacing_m)});
      });
  return {found, &found->density};
}

template <class Real>
SurfaceDensity<Real>::SurfaceDensity(const Surface& surface, const WallKernel& kernel,
                                     double spacing_m) {
  const double edge = kEdge_d * spacing_m, reach = kernel.reach_m() + 2 * edge;
  const SurfaceTree& tree = surface.tree();
  const Vec3d margin = Vec3d::Constant(reach + 2 * edge);
  blocks_ = BlockIndex({tree.bounds().min() - margin, tree.bounds().max() + margin}, edge);
  blocks_.use([&](const Vec3d& centre, double half_diagonal) {
    return tree.closest(centre, reach + half_diagonal).found();
  });
  const DensityField field(surface, kernel, blocks_, spacing_m);
  Values values{std::vector<double>(blocks_.inUse() * BlockIndex::kNodes),
                std::vector<double>(blocks_.inUse() * BlockIndex::kNodes, kFar)};
  parallelFor(
      blocks_.inUse(),
      [&](std::size_t b) {
        for (int part = 0; part < int(kParts); ++part) {
          const BlockIndex::Node low = cornerOfPart(part);
          const auto samples = field.around(blocks_.corner(b) + low);
          if (samples.coarse.empty()) continue;
          for (int n = 0; n < kPart * kPart * kPart; ++n) {
            const BlockIndex::Node node =
                low + BlockIndex::Node(n % kPart, n / kPart % kPart, n / (kPart * kPart));
            const auto found = field.at(blocks_.place(blocks_.corner(b) + node), samples);
            const std::size_t at = b * BlockIndex::kNodes + BlockIndex::within(node);
            values.of[at] = found.value;
            values.coefficient[at] = found.coefficient;
          }
        }
      },
      1);
  interpolate(values);
}

/// Coefficients of a spline that is exact for polynomials of the second degree (C. de Boor,
/// A Practical Guide to Splines, quasi-interpolation): (-f[k-1] + 10 f[k] - f[k+1]) / 8 along each
/// axis. Each block keeps its own and those of the nodes around it.
template <class Real>
void SurfaceDensity<Real>::interpolate(const Values& values) {
  constexpr int kWide = BlockIndex::kBlock + 4;
  coefficients_.assign(blocks_.inUse() * kNodes, Real(0));
  parallelFor(
      blocks_.inUse(),
      [&](std::size_t b) {
        const BlockIndex::Node first = blocks_.corner(b) - BlockIndex::Node::Constant(2);
        std::vector<double> wide(std::size_t(kWide) * kWide * kWide), filtered(wide.size());
        std::vector<double> close(wide.size(), kFar);
        for (int n = 0; n < kWide * kWide * kWide; ++n) {
          const BlockIndex::Node node =
              first + BlockIndex::Node(n % kWide, n / kWide % kWide, n / (kWide * kWide));
          const Index block = blocks_.blockOf(node);
          if (block == BlockIndex::kAbsent) continue;
          const std::size_t at = std::size_t(block) * BlockIndex::kNodes + BlockIndex::within(node);
          wide[std::size_t(n)] = values.of[at];
          close[std::size_t(n)] = values.coefficient[at];
        }
        for (const int stride : {1, kWide, kWide * kWide}) {
          for (int n = stride; n + stride < kWide * kWide * kWide; ++n) {
            const auto at = [&](int k) { return wide[std::size_t(k)]; };
            filtered[std::size_t(n)] = (10 * at(n) - at(n - stride) - at(n + stride)) / 8;
          }
          std::swap(wide, filtered);
        }
        Real* out = coefficients_.data() + b * kNodes;
        for (int n = 0; n < int(kNodes); ++n) {
          const std::size_t at = std::size_t(
              n % kSide + 1 + kWide * (n / kSide % kSide + 1 + kWide * (n / (kSide * kSide) + 1)));
          out[n] = static_cast<Real>(close[at] < kFar ? close[at] : wide[at]);
        }
      },
      1);
}

template <class Real>
WallSample<Real> SurfaceDensity<Real>::at(const Vec3<Real>& point) const {
  const BlockIndex::Node node = blocks_.nearest(point);
  const Index block = blocks_.blockOf(node);
  if (block == BlockIndex::kAbsent) return {};
  const auto per = static_cast<Real>(1 / blocks_.edge_m());
  const Vec3<Real> t = (point - blocks_.place(node).template cast<Real>()) * per;
  std::array<std::array<Real, 3>, 3> of, slope;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Real low = Real(0.5) - t[Eigen::Index(axis)], high = Real(0.5) + t[Eigen::Index(axis)];
    of[axis] = {low * low / 2, Real(0.75) - t[Eigen::Index(axis)] * t[Eigen::Index(axis)],
                high * high / 2};
    slope[axis] = {-low * per, -2 * t[Eigen::Index(axis)] * per, high * per};
  }
  const BlockIndex::Node within = node.unaryExpr([](int k) { return k % BlockIndex::kBlock; });
  const Real* first = coefficients_.data() + std::size_t(block) * kNodes +
                      std::size_t(within.x() + kSide * (within.y() + kSide * within.z()));
  WallSample<Real> sample;
  for (std::size_t z = 0; z < 3; ++z) {
    for (std::size_t y = 0; y < 3; ++y) {
      const Real* row = first + kSide * (y + kSide * z);
      const Real line = of[0][0] * row[0] + of[0][1] * row[1] + of[0][2] * row[2];
      const Real rise = slope[0][0] * row[0] + slope[0][1] * row[1] + slope[0][2] * row[2];
      sample.value += of[1][y] * of[2][z] * line;
      sample.gradient += Vec3<Real>(of[1][y] * of[2][z] * rise, slope[1][y] * of[2][z] * line,
                                    of[1][y] * slope[2][z] * line);
    }
  }
  return sample;
}

template class SurfaceDensity<float>;
template class SurfaceDensity<double>;

}  // namespace ice_ice_baby
