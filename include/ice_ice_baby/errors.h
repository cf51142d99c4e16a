// The one error that bad input raises, worded for the person who typed it.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace ice_ice_baby {

/// Input that cannot be used. The message names the thing, the value, the allowed range and the
/// cure. Whatever throws it has changed nothing.
class InvalidInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "1.5", "1e-06": the shortest text that reads back as the same number.
std::string numberText(double value);

/// The text, cut at 100 bytes and at a NUL, control characters as \x0a, for a message of one line
/// that echoes what somebody sent.
std::string shortened(const std::string& text);

/// "a, b, c"; of what is longer than 2000 bytes the beginning, " and N more"
std::string joined(const std::vector<std::string>& words);

/// The entry of `known` that a mistyped `word` most likely meant, or "" when none is near. Words of
/// more than 100 bytes are no typing errors.
std::string nearest(const std::string& word, const std::vector<std::string>& known);

/// How a message on an unknown word goes on: "; did you mean KNOWN? Allowed: A, B", each known word
/// behind `prefix`, the list without it.
std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const std::string& prefix = "");

/// Throws InvalidInput unless `value` is finite and within [min, max].
void requireInRange(const std::string& thing, double value, double min, double max);

/// Bytes of a text of a scene at most, as its description.
constexpr std::size_t kLongestText = 1000;
/// Characters of the name of a tf frame at most.
constexpr std::size_t kLongestFrameName = 255;

/// Throws InvalidInput for more than kLongestText bytes and for control characters but line ends.
void requireText(const std::string& thing, const std::string& text);

/// Throws InvalidInput unless `name` may be, or end, the name of a tf frame: tf2 itself refuses no
/// more than an empty name and a leading slash.
void requireFrameName(const std::string& thing, const std::string& name);

}  // namespace ice_ice_baby
