// State of the particles: structure of arrays, sorted by cell of the neighbour search.
#pragma once

#include <cstddef>
#include <vector>

#include "ice_ice_baby/scene.h"

namespace ice_ice_baby {

/// Moves values[order[k]] to place k. Values that `order` does not contain are removed.
/// @param order distinct indices of values
/// @param scratch is swapped with the values; its contents are lost
template <class T>
void permute(std::vector<T>& values, const std::vector<Index>& order, std::vector<T>& scratch) {
  scratch.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) scratch[k] = values[order[k]];
  values.swap(scratch);
}

/// n vectors, one array per coordinate.
template <class Real>
struct VectorField {
  std::vector<Real> x, y, z;

  std::size_t size() const { return x.size(); }
  std::size_t bytes() const { return (x.capacity() + y.capacity() + z.capacity()) * sizeof(Real); }
  void resize(std::size_t n) {
    x.resize(n);
    y.resize(n);
    z.resize(n);
  }
  Vec3<Real> at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Vec3<Real>& value) {
    x[i] = value.x();
    y[i] = value.y();
    z[i] = value.z();
  }
  void add(std::size_t i, const Vec3<Real>& value) { set(i, at(i) + value); }
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.x, self.y, self.z);
  }
};

template <class Real>
void permute(VectorField<Real>& field, const std::vector<Index>& order,
             std::vector<Real>& scratch) {
  permute(field.x, order, scratch);
  permute(field.y, order, scratch);
  permute(field.z, order, scratch);
}

/// Particles may be added and removed. They keep their ids; their indices change.
template <class Real>
struct Particles {
  VectorField<Real> position;     ///< (n) x_i, m
  VectorField<Real> predicted;    ///< (n) x_i*, m
  VectorField<Real> velocity;     ///< (n) v_i, m/s
  std::vector<std::uint32_t> id;  ///< (n) unique, never reused, not necessarily dense
  std::uint32_t next_id = 0;      ///< id of the next new particle
  std::size_t ghosts = 0;         ///< number of copies owned by another process, at the end
  std::vector<Real> scratch;      ///< (n) of reorder
  std::vector<std::uint32_t> id_scratch;

  /// n: owned particles followed by ghosts.
  std::size_t size() const { return id.size(); }
  /// Number of particles that this simulation moves and reports.
  std::size_t owned() const { return size() - ghosts; }
  std::size_t bytes() const {
    return position.bytes() + predicted.bytes() + velocity.bytes() +
           (id.capacity() + id_scratch.capacity()) * sizeof(std::uint32_t) +
           scratch.capacity() * sizeof(Real);
  }

  /// Moves particle order[k] to place k. Particles that `order` does not contain are removed.
  void reorder(const std::vector<Index>& order);

  /// Appends particles with the next ids.
  /// @param points, velocities as many of each, m and m/s
  void add(const std::vector<Vec3d>& points, const std::vector<Vec3d>& velocities);

  /// Between two frames; x* is x there.
  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.position, self.velocity, self.id);
  }
  /// @throws InvalidInput unless a checkpoint that was read holds `count` particles, each once
  void restore(std::size_t count);
};

/// Indices of the particles in the order of their ids.
/// @param id (n) unique
std::vector<Index> placesById(const std::vector<std::uint32_t>& id);

/// Range of ids that one block or one solid spawned.
struct Spawn {
  std::uint32_t first_id = 0;
  std::uint32_t count = 0;
};

}  // namespace ice_ice_baby
