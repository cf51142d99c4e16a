// The files of run_scene hold every number that a frame and a run describe.
#include "run_report.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "ice_ice_baby/scene_loader.h"
#include "metrics/error_metrics.h"
#include "series_writer.h"

namespace ice_ice_baby {
namespace {

std::string textOf(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  std::remove(path.c_str());
  return text.str();
}

std::unique_ptr<Simulation> twoFrames() {
  auto simulation = makeSimulation(parseScene(R"(
    thermal: {enabled: true}
    blocks: [{min_m: [0, 0, 0], max_m: [0.06, 0.06, 0.06]}])"));
  simulation->advanceFrame();
  simulation->advanceFrame();
  return simulation;
}

TEST(RunReportTest, HasEveryNumberOfTheRunAndOfItsLastFrame) {
  const auto simulation = twoFrames();
  RunRecord record;
  record.precision = "float";
  record.density_error_mean = 0.25;
  record.addFrame(simulation->report());
  const std::string path = testing::TempDir() + "run_report_test.json";
  writeReport(path, *simulation, record);
  const auto json = nlohmann::json::parse(textOf(path));
  std::set<std::string> of_run;
  describe(record, [&](const char* name, const auto& value, const char* meaning) {
    EXPECT_EQ(json.value(name, nlohmann::json()), nlohmann::json(value)) << name;
    EXPECT_FALSE(std::string(meaning).empty());
    of_run.insert(name);
  });
  describe(simulation->report(), [&](const std::string& name, const auto& value, const char*) {
    if (of_run.count(name) > 0) return;
    const std::string key = name == "frame"    ? "frames"
                            : name == "time_s" ? "simulated_time_s"
                                               : name;
    EXPECT_EQ(json.value(key, nlohmann::json()), nlohmann::json(value)) << name;
  });
  EXPECT_EQ(json["frames"], 2);
  EXPECT_EQ(json["density_error_mean"], 0.25) << "of the run, not of the last frame";
}

TEST(SeriesWriterTest, HasAColumnForEveryNumberOfAFrame) {
  const auto simulation = twoFrames();
  std::vector<ParticleSample> particles;
  simulation->sample(particles);
  const std::string path = testing::TempDir() + "series_writer_test.csv";
  {
    SeriesWriter series(path);
    series.add({*simulation, particles, measureDensityError(*simulation), 0.5});
    series.add({*simulation, particles, measureDensityError(*simulation), 0.5});
  }
  std::istringstream lines(textOf(path));
  std::string header, row, line;
  std::getline(lines, header);
  std::map<std::string, double> values;
  std::getline(lines, row);
  std::istringstream names(header), numbers(row);
  for (std::string name, number; std::getline(names, name, ',');) {
    ASSERT_TRUE(std::getline(numbers, number, ','));
    EXPECT_TRUE(values.emplace(name, std::stod(number)).second) << name << " twice";
  }
  describeReproducible(
      [&](const std::string& name, const auto& value, const char*) {
        const std::string column = name.rfind("density_error", 0) == 0 ? "own_" + name : name;
        ASSERT_EQ(values.count(column), 1u) << column;
        EXPECT_EQ(values[column], double(value)) << column;
      },
      simulation->report());
  EXPECT_EQ(values["wall_s"], 0.5);
  EXPECT_LT(values["min_z_m"], values["max_z_m"]);
  EXPECT_TRUE(std::getline(lines, line) && line != header);
  EXPECT_FALSE(std::getline(lines, line));
}

}  // namespace
}  // namespace ice_ice_baby
