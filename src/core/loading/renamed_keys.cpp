#include "loading/renamed_keys.h"

#include <map>

namespace ice_ice_baby {

std::string renamedKey(const std::string& former_name) {
  static const std::map<std::string, std::string> kPresentNames{
      {"heat", "thermal"},
      {"fusion_j_kg", "latent_heat_fusion_j_kg"},
      {"vaporisation_j_kg", "latent_heat_vaporisation_j_kg"},
      {"ice_capacity_j_kgk", "ice_specific_heat_j_kgk"},
      {"water_capacity_j_kgk", "water_specific_heat_j_kgk"},
      {"steam_capacity_j_kgk", "steam_specific_heat_j_kgk"},
      {"air_transfer_w_m2k", "air_heat_transfer_w_m2k"},
      {"transfer_w_m2k", "heat_transfer_w_m2k"},
      {"condensation_w_m2k", "condensation_heat_transfer_w_m2k"},
      {"wall_density", "boundary_density"},
      {"spin_rad_s", "angular_velocity_rad_s"},
  };
  const auto found = kPresentNames.find(former_name);
  return found == kPresentNames.end() ? "" : found->second;
}

}  // namespace ice_ice_baby
