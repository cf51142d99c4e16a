#include "ice_ice_baby/heat.h"

#include <gtest/gtest.h>

#include "heat_fixture.h"

namespace ice_ice_baby {
namespace {}  // namespace
}  // namespace ice_ice_baby
