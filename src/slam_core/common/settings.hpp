// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <yaml-cpp/yaml.h>

#include <set>
#include <string>
#include <vector>

#include "slam_core/common/config_fields.hpp"

namespace slam {

/// A parsed product or robot file, or the ROS parameters that stand for it.
struct ConfigDocument {
  std::string name;  ///< for error messages: the file, or the parameter name
  YAML::Node root;   ///< a map, or null
};

/// @throw ConfigError when the file is missing or is not YAML (with line and column)
ConfigDocument loadConfigFile(const std::string& path);

/// The configuration of one run: a product file, a robot file and "section.key=value" overrides.
/// A component reads its own section of it with read(). Where the same field is given twice the
/// override counts.
class Settings {
 public:
  static constexpr int kVersion = 1;

  Settings() = default;
  /// @throw ConfigError on another version, a malformed override, or a file that is not a map
  Settings(ConfigDocument product, ConfigDocument robot, std::vector<std::string> overrides);

  /// The section Config::kSection ("" is the top level) as a struct; fields not given keep the
  /// defaults of the struct.
  /// @throw ConfigError listing unknown keys (with the nearest name), wrong types, values out of
  /// range and fields in the wrong file
  template <class Config>
  Config read() {
    Config config;
    read(config);
    return config;
  }
  /// The same; where it throws, the faultless fields have their values.
  template <class Config>
  void read(Config& config) {
    Fields fields;
    config.describe(fields);
    readSection(Config::kSection, fields);
  }

  /// Checks the section of a component that this product does not use, which may stand in the files
  /// all the same (a robot has a camera, the product looks at no image). Does nothing where the
  /// section has been read. @throw ConfigError as read()
  template <class Config>
  void checkUnused() {
    Config config;
    Fields fields;
    config.describe(fields);
    checkUnusedSection(Config::kSection, fields);
  }

  /// Sections that nobody has read or checked, with the place where they stand: leftovers or typos;
  /// overrides of sections that nobody has read.
  /// @throw ConfigError when there are any
  void requireAllRead() const;

  /// The values in force of all sections read so far, as YAML.
  std::string inForce() const;

 private:
  struct Override {
    std::string section, key, text;
  };

  void readSection(const std::string& section, const Fields& fields);
  void checkUnusedSection(const std::string& section, const Fields& fields);
  void applyDocument(const ConfigDocument& document, Scope scope, const std::string& section,
                     const Fields& fields, std::vector<std::string>& faults) const;
  void applyOverrides(const std::string& section, const Fields& fields,
                      std::vector<std::string>& faults) const;

  ConfigDocument product_, robot_;
  std::vector<Override> overrides_;
  std::set<std::string> read_, unused_;
  std::vector<std::pair<std::string, std::string>> in_force_;  // section, its YAML text
};

}  // namespace slam
