// Numbers in texts: roscpp passes what it cannot read on a command line as text, as 1e1 and [0, 0,
// 1].
#pragma once

#include <optional>
#include <string>

#include "ice_ice_baby/types.h"

namespace ice_ice_baby {

/// The number that is all of the text; none for any other text.
std::optional<double> numberIn(const std::string& text);

/// Three numbers, as "[0, 0, 1]"; none for any other text.
std::optional<Vec3d> vectorIn(const std::string& text);

}  // namespace ice_ice_baby
