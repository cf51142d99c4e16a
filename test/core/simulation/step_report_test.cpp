// What a frame reports is described in full, so that nothing is missing from files and messages.
#include "ice_ice_baby/step_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "ice_ice_baby/quality_warning.h"

namespace ice_ice_baby {
namespace step_report_test {

/// Bytes of a member, from the start of its struct.
struct Span {
  std::size_t begin, size;
};

TEST(StepReportTest, DescribesEveryMember) {
  StepReport report;
  std::vector<Span> members;
  describe(report, [&](const char*, auto& value, const char*) {
    const auto at = reinterpret_cast<const char*>(&value) - reinterpret_cast<char*>(&report);
    members.push_back({std::size_t(at), sizeof value});
  });
  std::sort(members.begin(), members.end(),
            [](const Span& a, const Span& b) { return a.begin < b.begin; });
  members.push_back({sizeof report, alignof(StepReport)});
  std::size_t end = 0;
  for (const Span& member : members) {
    EXPECT_LT(member.begin - end, member.size) << "undescribed bytes from " << end;
    end = member.begin + member.size;
  }
}

TEST(StepReportTest, EveryNumberHasANameOfItsOwnAndAMeaning) {
  std::set<std::string> names;
  describe(StepReport(), [&](const char* name, const auto&, const char* meaning) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_GT(std::string(meaning).size(), 5u) << name;
  });
  EXPECT_EQ(names.count("frame_wall_s"), 1u);
}

TEST(StepReportTest, WhatIsReproducibleIsAllButTheWallClock) {
  std::set<std::string> all, reproducible;
  const StepReport report;
  describe(report, [&](const char* name, const auto&, const char*) { all.insert(name); });
  describeReproducible(
      [&](const char* name, const auto&, const char*) { reproducible.insert(name); }, report);
  reproducible.insert("frame_wall_s");
  EXPECT_EQ(all, reproducible);
}

TEST(StepReportTest, ABrokenPromiseIsToldWithItsCure) {
  StepReport report;
  report.promised_error = 0.002;
  report.density_error_run = 0.00425;
  report.substeps = 6;
  EXPECT_EQ(qualityWarning(report), "");
  report.quality_met = false;
  EXPECT_EQ(qualityWarning(report),
            "the mean density error, 0.425 %, is larger than the 0.2 % asked for; set "
            "solver.substeps to 0, so that their number follows the error, or choose a lower "
            "solver.quality");
  report.substeps = 64;
  EXPECT_NE(qualityWarning(report).find("64 substeps per frame are not enough: raise"),
            std::string::npos);
}

}  // namespace step_report_test
}  // namespace ice_ice_baby
