#include "camera_message.h"

#include <sensor_msgs/distortion_models.h>
#include <sensor_msgs/image_encodings.h>

#include <cstring>

#include "byte_order.h"

namespace ice_ice_baby {

namespace {

template <class Value>
sensor_msgs::Image imageOf(const std::vector<Value>& values, const CameraPicture& picture,
                           const std::string& encoding, const std_msgs::Header& header) {
  sensor_msgs::Image image;
  image.header = header;
  image.width = static_cast<std::uint32_t>(picture.width);
  image.height = static_cast<std::uint32_t>(picture.height);
  image.encoding = encoding;
  image.is_bigendian = bigEndian();
  image.step = static_cast<std::uint32_t>(image.width * sizeof(Value));
  image.data.resize(values.size() * sizeof(Value));
  if (!values.empty()) std::memcpy(image.data.data(), values.data(), image.data.size());
  return image;
}

}  // namespace

sensor_msgs::Image depthMessage(const CameraPicture& picture, const std_msgs::Header& header) {
  return imageOf(picture.depth_m, picture, sensor_msgs::image_encodings::TYPE_32FC1, header);
}

sensor_msgs::Image labelMessage(const CameraPicture& picture, const std_msgs::Header& header) {
  const std::vector<std::uint16_t> labels = [&] {
    std::vector<std::uint16_t> numbers;
    numbers.reserve(picture.seen.size());
    for (const Seen seen : picture.seen) numbers.push_back(static_cast<std::uint16_t>(seen));
    return numbers;
  }();
  return imageOf(labels, picture, sensor_msgs::image_encodings::TYPE_16UC1, header);
}

sensor_msgs::CameraInfo cameraInfo(const Camera& camera, const std_msgs::Header& header) {
  sensor_msgs::CameraInfo info;
  info.header = header;
  info.width = static_cast<std::uint32_t>(camera.width);
  info.height = static_cast<std::uint32_t>(camera.height);
  info.distortion_model = sensor_msgs::distortion_models::PLUMB_BOB;
  info.D.assign(5, 0.0);
  const double f = camera.focalLength();
  // The middle of the picture, counted from the middle of the first pixel.
  const double x = 0.5 * camera.width - 0.5, y = 0.5 * camera.height - 0.5;
  info.K = {f, 0, x, 0, f, y, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {f, 0, x, 0, 0, f, y, 0, 0, 0, 1, 0};
  return info;
}

}  // namespace ice_ice_baby
