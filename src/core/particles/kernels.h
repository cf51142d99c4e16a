// Smoothing kernels: W [1/m^3] and its derivative W' [1/m^4] over the distance r [m], support
// radius h.
//
// A kernel pair names which W measures the density and which gradient corrects it. The paper uses
// two different kernels (Eq. 1 and 7); one kernel with its own gradient is the default.
#pragma once

#include <cmath>

#include "ice_ice_baby/params.h"

namespace ice_ice_baby {

/// Cubic spline (Monaghan 1992) with support radius h.
template <class Real>
struct CubicSpline {
  explicit CubicSpline(Real support) : h(support), sigma(Real(8 / M_PI) / (h * h * h)) {}
  Real h;
  Real sigma;

  Real w(Real r) const {
    const Real q = r / h;
    if (q >= 1) return 0;
    if (q <= Real(0.5)) return sigma * (6 * q * q * (q - 1) + 1);
    const Real u = 1 - q;
    return sigma * 2 * u * u * u;
  }
  Real slope(Real r) const {
    const Real q = r / h;
    if (q >= 1) return 0;
    if (q <= Real(0.5)) return sigma / h * q * (18 * q - 12);
    const Real u = 1 - q;
    return sigma / h * -6 * u * u;
  }
};

/// Mueller, Charypar & Gross 2003; the paper's Eq. 1 misprints 315/pi for 315/(64 pi).
template <class Real>
struct Poly6 {
  explicit Poly6(Real support)
      : h(support), scale(Real(315 / (64 * M_PI)) / std::pow(h, Real(9))) {}
  Real h;
  Real scale;

  Real w(Real r) const {
    const Real u = h * h - r * r;
    return u > 0 ? scale * u * u * u : Real(0);
  }
  Real slope(Real r) const {
    const Real u = h * h - r * r;
    return u > 0 ? scale * -6 * r * u * u : Real(0);
  }
};

/// Mueller, Charypar & Gross 2003, paper Eq. 7, which prints W where its gradient is used.
template <class Real>
struct Spiky {
  explicit Spiky(Real support) : h(support), scale(Real(15 / M_PI) / std::pow(h, Real(6))) {}
  Real h;
  Real scale;

  Real w(Real r) const {
    const Real u = h - r;
    return u > 0 ? scale * u * u * u : Real(0);
  }
  Real slope(Real r) const {
    const Real u = h - r;
    return u > 0 ? scale * -3 * u * u : Real(0);
  }
};

template <class Real>
struct CubicPair {
  explicit CubicPair(Real h) : density(h), gradient(h) {}
  CubicSpline<Real> density;
  CubicSpline<Real> gradient;
};

template <class Real>
struct Poly6SpikyPair {
  explicit Poly6SpikyPair(Real h) : density(h), gradient(h) {}
  Poly6<Real> density;
  Spiky<Real> gradient;
};

/// W(0) of the density kernel [1/m^3].
inline double densityAtZero(KernelPair pair, double h) {
  return pair == KernelPair::kCubic ? CubicSpline<double>(h).w(0) : Poly6<double>(h).w(0);
}

/// W'(h / 2) of the gradient kernel [1/m^4].
inline double slopeAtHalf(KernelPair pair, double h) {
  return pair == KernelPair::kCubic ? CubicSpline<double>(h).slope(h / 2)
                                    : Spiky<double>(h).slope(h / 2);
}

/// Sum of W over a cubic lattice of spacing d around one of its points [1/m^3].
template <class Kernel>
double latticeSum(const Kernel& kernel, double spacing_m, bool with_self) {
  const int reach = static_cast<int>(kernel.h / spacing_m) + 1;
  double sum = with_self ? kernel.w(0) : 0.0;
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      for (int z = -reach; z <= reach; ++z) {
        if (x || y || z) sum += kernel.w(spacing_m * std::sqrt(double(x * x + y * y + z * z)));
      }
    }
  }
  return sum;
}

/// Mass of a particle in force: as given, or such that the rest lattice has exactly rest density.
inline double particleMass_kg(const FluidParams& fluid, double h) {
  if (fluid.particle_mass_kg > 0.0) return fluid.particle_mass_kg;
  const double sum = fluid.kernel == KernelPair::kCubic
                         ? latticeSum(CubicSpline<double>(h), fluid.spacing_m, fluid.self_density)
                         : latticeSum(Poly6<double>(h), fluid.spacing_m, fluid.self_density);
  return fluid.rest_density_kg_m3 / sum;
}

/// V = m / rho_0, the volume of a particle at rest.
inline double particleVolume_m3(const FluidParams& fluid, double h) {
  return particleMass_kg(fluid, h) / fluid.rest_density_kg_m3;
}

}  // namespace ice_ice_baby
