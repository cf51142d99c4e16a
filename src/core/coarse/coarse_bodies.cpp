#include "coarse/coarse_bodies.h"

#include <cmath>

namespace ice_ice_baby {

template <class Real>
void CoarseBodies<Real>::assemble(const IceBodies<Real>* bodies, const Particles<Real>& particles,
                                  double particle_kg, const CoarseGrids<Real>& grids,
                                  const CellParticles<Real>& sorted,
                                  const std::vector<Index>& place, const std::vector<Index>& row_of,
                                  std::size_t rows) {
  bodies_.clear();
  pushes_.clear();
  if (!bodies) return;
  push_of_.assign(rows, kNone);
  const double cell = double(grids.cell_m());
  for (Index b = 0; b < bodies->count(); ++b) {
    const IceBody& body = bodies->body(b);
    if (body.held()) continue;
    const std::size_t first = pushes_.size();
    for (Index m = body.first; m < body.last; ++m) {
      const Index i = bodies->placeOf(m);
      if (place[i] == kNone) continue;
      const Vec3d arm = particles.position.at(i).template cast<double>() - body.pose.centre_m;
      addMember(grids.gridOf(i), sorted, place[i], grids.lowestNodeOf(i), arm / cell, row_of);
    }
    for (std::size_t p = first; p < pushes_.size(); ++p) push_of_[pushes_[p].row] = kNone;
    bodies_.push_back({first, pushes_.size(), 1.0 / body.mass_particles,
                       body.mobility_now * (particle_kg * cell * cell)});
  }
}

template <class Real>
void CoarseBodies<Real>::addMember(const CoarseGrid<Real>& grid, const CellParticles<Real>& sorted,
                                   std::size_t k, std::size_t lowest, const Vec3d& arm,
                                   const std::vector<Index>& row_of) {
  const SplineAt<Real> spline(sorted, k);
  const Vec3<Real> scale = scaleOf(sorted, k) * sorted.volume[k];
  for (std::size_t a = 0; a < kCellNodes; ++a) {
    const Index row = row_of[std::size_t(std::ptrdiff_t(lowest) + grid.nodeOffset(a))];
    if (row == kNone) continue;
    const Vec3<Real> slope = spline.slope(a);
    const Vec3d force =
        (grid.region.frame.rotation * slope.cwiseProduct(scale)).template cast<double>();
    if (push_of_[row] == kNone) {
      push_of_[row] = Index(pushes_.size());
      pushes_.push_back({row, Vec3d::Zero(), Vec3d::Zero()});
    }
    pushes_[push_of_[row]].force += force;
    pushes_[push_of_[row]].torque += arm.cross(force);
  }
}

template <class Real>
void CoarseBodies<Real>::addProduct(const std::vector<Index>& active, const Real* x,
                                    std::vector<Real>& y) const {
  for (const Body& body : bodies_) {
    Vec3d force = Vec3d::Zero(), torque = Vec3d::Zero();
    for (std::size_t p = body.first; p < body.last; ++p) {
      const double mu = double(x[active[pushes_[p].row]]);
      force += mu * pushes_[p].force;
      torque += mu * pushes_[p].torque;
    }
    const Vec3d shift = body.mobility * force, rotation = body.angular_mobility * torque;
    for (std::size_t p = body.first; p < body.last; ++p) {
      y[pushes_[p].row] +=
          static_cast<Real>(pushes_[p].force.dot(shift) + pushes_[p].torque.dot(rotation));
    }
  }
}

template <class Real>
void CoarseBodies<Real>::addDiagonal(std::vector<Real>& diagonal) const {
  for (const Body& body : bodies_) {
    for (std::size_t p = body.first; p < body.last; ++p) {
      const Push& push = pushes_[p];
      diagonal[push.row] += static_cast<Real>(body.mobility * push.force.squaredNorm() +
                                              push.torque.dot(body.angular_mobility * push.torque));
    }
  }
}

template class CoarseBodies<float>;
template class CoarseBodies<double>;

}  // namespace ice_ice_baby
