// Messages of a camera.
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include "ice_ice_baby/camera_params.h"
#include "ray_scene.h"

namespace ice_ice_baby {

/// Depth along the optical axis in metres, 32FC1, NaN where nothing is seen.
sensor_msgs::Image depthMessage(const CameraPicture& picture, const std_msgs::Header& header);

/// What each pixel shows, 16UC1: 0 nothing, 1 water, 2 ice, 3 solid.
sensor_msgs::Image labelMessage(const CameraPicture& picture, const std_msgs::Header& header);

/// Intrinsic parameters; no distortion.
sensor_msgs::CameraInfo cameraInfo(const Camera& camera, const std_msgs::Header& header);

}  // namespace ice_ice_baby
