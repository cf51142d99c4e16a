// What vessels hold as a message.
#pragma once

#include <ice_ice_baby/Vessels.h>

#include <vector>

#include "ice_ice_baby/vessel_report.h"

namespace ice_ice_baby {

/// Everything but the time and what was spilled.
Vessels vesselsMessage(const std::vector<VesselReport>& reports, const std_msgs::Header& header);

}  // namespace ice_ice_baby
