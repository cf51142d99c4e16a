#include "particle_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace ice_ice_baby {

namespace {

using sensor_msgs::PointField;

// A point begins with the bytes of a sample, so that points are copied, not converted.
static_assert(sizeof(ParticleSample) == 44 && offsetof(ParticleSample, vx) == 12 &&
                  offsetof(ParticleSample, temperature_c) == 24 &&
                  offsetof(ParticleSample, ice_fraction) == 28 &&
                  offsetof(ParticleSample, density) == 32 &&
                  offsetof(ParticleSample, pressure_pa) == 36 && offsetof(ParticleSample, id) == 40,
              "the fields below name other bytes than ParticleSample holds");

PointField field(const char* name, std::uint32_t offset, std::uint8_t type) {
  PointField out;
  out.name = name;
  out.offset = offset;
  out.datatype = type;
  out.count = 1;
  return out;
}

std::vector<PointField> fields(bool rgb) {
  std::vector<PointField> out;
  std::uint32_t offset = 0;
  for (const char* name :
       {"x", "y", "z", "vx", "vy", "vz", "temperature", "ice_fraction", "density", "pressure"}) {
    out.push_back(field(name, offset, PointField::FLOAT32));
    offset += 4;
  }
  out.push_back(field("id", offset, PointField::UINT32));
  if (rgb) out.push_back(field("rgb", offset + 4, PointField::FLOAT32));
  return out;
}

bool bigEndian() {
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

}  // namespace

std::uint32_t particleColour(float ice_fraction) {
  constexpr float kWater[3] = {0.13f, 0.46f, 0.86f};  // red, green, blue
  constexpr float kIce[3] = {0.90f, 0.96f, 1.0f};
  const float ice = std::min(std::max(ice_fraction, 0.0f), 1.0f);
  std::uint32_t colour = 0;
  for (int part = 0; part < 3; ++part) {
    const float mixed = kWater[part] + ice * (kIce[part] - kWater[part]);
    colour = colour << 8 | static_cast<std::uint32_t>(std::lround(255.0f * mixed));
  }
  return colour;
}

void writeCloud(const std::vector<ParticleSample>& samples, bool rgb,
                sensor_msgs::PointCloud2& cloud) {
  const std::size_t step = sizeof(ParticleSample) + (rgb ? sizeof(std::uint32_t) : 0);
  cloud.fields = fields(rgb);
  cloud.is_bigendian = bigEndian();
  cloud.is_dense = true;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(samples.size());
  cloud.point_step = static_cast<std::uint32_t>(step);
  cloud.row_step = static_cast<std::uint32_t>(step * samples.size());
  cloud.data.resize(step * samples.size());
  if (samples.empty()) return;
  if (!rgb) {
    std::memcpy(cloud.data.data(), samples.data(), cloud.data.size());
    return;
  }
  std::uint8_t* point = cloud.data.data();
  float coloured = samples.front().ice_fraction;
  std::uint32_t colour = particleColour(coloured);
  for (const ParticleSample& sample : samples) {
    if (sample.ice_fraction != coloured) {
      coloured = sample.ice_fraction;
      colour = particleColour(coloured);
    }
    std::memcpy(point, &sample, sizeof(sample));
    std::memcpy(point + sizeof(sample), &colour, sizeof(colour));
    point += step;
  }
}

}  // namespace ice_ice_baby
