// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

#include "slam_core/common/config_fields.hpp"

namespace slam_ros {

struct FilesConfig {
  static constexpr const char* kSection = "files";

  std::string map_folder;
  bool unsafe_paths = false;

  void describe(slam::Fields& fields) {
    fields
        .add("map_folder", &map_folder,
             "the services save and load maps and sessions below this folder only, and relative "
             "paths begin there; default: slam_maps in ROS_HOME")
        .ofRobot();
    fields
        .add("unsafe_paths", &unsafe_paths,
             "whoever calls a service may name any path that this process can write or read")
        .ofRobot();
  }
};

/// The folder in which services save and load files. Whoever reaches the ROS master can call these
/// services, so that a path must not lead out of the folder.
class MapFolder {
 public:
  explicit MapFolder(const FilesConfig& config = {});

  /// The absolute path for a request's path. A relative path begins in the folder; links are
  /// followed.
  /// @throw std::runtime_error if it leads out of the folder, or is neither file nor folder
  std::string resolve(const std::string& requested) const;
  /// The same for a map. A name without an extension, such as `office`, means `office.yaml`, unless
  /// a file or folder has exactly that name.
  std::string resolveMap(const std::string& requested) const;
  /// The same for a file to be written. The folder is made if it does not exist yet.
  std::string resolveForWriting(const std::string& requested) const;
  std::string resolveMapForWriting(const std::string& requested) const;

 private:
  std::string made(const std::string& path) const;

  std::filesystem::path folder_;
  bool may_leave_;
};

}  // namespace slam_ros
