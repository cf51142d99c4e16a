// Reads and writes plain values as bytes, for checkpoints.
//
// A class with state lists its members once, and the same list writes and reads them:
//   template <class Self, class Archive>
//   static void exchange(Self& self, Archive& archive) {
//     archive(self.a_, self.b_);
//   }
// A list may hold numbers, enums, strings, Eigen matrices and quaternions, classes with an
// `exchange` of their own, and vectors of these. Scratch memory and members that can be recomputed
// are not listed.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// Types that are copied byte by byte.
template <class T>
constexpr bool kPlain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <class T>
bool allFinite(const T* values, std::size_t count) {
  if constexpr (!std::is_floating_point_v<T>) return true;
  bool finite = true;
  for (std::size_t k = 0; k < count; ++k) finite &= std::isfinite(double(values[k]));
  return finite;
}

class StateWriter {
 public:
  template <class... Values>
  void operator()(const Values&... values) {
    (write(values), ...);
  }

  /// Writes a vector of any type; write_item(item) writes one element.
  template <class Item, class WriteItem>
  void list(const std::vector<Item>& items, const WriteItem& write_item) {
    write(std::uint64_t(items.size()));
    for (const Item& item : items) write_item(item);
  }

  /// Writes a value of a std::optional or the like. `made_of` are the constructor arguments that
  /// the reader uses.
  template <class Optional, class Made>
  void optional(const Optional& value, const Made&) {
    write(value.has_value());
    if (value) write(*value);
  }

  /// Reserves bytes that are filled in later.
  void skip(std::size_t bytes) { bytes_.resize(bytes_.size() + bytes); }

  const std::string& bytes() const { return bytes_; }
  std::string take() { return std::move(bytes_); }
  /// Whether every number so far was finite.
  bool finite() const { return finite_; }

 private:
  template <class T>
  void put(const T* values, std::size_t count) {
    finite_ = finite_ && allFinite(values, count);
    if (count > 0) bytes_.append(reinterpret_cast<const char*>(values), count * sizeof(T));
  }

  template <class T>
  void write(const T& value) {
    if constexpr (kPlain<T>) {
      put(&value, 1);
    } else {
      T::exchange(value, *this);
    }
  }
  template <class Real, int kRows, int kCols>
  void write(const Eigen::Matrix<Real, kRows, kCols>& value) {
    put(value.data(), kRows * kCols);
  }
  void write(const Eigen::Quaterniond& value) { write(value.coeffs()); }
  void write(const std::string& value) {
    write(std::uint64_t(value.size()));
    put(value.data(), value.size());
  }
  template <class T>
  void write(const std::vector<T>& values) {
    if constexpr (kPlain<T>) {
      write(std::uint64_t(values.size()));
      put(values.data(), values.size());
    } else {
      list(values, [&](const T& value) { write(value); });
    }
  }

  std::string bytes_;
  bool finite_ = true;
};

/// Safe on untrusted bytes: never allocates more memory than there are bytes to fill it.
/// Throws InvalidInput if the bytes end early or hold an invalid value.
class StateReader {
 public:
  explicit StateReader(std::string_view bytes) : bytes_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (read(values), ...);
  }

  template <class Item, class ReadItem>
  void list(std::vector<Item>& items, const ReadItem& read_item) {
    items.clear();
    // Every element takes at least one byte, so too great a length runs out of bytes.
    for (std::size_t count = readLength(1); count > 0; --count) read_item(items.emplace_back());
  }

  /// @param made_of constructor arguments of the value before it is read
  template <class Optional, class Made>
  void optional(Optional& value, const Made& made_of) {
    bool there = false;
    read(there);
    value.reset();
    if (there) read(value.emplace(made_of));
  }

  std::size_t left() const { return bytes_.size(); }

 private:
  static void require(bool fine, const char* what) {
    if (!fine) throw InvalidInput(what);
  }

  template <class T>
  void take(T* values, std::size_t count) {
    require(count <= bytes_.size() / sizeof(T), "it ends in the middle of its state");
    if (count > 0) std::memcpy(static_cast<void*>(values), bytes_.data(), count * sizeof(T));
    bytes_.remove_prefix(count * sizeof(T));
    require(allFinite(values, count), "it contains a number that is not finite");
  }

  std::size_t readLength(std::size_t bytes_each) {
    std::uint64_t length = 0;
    take(&length, 1);
    require(length <= bytes_.size() / bytes_each, "it contains a list longer than the file");
    return std::size_t(length);
  }

  template <class T>
  void read(T& value) {
    if constexpr (std::is_enum_v<T>) {
      std::underlying_type_t<T> number{};
      take(&number, 1);
      require(number >= 0 && std::size_t(number) < choices(T()).size(),
              "it holds a choice that does not exist");
      value = static_cast<T>(number);
    } else if constexpr (kPlain<T>) {
      take(&value, 1);
    } else {
      T::exchange(value, *this);
    }
  }
  void read(bool& value) {
    std::uint8_t byte = 0;
    take(&byte, 1);
    require(byte <= 1, "invalid boolean");
    value = byte != 0;
  }
  template <class Real, int kRows, int kCols>
  void read(Eigen::Matrix<Real, kRows, kCols>& value) {
    take(value.data(), kRows * kCols);
  }
  void read(Eigen::Quaterniond& value) { read(value.coeffs()); }
  void read(std::string& value) {
    value.resize(readLength(1));
    take(value.data(), value.size());
  }
  template <class T>
  void read(std::vector<T>& values) {
    if constexpr (kPlain<T>) {
      values.resize(readLength(sizeof(T)));
      take(values.data(), values.size());
    } else {
      list(values, [&](T& value) { read(value); });
    }
  }

  std::string_view bytes_;
};

}  // namespace ice_ice_baby
