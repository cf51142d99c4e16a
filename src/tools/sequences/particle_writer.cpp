#include "sequences/particle_writer.h"

#include <algorithm>
#include <cstring>

#include "base/written_file.h"

namespace ice_ice_baby {

namespace {

std::string requireFormat(const std::string& format) {
  if (format == "vtk" || format == "ply") return format;
  throw InvalidInput("--export-format " + format + " must be vtk or ply");
}

/// Appends the bytes of a value, the last first for VTK.
template <class Value>
void append(std::string& bytes, Value value, bool reversed) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (reversed) std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

/// Calls visit(name, value) for what each particle has besides its position and velocity.
template <class Visit>
void forEachValue(const ParticleSample& p, const Visit& visit) {
  visit("temperature", p.temperature_c);
  visit("ice", p.ice_fraction);
  visit("density", p.density);
  visit("pressure", p.pressure_pa);
  visit("phase", static_cast<std::int32_t>(p.phase));
  visit("id", static_cast<std::int32_t>(p.id));
}

constexpr const char* typeName(float) { return "float"; }
constexpr const char* typeName(std::int32_t) { return "int"; }

std::string ply(const std::vector<ParticleSample>& particles) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\ncomment metres, seconds, Celsius, Pa\n";
  bytes += "element vertex " + std::to_string(particles.size()) + "\n";
  for (const char* name : {"x", "y", "z", "vx", "vy", "vz"}) {
    bytes += std::string("property float ") + name + "\n";
  }
  forEachValue({}, [&](const char* name, auto value) {
    bytes += std::string("property ") + typeName(value) + " " + name + "\n";
  });
  bytes += "end_header\n";
  for (const ParticleSample& p : particles) {
    for (const float value : {p.x, p.y, p.z, p.vx, p.vy, p.vz}) append(bytes, value, false);
    forEachValue(p, [&](const char*, auto value) { append(bytes, value, false); });
  }
  return bytes;
}

constexpr std::int32_t kVertex = 1;  ///< type of a cell that is a point

/// Legacy VTK, whose binary numbers have the most significant byte first.
std::string vtk(const std::vector<ParticleSample>& particles, double time_s) {
  const std::string count = std::to_string(particles.size());
  std::string bytes = "# vtk DataFile Version 3.0\nice_ice_baby at " + numberText(time_s) +
                      " s\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS " + count + " float\n";
  for (const ParticleSample& p : particles) {
    for (const float value : {p.x, p.y, p.z}) append(bytes, value, true);
  }
  bytes += "\nCELLS " + count + " " + std::to_string(2 * particles.size()) + "\n";
  for (std::size_t i = 0; i < particles.size(); ++i) {
    append(bytes, std::int32_t(1), true);
    append(bytes, std::int32_t(i), true);
  }
  bytes += "\nCELL_TYPES " + count + "\n";
  for (std::size_t i = 0; i < particles.size(); ++i) append(bytes, kVertex, true);
  bytes += "\nPOINT_DATA " + count + "\nVECTORS velocity float\n";
  for (const ParticleSample& p : particles) {
    for (const float value : {p.vx, p.vy, p.vz}) append(bytes, value, true);
  }
  std::size_t column = 0;
  forEachValue({}, [&](const char* name, auto kind) {
    bytes += std::string("\nSCALARS ") + name + " " + typeName(kind) + " 1\nLOOKUP_TABLE default\n";
    for (const ParticleSample& p : particles) {
      std::size_t at = 0;
      forEachValue(p, [&](const char*, auto value) {
        if (at++ == column) append(bytes, value, true);
      });
    }
    ++column;
  });
  return bytes + "\n";
}

}  // namespace

ParticleWriter::ParticleWriter(const std::string& folder, const std::string& format)
    : ply_(requireFormat(format) == "ply"), files_(folder, "particles", format) {}

void ParticleWriter::write(const Simulation& simulation) {
  simulation.sample(particles_);
  const double time_s = simulation.report().time_s;
  const std::string path = files_.next(time_s);
  writeFile(path, ply_ ? ply(particles_) : vtk(particles_, time_s));
}

}  // namespace ice_ice_baby
