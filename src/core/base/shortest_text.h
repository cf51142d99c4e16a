// The shortest text that reads back as the same number.
#pragma once

#include <charconv>
#include <cmath>
#include <ios>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

namespace ice_ice_baby {

/// "1.5", "1e-06", "inf": what std::to_chars gives, from streams.
template <class Real>
std::string shortestTextByStreams(Real value) {
  if (std::isnan(value)) return std::signbit(value) ? "-nan" : "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  const auto text = [value](std::ios_base::fmtflags format, int digits) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.setf(format, std::ios_base::floatfield);
    out.precision(digits);
    out << value;
    return out.str();
  };
  const auto readsBack = [value](const std::string& written) {
    std::istringstream in(written);
    in.imbue(std::locale::classic());
    Real back = 0;
    return in >> back && back == value;
  };
  int digits = 0;
  while (digits < std::numeric_limits<Real>::max_digits10 - 1 &&
         !readsBack(text(std::ios_base::scientific, digits))) {
    ++digits;
  }
  const std::string scientific = text(std::ios_base::scientific, digits);
  for (int decimals = 0;; ++decimals) {
    const std::string fixed = text(std::ios_base::fixed, decimals);
    if (fixed.size() > scientific.size()) return scientific;
    if (readsBack(fixed)) return fixed;
  }
}

/// The same for any locale, fast where the standard library can: GCC writes numbers of floating
/// point with std::to_chars from version 11 on.
template <class Real>
std::string shortestText(Real value) {
#ifdef __cpp_lib_to_chars
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
#else
  return shortestTextByStreams(value);
#endif
}

}  // namespace ice_ice_baby
