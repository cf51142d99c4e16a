#include "phase/enthalpy_curve.h"

namespace ice_ice_baby {

EnthalpyCurve::EnthalpyCurve(const ThermalParams& thermal)
    : freezing_c_(thermal.freezing_c),
      boiling_c_(thermal.boiling_c),
      ice_j_kgk_(thermal.ice_specific_heat_j_kgk),
      water_j_kgk_(thermal.water_specific_heat_j_kgk),
      steam_j_kgk_(thermal.steam_specific_heat_j_kgk),
      ice_w_mk_(thermal.ice_conductivity_w_mk),
      water_w_mk_(thermal.water_conductivity_w_mk),
      fusion_j_kg_(thermal.latent_heat_fusion_j_kg),
      boils_j_kg_(fusion_j_kg_ + water_j_kgk_ * (boiling_c_ - freezing_c_)),
      steam_j_kg_(boils_j_kg_ + thermal.latent_heat_vaporisation_j_kg),
      lowest_j_kg_(enthalpy(kTemperatureRange_c.min)),
      highest_j_kg_(enthalpy(kTemperatureRange_c.max)) {}

}  // namespace ice_ice_baby
