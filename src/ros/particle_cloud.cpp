#include "particle_cloud.h"

#include <cstddef>
#include <cstring>

#include "byte_order.h"
#include "particle_colour.h"

namespace ice_ice_baby {

namespace {

using sensor_msgs::PointField;

// A point begins with the bytes of a sample, so that points are copied, not converted.
static_assert(sizeof(ParticleSample) == 48 && offsetof(ParticleSample, vx) == 12 &&
                  offsetof(ParticleSample, temperature_c) == 24 &&
                  offsetof(ParticleSample, ice_fraction) == 28 &&
                  offsetof(ParticleSample, density) == 32 &&
                  offsetof(ParticleSample, pressure_pa) == 36 &&
                  offsetof(ParticleSample, id) == 40 && offsetof(ParticleSample, phase) == 44,
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
  out.push_back(field("id", offsetof(ParticleSample, id), PointField::UINT32));
  out.push_back(field("phase", offsetof(ParticleSample, phase), PointField::UINT8));
  if (rgb) out.push_back(field("rgb", sizeof(ParticleSample), PointField::FLOAT32));
  return out;
}

/// Points of sample and colour, one after the other.
template <class Colour>
void writePoints(const std::vector<ParticleSample>& samples, Colour colourOf, std::uint8_t* point) {
  for (const ParticleSample& sample : samples) {
    const std::uint32_t colour = colourOf(sample);
    std::memcpy(point, &sample, sizeof(sample));
    std::memcpy(point + sizeof(sample), &colour, sizeof(colour));
    point += sizeof(sample) + sizeof(colour);
  }
}

/// particleColour of a sample; without heat all water has the same.
class SceneColour {
 public:
  std::uint32_t operator()(const ParticleSample& sample) {
    if (sample.phase == Phase::kSolid) return solid_;
    if (sample.ice_fraction != ice_fraction_) {
      ice_fraction_ = sample.ice_fraction;
      colour_ = particleColour(ice_fraction_);
    }
    return colour_;
  }

 private:
  float ice_fraction_ = 0.0f;
  std::uint32_t colour_ = particleColour(0.0f);
  const std::uint32_t solid_ = solidColour();
};

}  // namespace

void writeCloud(const std::vector<ParticleSample>& samples, Colouring colouring,
                sensor_msgs::PointCloud2& cloud) {
  const bool rgb = colouring != Colouring::kPlain;
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
  switch (colouring) {
    case Colouring::kPlain:
      std::memcpy(cloud.data.data(), samples.data(), cloud.data.size());
      break;
    case Colouring::kScene:
      writePoints(samples, SceneColour(), cloud.data.data());
      break;
    case Colouring::kHeat:
      writePoints(samples, heatColour, cloud.data.data());
      break;
  }
}

}  // namespace ice_ice_baby
