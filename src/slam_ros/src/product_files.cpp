// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/product_files.hpp"

#include <fmt/format.h>
#include <ros/package.h>

#include <algorithm>
#include <filesystem>

#include "slam_core/common/nearest_name.hpp"

namespace slam_ros {
namespace {

namespace fs = std::filesystem;

bool isPath(const std::string& text) {
  return text.find('/') != std::string::npos || fs::path(text).extension() == ".yaml";
}

std::vector<std::string> namesIn(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

std::string fileOf(const std::string& subfolder, const std::string& kind, const std::string& name) {
  if (isPath(name)) return name;
  const auto package = ros::package::getPath("slam_launch");
  if (package.empty())
    throw UnknownName("the package slam_launch, which holds the " + kind + " '" + name +
                      "', is not in ROS_PACKAGE_PATH; source the workspace's setup.bash or give a "
                      "file");
  return findConfigFile(package + "/" + subfolder, kind, name);
}

}  // namespace

std::string productFile(const std::string& name_or_path) {
  return fileOf("products", "product", name_or_path);
}

std::string robotFile(const std::string& name_or_path) {
  return fileOf("robots", "robot", name_or_path);
}

std::string findConfigFile(const std::string& folder, const std::string& kind,
                           const std::string& name_or_path) {
  if (isPath(name_or_path)) return name_or_path;
  const auto names = namesIn(folder);
  if (std::find(names.begin(), names.end(), name_or_path) != names.end())
    return folder + "/" + name_or_path + ".yaml";
  throw UnknownName(fmt::format("there is no {} '{}'{}; there are: {}", kind, name_or_path,
                                slam::didYouMean(name_or_path, names), slam::join(names)));
}

}  // namespace slam_ros
