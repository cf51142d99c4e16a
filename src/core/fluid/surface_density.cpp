#include "fluid/surface_density.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "meshes/surface_samples.h"

namespace ice_ice_baby {

namespace {

/// Distance of the nodes in spacings. Centres of particles stay two of them off the surface.
constexpr double kEdge_d = 0.25;

/// Nodes closer to the surface than this, in spacings, take their value from that distance, because
/// the samples are too far apart for them.
constexpr double kNearest_d = 0.4;

/// Nodes along the side of an eighth of a block, for which samples are sought together.
constexpr int kPart = BlockIndex::kBlock / 2;

/// What samples add, with the kernel as a function of the squared distance.
class SampleSum {
 public:
  SampleSum(const WallKernel& kernel, bool closed)
      : closed_(closed), reach2_(kernel.reach_m() * kernel.reach_m()) {
    for (int k = 0; k <= kSize; ++k) {
      const double r = std::sqrt(reach2_ * (k + 0.5) / kSize);
      over_cube_.push_back(kernel.beyond(r) / (r * r * r));
    }
  }

  /// What a sample adds at a point: the solid behind it as seen from the point.
  double of(const SurfaceSample& sample, const Vec3d& x, bool inside) const {
    const Vec3d from = x - sample.point;
    const double r2 = from.squaredNorm();
    if (r2 >= reach2_) return 0.0;
    const double facing = from.dot(sample.normal);
    const double seen =
        facing * over_cube_[static_cast<std::size_t>(r2 / reach2_ * kSize)] * sample.area_m2;
    if (closed_) {
      const double into = inside ? -seen : seen;
      return into > 0 ? into : (1 - sample.opacity) * into;
    }
    const bool ahead = facing > 0;
    const bool covered = ahead ? sample.covered_ahead : sample.covered_behind;
    const bool backed = ahead ? sample.covered_behind : sample.covered_ahead;
    if (covered) return -(1 - sample.opacity) * std::abs(seen);
    return (backed ? 1.0 : sample.opacity) * std::abs(seen);
  }

 private:
  static constexpr int kSize = 8192;

  bool closed_;
  double reach2_;
  std::vector<double> over_cube_;  ///< g(r) / r^3 over the squared distance
};

/// Density at a point near the surface.
class DensityField {
 public:
  DensityField(const Surface& surface, const WallKernel& kernel, const BlockIndex& blocks,
               double spacing_m)
      : surface_(surface),
        kernel_(kernel),
        blocks_(blocks),
        nearest_m_(kNearest_d * spacing_m),
        in_block_(blocks.inUse()),
        sum_(kernel, surface.topology().closed()) {
    for (const SurfaceSample& sample : samplesOf(surface, spacing_m)) {
      in_block_[blocks.blockOf(blocks.nearest(sample.point))].push_back(sample);
    }
  }

  /// The samples that reach a ball within a block.
  std::vector<SurfaceSample> around(std::size_t block, const Vec3d& centre, double radius_m) const {
    std::vector<SurfaceSample> found;
    const double far = radius_m + kernel_.reach_m();
    for (int k = 0; k < 27; ++k) {
      const BlockIndex::Node beside(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
      const Index other = blocks_.blockOf(blocks_.corner(block) + BlockIndex::kBlock * beside);
      if (other == BlockIndex::kAbsent) continue;
      for (const SurfaceSample& sample : in_block_[other]) {
        if ((sample.point - centre).squaredNorm() < far * far) found.push_back(sample);
      }
    }
    return found;
  }

  double at(const Vec3d& x, const std::vector<SurfaceSample>& samples) const {
    const SurfacePoint near = surface_.closest(x, kernel_.reach_m());
    if (!near.found()) return 0.0;
    Vec3d from = x;
    double factor = 1.0;
    if (near.distance_m < nearest_m_) {
      const Vec3d away = near.distance_m > 0
                             ? Vec3d((x - near.point) / near.distance_m)
                             : surface_.tree().triangle(near.triangle).normal().normalized();
      from = near.point + nearest_m_ * away;
      factor = kernel_.halfSpace(near.distance_m) / kernel_.halfSpace(nearest_m_);
    }
    const bool inside = surface_.encloses(from);
    double density = 0.0;
    for (const SurfaceSample& sample : samples) density += sum_.of(sample, from, inside);
    return factor * std::max(density, 0.0);
  }

 private:
  const Surface& surface_;
  const WallKernel& kernel_;
  const BlockIndex& blocks_;
  double nearest_m_;
  std::vector<std::vector<SurfaceSample>> in_block_;
  SampleSum sum_;
};

}  // namespace

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
  std::vector<double> values(blocks_.inUse() * BlockIndex::kNodes);
  parallelFor(
      blocks_.inUse(),
      [&](std::size_t b) {
        for (int octant = 0; octant < 8; ++octant) {
          const BlockIndex::Node low =
              kPart * BlockIndex::Node(octant & 1, octant >> 1 & 1, octant >> 2);
          const Vec3d first = blocks_.place(blocks_.corner(b) + low);
          const double half = (kPart - 1) * blocks_.edge_m() / 2;
          const std::vector<SurfaceSample> samples =
              field.around(b, first + Vec3d::Constant(half), std::sqrt(3.0) * half);
          if (samples.empty()) continue;
          for (int n = 0; n < kPart * kPart * kPart; ++n) {
            const BlockIndex::Node node =
                low + BlockIndex::Node(n % kPart, n / kPart % kPart, n / (kPart * kPart));
            values[b * BlockIndex::kNodes + BlockIndex::within(node)] =
                field.at(blocks_.place(blocks_.corner(b) + node), samples);
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
void SurfaceDensity<Real>::interpolate(const std::vector<double>& values) {
  constexpr int kBlock = BlockIndex::kBlock, kWide = kBlock + 4;
  coefficients_.assign(blocks_.inUse() * kNodes, Real(0));
  const auto valueAt = [&](const BlockIndex::Node& node) {
    const Index block = blocks_.blockOf(node);
    return block == BlockIndex::kAbsent
               ? 0.0
               : values[std::size_t(block) * BlockIndex::kNodes + BlockIndex::within(node)];
  };
  parallelFor(
      blocks_.inUse(),
      [&](std::size_t b) {
        const BlockIndex::Node first = blocks_.corner(b) - BlockIndex::Node::Constant(2);
        std::vector<double> wide(std::size_t(kWide) * kWide * kWide);
        for (int n = 0; n < kWide * kWide * kWide; ++n) {
          wide[std::size_t(n)] =
              valueAt(first + BlockIndex::Node(n % kWide, n / kWide % kWide, n / (kWide * kWide)));
        }
        for (const int stride : {1, kWide, kWide * kWide}) {
          const std::vector<double> before = wide;
          for (int n = stride; n + stride < kWide * kWide * kWide; ++n) {
            const auto at = [&](int k) { return before[std::size_t(k)]; };
            wide[std::size_t(n)] = (10 * at(n) - at(n - stride) - at(n + stride)) / 8;
          }
        }
        for (int z = 0; z < kSide; ++z) {
          for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
              coefficients_[b * kNodes + std::size_t(x + kSide * (y + kSide * z))] =
                  static_cast<Real>(wide[std::size_t(x + 1 + kWide * (y + 1 + kWide * (z + 1)))]);
            }
          }
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
