#include "cloud_samples.h"

#include <string>

#include "field_reader.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

using sensor_msgs::PointField;

template <class Value>
FieldReader<Value> readerOf(const sensor_msgs::PointCloud2& cloud, const char* name,
                            std::uint8_t type) {
  const FieldReader<Value> reader(cloud, name, type);
  if (!reader.found()) {
    throw InvalidInput(std::string("the point cloud has no field ") + name +
                       "; expected is the topic ~particles of a simulation");
  }
  return reader;
}

/// Reads the fields that a surface needs.
class SampleReader {
 public:
  explicit SampleReader(const sensor_msgs::PointCloud2& cloud)
      : x_(number(cloud, "x")),
        y_(number(cloud, "y")),
        z_(number(cloud, "z")),
        vx_(number(cloud, "vx")),
        vy_(number(cloud, "vy")),
        vz_(number(cloud, "vz")),
        temperature_(number(cloud, "temperature")),
        ice_fraction_(number(cloud, "ice_fraction")),
        phase_(readerOf<std::uint8_t>(cloud, "phase", PointField::UINT8)) {}

  ParticleSample read(const std::uint8_t* point) const {
    ParticleSample sample{};
    sample.x = x_.read(point, 0.0f);
    sample.y = y_.read(point, 0.0f);
    sample.z = z_.read(point, 0.0f);
    sample.vx = vx_.read(point, 0.0f);
    sample.vy = vy_.read(point, 0.0f);
    sample.vz = vz_.read(point, 0.0f);
    sample.temperature_c = temperature_.read(point, 0.0f);
    sample.ice_fraction = ice_fraction_.read(point, 0.0f);
    const unsigned phase = phase_.read(point, 0);
    if (phase >= std::size(kPhases)) {
      throw InvalidInput("the point cloud holds phase " + std::to_string(phase) +
                         "; known are 0 (water), 1 (ice), 2 (steam) and 3 (solid)");
    }
    sample.phase = kPhases[phase];
    return sample;
  }

 private:
  static FieldReader<float> number(const sensor_msgs::PointCloud2& cloud, const char* name) {
    return readerOf<float>(cloud, name, PointField::FLOAT32);
  }

  const FieldReader<float> x_, y_, z_, vx_, vy_, vz_, temperature_, ice_fraction_;
  const FieldReader<std::uint8_t> phase_;
};

}  // namespace

std::vector<ParticleSample> readSamples(const sensor_msgs::PointCloud2& cloud) {
  const SampleReader reader(cloud);
  const std::size_t count = std::size_t{cloud.width} * cloud.height;
  if (count > cloud.data.size() / cloud.point_step) {
    throw InvalidInput("the point cloud says " + std::to_string(count) + " points and holds fewer");
  }
  std::vector<ParticleSample> samples;
  samples.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    samples.push_back(reader.read(cloud.data.data() + k * cloud.point_step));
  }
  return samples;
}

}  // namespace ice_ice_baby
