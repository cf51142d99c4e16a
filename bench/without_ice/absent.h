// Stands in for springs, temperature and what heat changes in a copy of the source in which they do
// not exist. Each constant is known when the compiler runs, so every branch that needs them goes,
// and the copy links without their sources: scripts/bench --without-ice says how.
#pragma once

#include <cstdlib>

namespace ice_ice_baby {

/// An optional that is always empty.
template <class T>
struct Absent {
  constexpr explicit operator bool() const { return false; }
  constexpr bool has_value() const { return false; }
  void reset() {}
  template <class... Arguments>
  [[noreturn]] T& emplace(const Arguments&...) {
    std::abort();
  }
  T* operator->() const { return nullptr; }
  T& operator*() const { return *static_cast<T*>(nullptr); }
};

/// A strictness that is always 0.
struct Zero {
  constexpr operator double() const { return 0.0; }
  void operator=(double) {}
  template <class Self, class Archive>
  static void exchange(Self&, Archive&) {}
};

/// Water that is never asked how warm it is.
struct NoTemperature {
  template <class Scene>
  explicit NoTemperature(const Scene&) {}
  void advanceTo(double) {}
  [[noreturn]] void set(double, double) { std::abort(); }
  constexpr double celsius() const { return 20.0; }
  constexpr double strictness() const { return 0.0; }
  template <class Self, class Archive>
  static void exchange(Self&, Archive&) {}
  void restore() const {}
};

}  // namespace ice_ice_baby
