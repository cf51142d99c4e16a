// The report of a frame as a message.
#pragma once

#include <ice_ice_baby/State.h>

#include "simulation_thread.h"

namespace ice_ice_baby {

/// Everything but the loads of topics.
State stateMessage(const Snapshot& snapshot, const std_msgs::Header& header);

}  // namespace ice_ice_baby
