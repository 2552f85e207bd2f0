// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "slam_core/common/config_fields.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/contract/map_kind.hpp"

namespace slam {

/// The top level of a product file and of a robot file: who they are and which components play
/// which role.
struct ProductConfig {
  static constexpr const char* kSection = "";

  std::string product;
  std::string sentence;
  std::vector<std::string> libraries;
  std::string backend = "ekf";
  std::string odometry = "wheel";
  std::string detector = "none";
  std::string second_detector = "none";
  bool second_camera = false;  ///< the detectors look through a second camera as well
  bool rear_laser = false;     ///< a second laser's scans go into the map as well
  std::string association = "known_ids";
  MapKind map = MapKind::kLandmarks;
  std::map<std::string, bool> modules;  ///< whether it has the additional module of a name
  std::uint64_t seed = 1;
  double source_timeout = 1.0;
  std::string robot;

  void describe(Fields& fields);
};

/// The robot's frames (REP-105).
struct FramesConfig {
  static constexpr const char* kSection = "frames";

  std::string map = "map";
  std::string odom = "odom";
  std::string base = "base_link";
  double jump_limit = 0.0;
  double jump_limit_heading = 0.2;

  void describe(Fields& fields);
  /// @throw ConfigError when a name is empty, begins with a slash, or stands for two frames
  void requireDistinctNames() const;
  /// Gives names to those frames of odometry data that have none.
  void complete(std::string& odometry_frame, std::string& base_frame) const;
};

/// Reads the product's top level. The libraries that it names are loaded before, since their
/// components add keys to it: an additional module its name. Where it throws, the faultless fields
/// have their values. @throw ConfigError
void readProduct(Settings& settings, ProductConfig& product);

/// Loads the shared libraries a product names; their components register themselves. The built-in
/// ones come with the library of this function. @throw ConfigError naming the library and the
/// loader's reason
void loadLibraries(const std::vector<std::string>& libraries);

}  // namespace slam
