#include "phase_points.h"

#include <cstdint>
#include <stdexcept>
#include <string>

#include "field_reader.h"
#include "particle_colour.h"

namespace ice_ice_baby {
namespace {

using sensor_msgs::PointField;

constexpr std::uint32_t kWaterBlue = 0x2175DB;

class CloudReader {
 public:
  explicit CloudReader(const sensor_msgs::PointCloud2& cloud)
      : cloud_(cloud),
        x_(cloud, "x", PointField::FLOAT32),
        y_(cloud, "y", PointField::FLOAT32),
        z_(cloud, "z", PointField::FLOAT32),
        ice_(cloud, "ice_fraction", PointField::FLOAT32),
        phase_(cloud, "phase", PointField::UINT8),
        rgb_(cloud, "rgb", PointField::FLOAT32) {
    if (!x_.found() || !y_.found() || !z_.found()) {
      throw std::invalid_argument("The cloud has no fields x, y, z of FLOAT32");
    }
    if (cloud.data.size() < count() * cloud.point_step) {
      throw std::invalid_argument("The cloud says " + std::to_string(count()) +
                                  " points and holds fewer");
    }
  }

  std::size_t count() const { return std::size_t{cloud_.width} * cloud_.height; }
  float ice(std::size_t k) const { return ice_.read(at(k), 0.0F); }
  bool hasPhases() const { return phase_.found(); }

  Phase phase(std::size_t k) const {
    const std::uint8_t number = phase_.read(at(k), 0);
    for (const Phase phase : kPhases) {
      if (indexOf(phase) == number) return phase;
    }
    throw std::invalid_argument("The cloud holds phase " + std::to_string(number) +
                                "; known are 0 (water), 1 (ice), 2 (steam) and 3 (solid)");
  }

  rviz::PointCloud::Point point(std::size_t k) const {
    rviz::PointCloud::Point point;
    point.position.x = x_.read(at(k), 0.0F);
    point.position.y = y_.read(at(k), 0.0F);
    point.position.z = z_.read(at(k), 0.0F);
    const Colour colour = unpacked(rgb_.read(at(k), kWaterBlue));
    point.setColor(colour.red, colour.green, colour.blue);
    return point;
  }

 private:
  const std::uint8_t* at(std::size_t k) const { return cloud_.data.data() + k * cloud_.point_step; }

  const sensor_msgs::PointCloud2& cloud_;
  const FieldReader<float> x_, y_, z_, ice_;
  const FieldReader<std::uint8_t> phase_;
  const FieldReader<std::uint32_t> rgb_;
};

/// Ice fraction that all water has in common; otherwise 0.
float commonFraction(const CloudReader& cloud) {
  float common = 0.0F;
  bool first = true;
  for (std::size_t k = 0; k < cloud.count(); ++k) {
    if (cloud.phase(k) != Phase::kWater) continue;
    if (!first && cloud.ice(k) != common) return 0.0F;
    common = cloud.ice(k);
    first = false;
  }
  return common;
}

}  // namespace

void splitPhases(const sensor_msgs::PointCloud2& cloud, PhasePoints& out) {
  const CloudReader reader(cloud);
  for (auto& points : out.of) points.clear();
  out.has_phases = reader.hasPhases();
  out.freezing = commonFraction(reader);
  for (std::size_t k = 0; k < reader.count(); ++k) {
    out.of[indexOf(reader.phase(k))].push_back(reader.point(k));
  }
}

}  // namespace ice_ice_baby
