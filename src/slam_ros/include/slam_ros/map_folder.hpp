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

/// The folder in which services save and load files: whoever reaches the ROS master can call them,
/// so that a path must not lead out of it.
class MapFolder {
 public:
  explicit MapFolder(const FilesConfig& config = {});

  /// The absolute path that a request names; a relative one begins in the folder. Links are
  /// followed.
  /// @throw std::runtime_error where it leads out of the folder, or is neither file nor folder
  std::string resolve(const std::string& requested) const;
  /// The same of a map: a name without an ending, as `office`, stands for `office.yaml`, unless a
  /// file or folder has that very name.
  std::string resolveMap(const std::string& requested) const;
  /// The same of what is to be written: the folder is made where it does not exist yet.
  std::string resolveForWriting(const std::string& requested) const;
  std::string resolveMapForWriting(const std::string& requested) const;

 private:
  std::string made(const std::string& path) const;

  std::filesystem::path folder_;
  bool may_leave_;
};

}  // namespace slam_ros
