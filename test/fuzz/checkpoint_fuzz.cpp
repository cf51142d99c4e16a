#include <zlib.h>

#include <cstdint>
#include <cstring>

#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"
#include "ice_ice_baby/scene_loader.h"
#include "promises.h"

namespace ice_ice_baby::fuzz {

namespace {

/// Without boundary density, whose tables take a second with sanitizers.
constexpr char kCheckpointScene[] = R"(
fluid: {spacing_m: 0.05, boundary_density: false}
thermal: {enabled: true}
solver: {quality: fast}
blocks: [{min_m: [-0.1, -0.1, 0], max_m: [0.1, 0.1, 0.1], celsius: -1},
         {min_m: [-0.1, -0.1, 0.1], max_m: [0.1, 0.1, 0.2], celsius: 5}]
planes: [{name: ground, heat: temperature}]
)";

/// From doc/checkpoints.md: size of the state at 16, checksum at 28, state at 32.
constexpr std::size_t kSizePlace = 16;
constexpr std::size_t kChecksumPlace = 28;
constexpr std::size_t kHeader_bytes = 32;

/// An edit is a place, in 1/65536 of the checkpoint, and the four bytes to put there.
constexpr std::size_t kEdit_bytes = 6;

std::string freshCheckpoint() {
  const auto simulation = makeSimulation(parseScene(kCheckpointScene), Precision::kFloat, 1);
  simulation->advanceFrame();
  return encodeCheckpoint(*simulation);
}

/// Without this the checksum would stop the fuzzer.
void mendChecksum(std::string& checkpoint) {
  const std::uint64_t state_bytes = checkpoint.size() - kHeader_bytes;
  std::memcpy(checkpoint.data() + kSizePlace, &state_bytes, sizeof state_bytes);
  const auto* bytes = reinterpret_cast<const Bytef*>(checkpoint.data());
  const uLong header = crc32_z(0, bytes, kChecksumPlace);
  const auto all = static_cast<std::uint32_t>(crc32_z(header, bytes + kHeader_bytes, state_bytes));
  std::memcpy(checkpoint.data() + kChecksumPlace, &all, sizeof all);
}

std::string edited(std::string checkpoint, const std::string& edits) {
  for (std::size_t k = 0; k + kEdit_bytes <= edits.size(); k += kEdit_bytes) {
    std::uint16_t where = 0;
    std::memcpy(&where, edits.data() + k, sizeof where);
    const std::size_t place = where * (checkpoint.size() - 4) / 65536;
    std::memcpy(checkpoint.data() + place, edits.data() + k + sizeof where, 4);
  }
  mendChecksum(checkpoint);
  return checkpoint;
}

void load(const std::string& bytes) {
  try {
    const auto simulation = decodeCheckpoint(bytes, "fuzz.iib", 1);
    // Particles come and go during a run: the state says how many there are, not the scene.
    if (isSmall(simulation->scene(), simulation->report().particles)) runTwoFrames(*simulation);
  } catch (const InvalidInput& e) {
    requireReadable(e.what());
  }
}

}  // namespace

/// Loads the bytes as they are, then as edits of a valid checkpoint.
void checkpoint(const std::string& bytes) {
  static const std::string fresh = freshCheckpoint();
  load(bytes);
  load(edited(fresh, bytes));
}

}  // namespace ice_ice_baby::fuzz
