// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/map_folder.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "slam_core/contract/known_sections.hpp"

namespace slam_ros {
namespace {

namespace fs = std::filesystem;

const slam::SectionRegistrar<FilesConfig> kFilesSection;

std::string environmentOr(const char* variable, const std::string& otherwise) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0' ? value : otherwise;
}

/// ROS_HOME, by default .ros in the home folder.
fs::path rosHome() { return environmentOr("ROS_HOME", environmentOr("HOME", "/tmp") + "/.ros"); }

bool isBelow(const fs::path& path, const fs::path& folder) {
  const auto [end_of_folder, rest] =
      std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end_of_folder == folder.end();
}

}  // namespace

MapFolder::MapFolder(const FilesConfig& config)
    : folder_(config.map_folder.empty() ? rosHome() / "slam_maps" : fs::path(config.map_folder)),
      may_leave_(config.unsafe_paths) {
  // without the separator at the end, which would count as an empty name
  folder_ = fs::weakly_canonical(fs::absolute(folder_ / "x")).parent_path();
}

std::string MapFolder::resolve(const std::string& requested) const {
  if (requested.empty()) throw std::runtime_error("the request names no file; fill in its path");
  const auto path = fs::weakly_canonical(folder_ / requested);
  if (!may_leave_ && !isBelow(path, folder_))
    throw std::runtime_error(
        requested + " is not below " + folder_.string() +
        ", where maps are kept: name a path there (a relative one begins there), or start with "
        "map_folder:=FOLDER, or with unsafe_paths:=true");
  const auto type = fs::status(path).type();
  if (!may_leave_ && fs::exists(path) && type != fs::file_type::regular &&
      type != fs::file_type::directory)
    throw std::runtime_error(requested + " is a device or a pipe: name a file or a folder");
  return path.string();
}

std::string MapFolder::resolveMap(const std::string& requested) const {
  const fs::path path = resolve(requested);
  const bool is_folder = requested.back() == '/' || fs::is_directory(path);
  if (is_folder || path.has_extension() || fs::exists(path)) return path.string();
  return resolve(requested + ".yaml");
}

std::string MapFolder::resolveForWriting(const std::string& requested) const {
  return made(resolve(requested));
}

std::string MapFolder::resolveMapForWriting(const std::string& requested) const {
  return made(resolveMap(requested));
}

std::string MapFolder::made(const std::string& path) const {
  if (isBelow(path, folder_)) fs::create_directories(folder_);
  return path;
}

}  // namespace slam_ros
