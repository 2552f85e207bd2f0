// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <geometry_msgs/Transform.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <string>

#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/camera/image.hpp"

namespace slam_ros {

/// A copy in 8 bit grey, from the encodings mono, rgb, bgr, rgba, bgra, bayer (8 and 16 bit) and
/// yuv422; of 16 bits the upper 8 are kept. An image that cannot be used is returned without pixels
/// and with a fault: 16UC1 and 32FC1, which do not say what their values mean, and data that do not
/// fit the size.
slam::Image fromMsg(const sensor_msgs::Image& message);

/// The same from a JPEG or PNG. One that is cut off or no picture is returned without pixels and
/// with a fault.
slam::Image fromMsg(const sensor_msgs::CompressedImage& message);

/// For the image as the camera delivers it: with the region of interest and the binning of the
/// message applied.
slam::CameraCalibration fromMsg(const sensor_msgs::CameraInfo& message);

/// The rotation of a quaternion that is zero or not a number is NaN.
Eigen::Isometry3d fromMsg(const geometry_msgs::Transform& transform);

/// bgr8
sensor_msgs::Image toMsg(const cv::Mat& colour, const std_msgs::Header& header);

}  // namespace slam_ros
