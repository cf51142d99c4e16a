#include "output_space.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace fs = std::filesystem;

void requireDiskSpace(const RunOutputs& outputs, const Scene& scene, double duration_s) {
  const double rate_hz = scene.solver.frame_rate_hz;
  const double pictures = std::ceil(duration_s * std::min(outputs.frames_hz, rate_hz));
  if (outputs.folders.any() && pictures > kMaxPictures) {
    throw InvalidInput("--frames, --surface or --export would write " + numberText(pictures) +
                       " files, more than " + numberText(kMaxPictures) +
                       "; lower --frames-hz or --duration");
  }
  if (outputs.record.empty()) return;
  const double sample_hz = outputs.sample_hz > 0.0 ? std::min(outputs.sample_hz, rate_hz) : rate_hz;
  const double samples = std::ceil(duration_s * sample_hz) + 1;
  const double bytes = samples * double(particleCount(scene)) * 3 * sizeof(float);
  std::error_code error;
  const fs::space_info space = fs::space(fs::absolute(outputs.record).parent_path(), error);
  if (error || bytes <= double(space.available)) return;  // the recorder reports a bad folder
  throw InvalidInput("--record would write " + numberText(std::ceil(bytes / 1e6)) + " MB to " +
                     outputs.record + ", which has " +
                     numberText(std::floor(double(space.available) / 1e6)) +
                     " MB free; lower --sample-hz or --duration");
}

}  // namespace ice_ice_baby
