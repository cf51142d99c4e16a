#include "ice_ice_baby/checkpoint.h"

#include <zlib.h>

#include <cstddef>
#include <cstring>

#include "base/archive.h"
#include "base/machine_memory.h"
#include "checkpoint/scene_archive.h"
#include "ice_ice_baby/errors.h"
#include "loading/memory_need.h"
#include "loading/mesh_files.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

namespace {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "checkpoints have the least byte first");

/// Increase it whenever the members listed by an `exchange` change.
constexpr std::uint32_t kVersion = 7;

constexpr std::string_view kMagic = "iib-ckpt";

/// Precedes the state. The checksum covers the state and the header without the checksum.
struct Header {
  char magic[8];
  std::uint32_t version;
  std::uint32_t real_bytes;  ///< precision: 4 or 8
  std::uint64_t state_bytes;
  std::uint32_t names;  ///< checksum of the names of scene keys and reported numbers
  std::uint32_t checksum;
};
static_assert(sizeof(Header) == 32 && std::is_trivially_copyable_v<Header>);

/// CRC-32 of zlib, continued from the checksum of the preceding bytes.
std::uint32_t crc32Of(std::string_view bytes, std::uint32_t before = 0) {
  const auto* first = reinterpret_cast<const Bytef*>(bytes.data());
  return static_cast<std::uint32_t>(crc32_z(before, first, bytes.size()));
}

std::uint32_t checksumOf(const Header& header, std::string_view state) {
  const auto* first = reinterpret_cast<const char*>(&header);
  return crc32Of(state, crc32Of({first, offsetof(Header, checksum)}));
}

std::uint32_t namesChecksum() {
  Scene scene;
  StepReport report;
  SceneKeys names;
  describe(scene, names);
  describeReproducible(names, report);
  return crc32Of(names.names());
}

std::uint32_t realBytes(Precision precision) { return precision == Precision::kDouble ? 8 : 4; }

/// Returns the state after checking its header.
std::string_view checkedState(std::string_view bytes, Header& header) {
  if (bytes.size() < kMagic.size() || bytes.substr(0, kMagic.size()) != kMagic) {
    throw InvalidInput("not a checkpoint; run_scene --save and the service save make them");
  }
  if (bytes.size() < sizeof header) {
    throw InvalidInput("truncated: " + std::to_string(bytes.size()) +
                       " bytes, of which not even the header is whole; load an older one");
  }
  std::memcpy(&header, bytes.data(), sizeof header);
  const std::string_view state = bytes.substr(sizeof header);
  if (header.version != kVersion) {
    throw InvalidInput("a checkpoint of version " + std::to_string(header.version) +
                       ", and this program reads version " + std::to_string(kVersion) +
                       "; load it with the program that saved it");
  }
  if (header.state_bytes != state.size()) {
    const std::string whole = header.state_bytes > state.size() ? "truncated" : "too long";
    throw InvalidInput(whole + ": " + std::to_string(bytes.size()) + " bytes of " +
                       std::to_string(header.state_bytes + sizeof header) + "; load an older one");
  }
  if (header.checksum != checksumOf(header, state)) {
    throw InvalidInput("damaged: its checksum does not match its content; load an older one");
  }
  if (header.real_bytes != 4 && header.real_bytes != 8) {
    throw InvalidInput("it holds numbers of " + std::to_string(header.real_bytes) +
                       " bytes, and this program knows 4 (float) and 8 (double)");
  }
  if (header.names != namesChecksum()) {
    throw InvalidInput(
        "its scene has other keys, or its report other numbers, than this program knows; load it "
        "with the program that saved it");
  }
  return state;
}

template <class Real>
std::unique_ptr<Simulation> simulationFrom(StateReader& reader, int threads) {
  Scene scene;
  describe(scene, SceneArchive<StateReader>(reader));
  readMeshFiles(scene);
  for (const Mesh& mesh : scene.meshes) {
    std::uint32_t checksum = 0;
    reader(checksum);
    if (checksum == checksumOf(*mesh.triangles)) continue;
    throw InvalidInput("mesh " + mesh.name + ": " + shortened(mesh.file) +
                       " has changed since the checkpoint was saved; put the former file back");
  }
  validate(scene);
  requireMemory(scene, machineMemory_bytes());
  std::uint32_t particles = 0, came = 0;
  reader(particles, came);
  constexpr std::size_t kMin_bytes =
      9 * sizeof(Real);  // positions, velocities, positions of the lists
  const bool fits = particles <= reader.left() / kMin_bytes;
  const std::uint64_t ever = std::uint64_t(particleCount(scene)) + came;
  if (!fits || particles > ever || ever > kNone) {
    throw InvalidInput("invalid checkpoint: " + std::to_string(particles) +
                       " particles where there have been " + std::to_string(ever));
  }
  auto simulation = std::make_unique<Simulator<Real>>(scene, threads);
  simulation->read(reader, particles, came);
  if (reader.left() > 0) throw InvalidInput("it contains data after the end of its state");
  return simulation;
}

}  // namespace

std::string encodeCheckpoint(const Simulation& simulation) {
  StateWriter writer;
  writer.skip(sizeof(Header));
  simulation.write(writer);
  if (!writer.finite()) {
    throw InvalidInput("a value of scene " + simulation.scene().name +
                       " is not finite, so no checkpoint is made of it; go back to an older one");
  }
  std::string bytes = writer.take();
  Header header{};
  std::memcpy(header.magic, kMagic.data(), sizeof header.magic);
  header.version = kVersion;
  header.real_bytes = realBytes(simulation.precision());
  header.names = namesChecksum();
  header.state_bytes = bytes.size() - sizeof header;
  header.checksum = checksumOf(header, std::string_view(bytes).substr(sizeof header));
  std::memcpy(bytes.data(), &header, sizeof header);
  return bytes;
}

std::unique_ptr<Simulation> decodeCheckpoint(std::string_view bytes, const std::string& origin,
                                             int threads) {
  requireInRange("threads", threads, 0, 1024);
  try {
    Header header{};
    StateReader reader(checkedState(bytes, header));
    if (header.real_bytes == sizeof(float)) return simulationFrom<float>(reader, threads);
    return simulationFrom<double>(reader, threads);
  } catch (const InvalidInput& e) {
    throw InvalidInput(origin + ": " + e.what());
  }
}

void saveCheckpoint(const Simulation& simulation, const std::string& path) {
  writeCheckpoint(encodeCheckpoint(simulation), path);
}

}  // namespace ice_ice_baby
