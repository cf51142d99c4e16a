#include "metrics/martin_moyce.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ice_ice_baby {
namespace {

TEST(FrontError, IsZeroForTheMeasuredFrontItself) {
  EXPECT_NEAR(frontError(martinMoyceWide(), martinMoyceWide()), 0.0, 1e-12);
  EXPECT_NEAR(frontError(martinMoyceNarrow(), martinMoyceNarrow()), 0.0, 1e-12);
}

TEST(FrontError, IsRelative) {
  std::vector<FrontPoint> run = martinMoyceWide();
  for (FrontPoint& point : run) point.front *= 1.07;
  EXPECT_NEAR(frontError(run, martinMoyceWide()), 0.07, 1e-12);
}

TEST(FrontError, LeavesOutWhatIsEarlyOrLate) {
  std::vector<FrontPoint> run = martinMoyceWide();
  run.front().front = 100;  // at T = 0.8
  run.back().front = 100;   // at T = 9.2
  EXPECT_NEAR(frontError(run, martinMoyceWide()), 0.0, 1e-12);
}

TEST(FrontError, IsUnknownForARunThatIsTooShort) {
  EXPECT_TRUE(std::isnan(frontError({}, martinMoyceWide())));
  EXPECT_TRUE(std::isnan(frontError({{0, 1}, {3.9, 5}}, martinMoyceWide())));
}

}  // namespace
}  // namespace ice_ice_baby
