// Reads point clouds whoever wrote them.
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <cstdint>
#include <cstring>

namespace ice_ice_baby {

/// Reads one field of points; one that the cloud lacks has always the same value.
template <typename Value>
class FieldReader {
 public:
  FieldReader(const sensor_msgs::PointCloud2& cloud, const char* name, std::uint8_t datatype) {
    for (const sensor_msgs::PointField& field : cloud.fields) {
      const bool inside = field.offset + std::uint64_t{sizeof(Value)} <= cloud.point_step;
      if (field.name == name && field.datatype == datatype && inside) {
        offset_ = static_cast<int>(field.offset);
      }
    }
  }

  bool found() const { return offset_ >= 0; }

  Value read(const std::uint8_t* point, Value otherwise) const {
    if (found()) std::memcpy(&otherwise, point + offset_, sizeof otherwise);
    return otherwise;
  }

 private:
  int offset_ = -1;
};

}  // namespace ice_ice_baby
