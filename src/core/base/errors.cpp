#include "ice_ice_baby/errors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/shortest_text.h"

namespace ice_ice_baby {

namespace {

bool isControl(unsigned char byte) { return byte < 0x20 || byte == 0x7f; }

}  // namespace

std::string numberText(double value) {
  if (std::isnan(value)) return "nan";  // without a sign
  return shortestText(value + 0.0);     // no "-0"
}

std::string shortened(const std::string& text) {
  constexpr std::size_t kMax = 100;
  constexpr char kDigits[] = "0123456789abcdef";
  std::string out;
  for (const char* c = text.c_str(); *c; ++c) {
    const auto byte = static_cast<unsigned char>(*c);
    const bool within_character = (byte & 0xc0) == 0x80;  // of UTF-8
    if (out.size() >= kMax && !within_character) return out + "...";
    if (isControl(byte)) {
      out += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
    } else if (out.size() < kMax + 3) {
      out += *c;
    }
  }
  return out;
}

std::string joined(const std::vector<std::string>& words) {
  constexpr std::size_t kMax = 2000;
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (text.size() > kMax) return text + " and " + std::to_string(words.size() - k) + " more";
    text += (text.empty() ? "" : ", ") + words[k];
  }
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
  constexpr std::size_t kLongestWord = 100;  // bounds the time of the search
  if (word.size() > kLongestWord) return "";
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

void requireText(const std::string& thing, const std::string& text) {
  if (text.size() > kLongestText) {
    throw InvalidInput(thing + " = " + shortened(text) + " has " + std::to_string(text.size()) +
                       " bytes; at most " + std::to_string(kLongestText) + " are allowed");
  }
  const auto bad = std::find_if(text.begin(), text.end(),
                                [](unsigned char c) { return isControl(c) && c != '\n'; });
  if (bad == text.end()) return;
  throw InvalidInput(thing + " = " + shortened(text) + " holds a control character, code " +
                     std::to_string(static_cast<unsigned char>(*bad)) + "; remove it");
}

void requireFrameName(const std::string& thing, const std::string& name) {
  const bool plain =
      std::all_of(name.begin(), name.end(), [](unsigned char c) { return c > ' ' && c < 0x7f; });
  const bool slash_at_end = !name.empty() && (name.front() == '/' || name.back() == '/');
  if (!name.empty() && name.size() <= kLongestFrameName && plain && !slash_at_end) return;
  throw InvalidInput(thing + " = \"" + shortened(name) + "\" must be fit for a tf frame: 1 to " +
                     std::to_string(kLongestFrameName) +
                     " ASCII characters without spaces, no / at either end");
}

}  // namespace ice_ice_baby
