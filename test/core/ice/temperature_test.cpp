#include "ice/temperature.h"

#include <gtest/gtest.h>

namespace ice_ice_baby {
namespace temperature_test {

Scene sceneAt(double initial_c) {
  Scene scene;
  scene.temperature.initial_c = initial_c;
  return scene;
}

TEST(TemperatureTest, StrictnessRisesFromOnsetToFreezing) {
  struct Case {
    double celsius, strictness;
  };
  for (const Case& c : {Case{1000, 0}, Case{20, 0}, Case{4, 0}, Case{3, 0.25}, Case{2, 0.5},
                        Case{1, 0.75}, Case{0, 1}, Case{-0.1, 1}, Case{-273.15, 1}}) {
    EXPECT_DOUBLE_EQ(Temperature(sceneAt(c.celsius)).strictness(), c.strictness) << c.celsius;
  }
}

TEST(TemperatureTest, RampIsLinearAndEndsExactly) {
  Temperature temperature(sceneAt(20));
  temperature.advanceTo(1.0);
  temperature.set(-10, 3.0);
  EXPECT_EQ(temperature.celsius(), 20);
  temperature.advanceTo(2.0);
  EXPECT_NEAR(temperature.celsius(), 10, 1e-12);
  temperature.advanceTo(3.5);
  EXPECT_NEAR(temperature.celsius(), -5, 1e-12);
  temperature.advanceTo(4.0);
  EXPECT_EQ(temperature.celsius(), -10);
  temperature.advanceTo(1e6);
  EXPECT_EQ(temperature.celsius(), -10);
}

TEST(TemperatureTest, WithoutARampItIsThereAtOnce) {
  Temperature temperature(sceneAt(20));
  temperature.set(-5, 0);
  EXPECT_EQ(temperature.celsius(), -5);
}

TEST(TemperatureTest, ANewTargetStartsFromWhereTheRampHasCome) {
  Temperature temperature(sceneAt(20));
  temperature.set(0, 2.0);
  temperature.advanceTo(1.0);
  temperature.set(30, 2.0);
  temperature.advanceTo(2.0);
  EXPECT_NEAR(temperature.celsius(), 20, 1e-12);
}

TEST(TemperatureTest, ScheduleRunsInOrderOfTimeWhateverItsOrderInTheFile) {
  Scene scene = sceneAt(20);
  scene.schedule = {{4.0, 50, 0.0}, {1.0, 0, 2.0}};
  Temperature temperature(scene);
  temperature.advanceTo(0.5);
  EXPECT_EQ(temperature.celsius(), 20);
  temperature.advanceTo(2.0);
  EXPECT_NEAR(temperature.celsius(), 10, 1e-12);
  temperature.advanceTo(3.9);
  EXPECT_EQ(temperature.celsius(), 0);
  temperature.advanceTo(4.0);
  EXPECT_EQ(temperature.celsius(), 50);
}

TEST(TemperatureTest, ScheduleDoesNotDependOnTheStepsTaken) {
  Scene scene = sceneAt(20);
  scene.schedule = {{0.3, -10, 1.0}, {0.8, 40, 2.0}, {2.0, 5, 0.0}};
  Temperature fine(scene), coarse(scene);
  for (int k = 1; k <= 1900; ++k) fine.advanceTo(0.001 * k);
  coarse.advanceTo(1.9);
  EXPECT_NEAR(fine.celsius(), coarse.celsius(), 1e-9);
}

TEST(TemperatureTest, AnEventAtZeroHoldsFromTheStart) {
  Scene scene = sceneAt(20);
  scene.schedule = {{0.0, -3, 0.0}};
  EXPECT_EQ(Temperature(scene).celsius(), -3);
}

TEST(TemperatureTest, SetCancelsTheSchedule) {
  Scene scene = sceneAt(20);
  scene.schedule = {{1.0, -10, 0.0}};
  Temperature temperature(scene);
  temperature.set(30, 0);
  temperature.advanceTo(10);
  EXPECT_EQ(temperature.celsius(), 30);
}

}  // namespace temperature_test
}  // namespace ice_ice_baby
