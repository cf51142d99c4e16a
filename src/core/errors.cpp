#include "ice_ice_baby/errors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace ice_ice_baby {

std::string numberText(double value) {
  char text[32];
  const auto result = std::to_chars(text, text + sizeof text, value + 0.0);  // no "-0"
  return std::string(text, result.ptr);
}

std::string shortened(const std::string& text) {
  constexpr std::size_t kMost = 100;
  const std::string whole = text.substr(0, text.find('\0'));
  return whole.size() <= kMost ? whole : whole.substr(0, kMost) + "...";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

namespace {

std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& known) {
  std::string best;
  std::size_t best_distance = word.size() / 2 + 1;
  for (const std::string& candidate : known) {
    const bool extends = !word.empty() && candidate.rfind(word, 0) == 0;
    const std::size_t distance = extends ? 1 : editDistance(word, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const std::string& prefix) {
  const std::string meant = nearest(word, known);
  if (meant.empty()) return "; allowed: " + joined(known);
  return "; did you mean " + prefix + meant + "? Allowed: " + joined(known);
}

void requireInRange(const std::string& thing, double value, double min, double max) {
  if (std::isfinite(value) && value >= min && value <= max) return;
  throw InvalidInput(thing + " = " + numberText(value) + " is outside the allowed range [" +
                     numberText(min) + ", " + numberText(max) + "]");
}

}  // namespace ice_ice_baby
