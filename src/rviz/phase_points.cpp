#include "phase_points.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace ice_ice_baby {
namespace {

using sensor_msgs::PointField;

constexpr float STEAM_DENSITY = 0.01F;
constexpr float HALF_ICE = 0.5F;
constexpr std::uint32_t WATER_BLUE = 0x2175DB;

/// Reads one field of points; one that the cloud lacks has always the same value.
class FieldReader {
 public:
  FieldReader(const sensor_msgs::PointCloud2& cloud, const char* name) {
    for (const PointField& field : cloud.fields) {
      const bool inside = field.offset + std::uint64_t{4} <= cloud.point_step;
      if (field.name == name && field.datatype == PointField::FLOAT32 && inside) {
        offset_ = static_cast<int>(field.offset);
      }
    }
  }

  bool found() const { return offset_ >= 0; }

  template <typename Value>
  Value read(const std::uint8_t* point, Value otherwise) const {
    if (found()) std::memcpy(&otherwise, point + offset_, sizeof otherwise);
    return otherwise;
  }

 private:
  int offset_ = -1;
};

class CloudReader {
 public:
  explicit CloudReader(const sensor_msgs::PointCloud2& cloud)
      : cloud_(cloud),
        x_(cloud, "x"),
        y_(cloud, "y"),
        z_(cloud, "z"),
        ice_(cloud, "ice_fraction"),
        density_(cloud, "density"),
        rgb_(cloud, "rgb") {
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
  bool steam(std::size_t k) const { return density_.read(at(k), 1.0F) < STEAM_DENSITY; }

  rviz::PointCloud::Point point(std::size_t k) const {
    rviz::PointCloud::Point point;
    point.position.x = x_.read(at(k), 0.0F);
    point.position.y = y_.read(at(k), 0.0F);
    point.position.z = z_.read(at(k), 0.0F);
    const auto colour = rgb_.read(at(k), WATER_BLUE);
    const auto part = [&](int shift) {
      return static_cast<float>(colour >> shift & 255U) / 255.0F;
    };
    point.setColor(part(16), part(8), part(0));
    return point;
  }

 private:
  const std::uint8_t* at(std::size_t k) const { return cloud_.data.data() + k * cloud_.point_step; }

  const sensor_msgs::PointCloud2& cloud_;
  const FieldReader x_, y_, z_, ice_, density_, rgb_;
};

/// Whether all water and ice has the same share of ice, which is then left in `share`.
bool sameIce(const CloudReader& cloud, float& share) {
  bool first = true;
  for (std::size_t k = 0; k < cloud.count(); ++k) {
    if (cloud.steam(k)) continue;
    if (!first && cloud.ice(k) != share) return false;
    share = cloud.ice(k);
    first = false;
  }
  return true;
}

}  // namespace

void splitPhases(const sensor_msgs::PointCloud2& cloud, PhasePoints& out) {
  const CloudReader reader(cloud);
  for (auto& points : out.of) points.clear();
  float share = 0.0F;
  const bool same = sameIce(reader, share);
  out.freezing = same ? share : 0.0F;
  for (std::size_t k = 0; k < reader.count(); ++k) {
    const bool ice = !same && reader.ice(k) >= HALF_ICE;
    const Phase phase = reader.steam(k) ? STEAM : ice ? ICE : WATER;
    out.of[phase].push_back(reader.point(k));
  }
}

}  // namespace ice_ice_baby
