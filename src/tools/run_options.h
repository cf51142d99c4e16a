// The command line of run_scene.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "frame_loop.h"

namespace ice_ice_baby {

/// "" where nothing is given.
struct Options {
  std::string scene;
  std::string preset;
  std::string quality;
  std::optional<double> duration_s;
  int threads = 0;
  std::string precision;
  std::vector<std::string> overrides;
  std::string report;
  std::string particles;
  std::string load;
  RunOutputs outputs;
  bool profile = false;
  bool list = false;
  bool defaults = false;
};

/// Declares every option, its meaning and examples.
void describeOptions(CLI::App& app, Options& options);

}  // namespace ice_ice_baby
