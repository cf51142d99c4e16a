// How many substeps a frame takes when its time is bounded. Frames are made up: no clock is read.
#include "simulation/substep_control.h"

#include <gtest/gtest.h>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {
namespace substep_control_test {

/// Frames of a made-up machine on which every substep takes the same time.
class SubstepControlTest : public testing::Test {
 protected:
  SubstepControlTest() {
    scene_.solver.budget = 0.5;
    report_.density_error_mean = 0.01;  // more substeps than fit would be needed
  }

  /// Substeps per frame after some frames.
  int after(int frames, double substep_s) {
    SubstepControl control(scene_);
    for (int k = 0; k < frames; ++k) {
      ++report_.frame;
      control.measure(scene_, substep_s * control.substeps());
      control.follow(scene_, report_);
    }
    within_ = control.withinBudget(scene_);
    return control.substeps();
  }

  Scene scene_;
  StepReport report_;
  bool within_ = false;
};

TEST_F(SubstepControlTest, AsManyAsFitAreTaken) {
  // 0.5 / 60 s per frame: 8.33, 16.7 and 33.3 substeps of these
  for (const auto& [substep_s, fit] : {std::pair{1e-3, 8}, {5e-4, 16}, {2.5e-4, 33}}) {
    EXPECT_EQ(after(300, substep_s), fit) << substep_s;
    EXPECT_TRUE(within_) << substep_s;
  }
}

TEST_F(SubstepControlTest, TwiceTheBudgetTakesTwiceTheSubsteps) {
  for (const double budget : {0.2, 0.4, 0.8}) {
    scene_.solver.budget = budget;
    EXPECT_EQ(after(600, 1.0 / (60 * 50.5)), static_cast<int>(50.5 * budget));
  }
}

TEST_F(SubstepControlTest, NoMoreThanTheErrorOfAccurateNeeds) {
  report_.density_error_mean = 0.0002;
  EXPECT_LE(after(300, 1e-6), scene_.substepsForFall());
  EXPECT_TRUE(within_);
}

TEST_F(SubstepControlTest, NeverMoreThanTheMaximum) { EXPECT_EQ(after(300, 1e-9), kMaxSubsteps); }

TEST_F(SubstepControlTest, WaterThatNeedsMoreThanFitsStaysStableAndIsTold) {
  EXPECT_EQ(after(300, 5e-3), scene_.substepsForFall());
  EXPECT_FALSE(within_);
  report_.rms_speed_m_s = 3.0 * scene_.solver.frame_rate_hz * scene_.fluid.spacing_m;
  EXPECT_EQ(after(300, 5e-3), 6);  // twice the speed, at most a spacing per substep
  EXPECT_FALSE(within_);
}

TEST_F(SubstepControlTest, ANewBudgetIsFollowedOneByOne) {
  SubstepControl control(scene_);
  for (int k = 0; k < 300; ++k) {
    const int before = control.substeps();
    report_.frame = k + 1;
    if (k == 150) scene_.solver.budget = 0.1;
    control.measure(scene_, 5e-4 * control.substeps());
    control.follow(scene_, report_);
    EXPECT_LE(std::abs(control.substeps() - before), 1) << k;
  }
}

TEST_F(SubstepControlTest, WithoutABudgetTimeDoesNotMatter) {
  scene_.solver.budget = 0.0;
  scene_.solver.target_error = 0.002;
  const int quick = after(100, 1e-9), slow = after(100, 1.0);
  EXPECT_EQ(quick, slow);
  EXPECT_TRUE(within_);
}

TEST_F(SubstepControlTest, ALimitLeavesWhatKeepsWaterStable) {
  report_.rms_speed_m_s = 3.0 * scene_.solver.frame_rate_hz * scene_.fluid.spacing_m;
  for (const auto& [limit, taken] : {std::pair{20, 16}, {10, 10}, {6, 6}, {3, 6}}) {
    SubstepControl control(scene_);
    for (int k = 0; k < 300; ++k) {
      control.measure(scene_, 5e-4 * control.substeps());
      control.follow(scene_, report_);
    }
    control.limit(scene_, report_, limit);
    EXPECT_EQ(control.substeps(), taken) << limit;
  }
}

TEST(Budget, ExcludesATargetError) {
  Scene scene;
  scene.blocks.push_back({});
  scene.blocks[0].max_m = Vec3d(0.2, 0.2, 0.2);
  scene.solver.budget = 0.8;
  validate(scene);
  EXPECT_EQ(scene.promisedError(), 0.0);
  EXPECT_TRUE(scene.adaptsSubsteps());
  scene.solver.target_error = 0.001;
  try {
    validate(scene);
    FAIL() << "accepted";
  } catch (const InvalidInput& refusal) {
    EXPECT_STREQ(refusal.what(),
                 "solver.budget = 0.8 and solver.target_error = 0.001 ask for different numbers of "
                 "substeps; set one of them to 0");
  }
}

}  // namespace substep_control_test
}  // namespace ice_ice_baby
