// The exception for invalid input, and functions that word its messages.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace ice_ice_baby {

/// Invalid input. The message names the thing, its value, the allowed range and the cure. A
/// function that throws it has changed nothing.
class InvalidInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The shortest text that reads back as the same number, for example "1.5" or "1e-06".
std::string numberText(double value);

/// The text, cut at 100 bytes or at a NUL, with control characters written as \x0a. For messages of
/// one line that quote input.
std::string shortened(const std::string& text);

/// "a, b, c"; a list longer than 2000 bytes is cut and ends in " and N more".
std::string joined(const std::vector<std::string>& words);

/// The entry of `known` nearest to a mistyped `word`, or "" if none is near. Words longer than 100
/// bytes have no nearest entry.
std::string nearest(const std::string& word, const std::vector<std::string>& known);

/// Second half of a message about an unknown word: "; did you mean KNOWN? Allowed: A, B". KNOWN is
/// preceded by `prefix`, the entries of the list are not.
std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const std::string& prefix = "");

/// Throws InvalidInput unless `value` is finite and within [min, max].
void requireInRange(const std::string& thing, double value, double min, double max);

/// Maximum length of a text in a scene file, in bytes.
constexpr std::size_t kLongestText = 1000;
/// Maximum length of a tf frame name, in characters.
constexpr std::size_t kLongestFrameName = 255;

/// Throws InvalidInput for more than kLongestText bytes and for control characters other than line
/// breaks.
void requireText(const std::string& thing, const std::string& text);

/// Throws InvalidInput unless `name` can be a tf frame name or its last part. tf2 itself refuses
/// only an empty name and a leading slash.
void requireFrameName(const std::string& thing, const std::string& name);

}  // namespace ice_ice_baby
