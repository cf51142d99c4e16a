#include "ice_ice_baby/enthalpy_curve.h"

namespace ice_ice_baby {

EnthalpyCurve::EnthalpyCurve(const HeatParams& heat)
    : freezing_c_(heat.freezing_c),
      boiling_c_(heat.boiling_c),
      ice_j_kgk_(heat.ice_capacity_j_kgk),
      water_j_kgk_(heat.water_capacity_j_kgk),
      steam_j_kgk_(heat.steam_capacity_j_kgk),
      ice_w_mk_(heat.ice_conductivity_w_mk),
      water_w_mk_(heat.water_conductivity_w_mk),
      fusion_j_kg_(heat.fusion_j_kg),
      boils_j_kg_(fusion_j_kg_ + water_j_kgk_ * (boiling_c_ - freezing_c_)),
      steam_j_kg_(boils_j_kg_ + heat.vaporisation_j_kg),
      lowest_j_kg_(enthalpy(kTemperatureRange_c.min)),
      highest_j_kg_(enthalpy(kTemperatureRange_c.max)) {}

}  // namespace ice_ice_baby
