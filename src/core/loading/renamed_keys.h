// Keys of scene files that used to have another name.
#pragma once

#include <string>

namespace ice_ice_baby {

/// Present name of a key that older scene files use, or "" for any other name.
std::string renamedKey(const std::string& former_name);

}  // namespace ice_ice_baby
