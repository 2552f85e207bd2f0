// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/product_files.hpp"

#include <fmt/format.h>
#include <ros/package.h>

#include <cstdlib>
#include <filesystem>
#include <utility>

#include "slam_core/common/nearest_name.hpp"
#include "slam_core/common/sorted_unique.hpp"

namespace slam_ros {
namespace {

namespace fs = std::filesystem;

bool isPath(const std::string& text) {
  return text.find('/') != std::string::npos || fs::path(text).extension() == ".yaml";
}

void addNamesIn(const std::string& folder, std::vector<std::string>& names) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem());
}

std::string launchPackage(const std::string& kind, const std::string& name) {
  auto package = ros::package::getPath("slam_launch");
  if (!package.empty()) return package;
  throw UnknownName("the package slam_launch, which holds the " + kind + " '" + name +
                    "', is not in ROS_PACKAGE_PATH; source the workspace's setup.bash or give a "
                    "file");
}

/// As slam_launch's config_files.py has it, which writes there.
std::string userProducts() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && *config != '\0') return std::string(config) + "/slam/products";
  const char* home = std::getenv("HOME");
  return std::string(home != nullptr ? home : "") + "/.config/slam/products";
}

}  // namespace

std::string productFile(const std::string& name_or_path) {
  if (isPath(name_or_path)) return name_or_path;
  std::vector<std::string> folders = {launchPackage("product", name_or_path) + "/products"};
  ros::package::getPlugins("slam_launch", "products", folders, true);
  folders.push_back(userProducts());
  return findConfigFile(folders, "product", name_or_path);
}

std::string robotFile(const std::string& name_or_path) {
  if (isPath(name_or_path)) return name_or_path;
  return findConfigFile(launchPackage("robot", name_or_path) + "/robots", "robot", name_or_path);
}

std::string findConfigFile(const std::string& folder, const std::string& kind,
                           const std::string& name_or_path) {
  return findConfigFile(std::vector<std::string>{folder}, kind, name_or_path);
}

std::string findConfigFile(const std::vector<std::string>& folders, const std::string& kind,
                           const std::string& name_or_path) {
  if (isPath(name_or_path)) return name_or_path;
  std::vector<std::string> names;
  for (const auto& folder : folders) {
    const auto file = folder + "/" + name_or_path + ".yaml";
    if (fs::exists(file)) return file;
    addNamesIn(folder, names);
  }
  names = slam::sortedUnique(std::move(names));
  throw UnknownName(fmt::format("there is no {} '{}'{}; there are: {}", kind, name_or_path,
                                slam::didYouMean(name_or_path, names), slam::join(names)));
}

}  // namespace slam_ros
