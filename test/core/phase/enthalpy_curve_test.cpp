#include "phase/enthalpy_curve.h"

#include <gtest/gtest.h>

namespace ice_ice_baby {
namespace enthalpy_curve_test {

/// From ice to steam in degrees Celsius, with both phase changes and their neighbours.
const double kTemperatures[] = {-273.15, -40, -1e-9, 0, 1e-9, 4, 99.999, 100, 100.001, 1000};

TEST(EnthalpyCurveTest, TemperatureAndEnthalpyAreInverse) {
  const EnthalpyCurve curve{ThermalParams{}};
  for (const double celsius : kTemperatures) {
    EXPECT_NEAR(curve.temperature(curve.enthalpy(celsius)), celsius, 1e-12 * 1e3) << celsius;
  }
}

TEST(EnthalpyCurveTest, ZeroIsIceAboutToMeltAndTheLatentHeatIsWaterAboutToFreeze) {
  const EnthalpyCurve curve{ThermalParams{}};
  EXPECT_EQ(curve.temperature(0.0), 0.0);
  EXPECT_EQ(curve.iceFraction(0.0), 1.0);
  EXPECT_EQ(curve.enthalpy(0.0), 334e3);
  EXPECT_EQ(curve.iceFraction(334e3), 0.0);
  EXPECT_EQ(curve.iceFraction(334e3 / 4), 0.75);
  EXPECT_EQ(curve.iceFraction(-1e5), 1.0);
}

TEST(EnthalpyCurveTest, BoilingTakesTheLatentHeatAtOneTemperature) {
  const EnthalpyCurve curve{ThermalParams{}};
  const double boils = curve.enthalpy(100.0);
  EXPECT_DOUBLE_EQ(boils, 334e3 + 4186 * 100);
  EXPECT_EQ(curve.steamFraction(boils), 0.0);
  for (const double part : {0.25, 0.5, 0.75}) {
    EXPECT_NEAR(curve.steamFraction(boils + part * 2.26e6), part, 1e-12);
    EXPECT_EQ(curve.temperature(boils + part * 2.26e6), 100.0);
  }
  EXPECT_NEAR(curve.temperature(boils + 2.26e6 + 2010 * 50), 150.0, 1e-9);
  EXPECT_EQ(curve.steamFraction(curve.enthalpy(101.0)), 1.0);
}

TEST(EnthalpyCurveTest, TemperatureNeverFallsAndNowhereRisesFasterThanTheSteepest) {
  ThermalParams thermal;
  thermal.steam_specific_heat_j_kgk = 700;
  const EnthalpyCurve curve{thermal};
  EXPECT_DOUBLE_EQ(curve.steepest(), 1.0 / 700);
  const double step = 997.0;
  for (double h = -6e5; h < 4e6; h += step) {
    const double rise = curve.temperature(h + step) - curve.temperature(h);
    EXPECT_GE(rise, 0.0);
    EXPECT_LE(rise, curve.steepest() * step * (1 + 1e-9));
  }
}

TEST(EnthalpyCurveTest, ConductivityGoesFromIceToWater) {
  const EnthalpyCurve curve{ThermalParams{}};
  EXPECT_EQ(curve.conductivity(-1.0), 2.22);
  EXPECT_EQ(curve.conductivity(334e3), 0.58);
  EXPECT_NEAR(curve.conductivity(334e3 / 2), (2.22 + 0.58) / 2, 1e-12);
  EXPECT_EQ(curve.conductivity(curve.enthalpy(100.0) + 1.0), 0.58);
  EXPECT_EQ(curve.mostConductive(), 2.22);
}

TEST(EnthalpyCurveTest, PotentialIsTheIntegralOfTheConductivity) {
  const EnthalpyCurve curve{ThermalParams{}};
  EXPECT_EQ(curve.potential(0.0), 0.0);
  EXPECT_DOUBLE_EQ(curve.potential(-10.0), -22.2);
  EXPECT_DOUBLE_EQ(curve.potential(10.0), 5.8);
  EXPECT_DOUBLE_EQ(curve.steepestPotential(), 2.22 / 2050);
  ThermalParams thermal;
  thermal.steam_specific_heat_j_kgk = 10.0;
  EXPECT_DOUBLE_EQ(EnthalpyCurve{thermal}.steepestPotential(), 0.58 / 10.0);
}

TEST(EnthalpyCurveTest, StaysWithinTheTemperaturesThatASceneMayHave) {
  const EnthalpyCurve curve{ThermalParams{}};
  EXPECT_NEAR(curve.temperature(curve.clampToRange(-1e30)), -273.15, 1e-9);
  EXPECT_NEAR(curve.temperature(curve.clampToRange(1e30)), 1000.0, 1e-9);
  EXPECT_EQ(curve.clampToRange(1234.5), 1234.5);
}

}  // namespace enthalpy_curve_test
}  // namespace ice_ice_baby
