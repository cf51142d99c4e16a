#include "base/parallel.h"
#include "fluid/pair_passes.h"

namespace ice_ice_baby {

namespace {

template <class Real, class Fourth>
void packRows(const VectorField<Real>& field, const Fourth& fourth, std::vector<Real>& rows) {
  rows.resize(4 * field.size());
  parallelFor(field.size(), [&](std::size_t i) {
    rows[4 * i] = field.x[i];
    rows[4 * i + 1] = field.y[i];
    rows[4 * i + 2] = field.z[i];
    rows[4 * i + 3] = fourth(i);
  });
}

}  // namespace

template <class Real>
void PackedXyzw<Real>::pack(const VectorField<Real>& field) {
  packRows(
      field, [](std::size_t) { return Real(0); }, rows_);
}

template <class Real>
void PackedXyzw<Real>::pack(const VectorField<Real>& field, const std::vector<Real>& fourth) {
  packRows(
      field, [&](std::size_t i) { return fourth[i]; }, rows_);
}

template class PackedXyzw<float>;
template class PackedXyzw<double>;

}  // namespace ice_ice_baby
