// Temperature, ice fraction, steam fraction and conductivity of water as functions of its specific
// enthalpy.
#pragma once

#include <algorithm>

#include "ice_ice_baby/params.h"

namespace ice_ice_baby {

/// Specific enthalpy H in J/kg, 0 for ice at the freezing point and rising through water to steam.
/// The temperature is constant while latent heat is absorbed, so H determines the state and T alone
/// does not.
class EnthalpyCurve {
 public:
  explicit EnthalpyCurve(const ThermalParams& thermal);

  /// T in degrees Celsius; a non-decreasing function of H.
  double temperature(double enthalpy_j_kg) const {
    const double h = enthalpy_j_kg;
    if (h < 0.0) return freezing_c_ + h / ice_j_kgk_;
    if (h <= fusion_j_kg_) return freezing_c_;
    if (h < boils_j_kg_) return freezing_c_ + (h - fusion_j_kg_) / water_j_kgk_;
    if (h <= steam_j_kg_) return boiling_c_;
    return boiling_c_ + (h - steam_j_kg_) / steam_j_kgk_;
  }

  /// The inverse. At exactly the freezing or boiling point, where it is not unique, all of it is
  /// water.
  double enthalpy(double celsius) const {
    if (celsius < freezing_c_) return ice_j_kgk_ * (celsius - freezing_c_);
    if (celsius > boiling_c_) return steam_j_kg_ + steam_j_kgk_ * (celsius - boiling_c_);
    return fusion_j_kg_ + water_j_kgk_ * (celsius - freezing_c_);
  }

  /// Ice fraction by mass.
  double iceFraction(double enthalpy_j_kg) const {
    return std::clamp(1.0 - enthalpy_j_kg / fusion_j_kg_, 0.0, 1.0);
  }

  /// Steam fraction by mass.
  double steamFraction(double enthalpy_j_kg) const {
    return std::clamp((enthalpy_j_kg - boils_j_kg_) / (steam_j_kg_ - boils_j_kg_), 0.0, 1.0);
  }

  /// W/(m K); interpolated between ice and water by ice fraction.
  double conductivity(double enthalpy_j_kg) const {
    const double ice = iceFraction(enthalpy_j_kg);
    return ice * ice_w_mk_ + (1.0 - ice) * water_w_mk_;
  }

  /// Conductivity integrated over temperature from the freezing point (Kirchhoff transform), W/m.
  /// The heat flow between two particles is proportional to its difference, wherever the freezing
  /// front lies between them.
  double potential(double celsius) const {
    const double above = celsius - freezing_c_;
    return above < 0.0 ? ice_w_mk_ * above : water_w_mk_ * above;
  }

  /// Nearest enthalpy whose temperature lies in kTemperatureRange_c.
  double clampToRange(double enthalpy_j_kg) const {
    return std::clamp(enthalpy_j_kg, lowest_j_kg_, highest_j_kg_);
  }

  /// Largest dT/dH, K kg/J: one over the smallest heat capacity.
  double steepest() const { return 1.0 / std::min({ice_j_kgk_, water_j_kgk_, steam_j_kgk_}); }

  /// Largest slope of the potential over H, kg/(m s).
  double steepestPotential() const {
    const double liquid = water_w_mk_ / std::min(water_j_kgk_, steam_j_kgk_);
    return std::max(ice_w_mk_ / ice_j_kgk_, liquid);
  }

  /// Largest conductivity, W/(m K).
  double mostConductive() const { return std::max(ice_w_mk_, water_w_mk_); }

 private:
  double freezing_c_, boiling_c_;
  double ice_j_kgk_, water_j_kgk_, steam_j_kgk_;  ///< heat capacities
  double ice_w_mk_, water_w_mk_;                  ///< conductivities
  double fusion_j_kg_;                            ///< H of water at freezing_c_
  double boils_j_kg_;                             ///< H of water at boiling_c_
  double steam_j_kg_;                             ///< H of steam at boiling_c_
  double lowest_j_kg_, highest_j_kg_;
};

}  // namespace ice_ice_baby
