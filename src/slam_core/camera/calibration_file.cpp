// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/calibration_file.hpp"

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/settings.hpp"

namespace slam {
namespace {

template <class Value>
Value valueOf(const ConfigDocument& file, const YAML::Node& node, const std::string& key) {
  Value value;
  try {
    if (node && YAML::convert<Value>::decode(node, value)) return value;
  } catch (const YAML::Exception&) {  // of an entry of a list
  }
  throw ConfigError(file.name + ": " + key + " is missing or not of the right type");
}

}  // namespace

CameraCalibration loadCalibrationFile(const std::string& path) {
  const auto file = loadConfigFile(path);
  const YAML::Node& root = file.root;
  if (!root.IsMap()) throw ConfigError(path + " is not a map of keys and values");
  const auto listOf = [&](const std::string& key) {
    const YAML::Node node = root[key];
    return valueOf<std::vector<double>>(file, node && node.IsMap() ? node["data"] : YAML::Node(),
                                        key + "/data");
  };
  CameraCalibration calibration;
  calibration.width = valueOf<int>(file, root["image_width"], "image_width");
  calibration.height = valueOf<int>(file, root["image_height"], "image_height");
  calibration.distortion_model =
      valueOf<std::string>(file, root["distortion_model"], "distortion_model");
  calibration.distortion = listOf("distortion_coefficients");
  const auto K = listOf("camera_matrix");
  if (K.size() != 9)
    throw ConfigError(path + ": camera_matrix/data has " + std::to_string(K.size()) +
                      " numbers instead of 9");
  calibration.fx = K[0];
  calibration.cx = K[2];
  calibration.fy = K[4];
  calibration.cy = K[5];
  if (const auto fault = faultOf(calibration); !fault.empty())
    throw ConfigError(path + ": the camera's calibration cannot be used: " + fault);
  return calibration;
}

}  // namespace slam
