#include "vessels_message.h"

#include <type_traits>

namespace ice_ice_baby {

Vessels vesselsMessage(const std::vector<VesselReport>& reports, const std_msgs::Header& header) {
  Vessels message;
  message.header = header;
  for (const VesselReport& report : reports) {
    Vessel& vessel = message.vessels.emplace_back();
    vessel.name = report.name;
    const auto carry = [](const char*, const auto& reported, auto& field, const char*) {
      field = static_cast<std::decay_t<decltype(field)>>(reported);
    };
    describeVessel(carry, report, vessel);
  }
  return message;
}

}  // namespace ice_ice_baby
