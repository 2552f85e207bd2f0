// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/config_fields.hpp"

namespace slam::sim {

inline const Range kPositive = Range::above(0.0);

/// One map of keys and values in a YAML file, read key by key. What is wrong goes to the collector,
/// with file and line; a value that is wrong leaves its target as it was. finish() comes last and
/// names the keys that nobody asked for.
class YamlMap {
 public:
  YamlMap(std::string file, std::string name, const YAML::Node& node, FaultCollector& faults);

  /// For T a number, a text, Vector2d, Vector3d, or a vector of numbers or of Vector2d. The range
  /// is that of each number.
  template <class T>
  void read(const std::string& key, T& target, const Range& range = {}) {
    const auto node = find(key);
    if (!node) return;
    if (!decode(node, target, key)) return;
    checkRange(node, key, numbersOf(target), range);
  }
  /// The same; a missing key is a fault.
  template <class T>
  void require(const std::string& key, T& target, const Range& range = {}) {
    read(key, target, range);  // also of a missing one, so that finish() knows the key
    if (!has(key)) fault("has no '" + key + "'");
  }
  void read(const std::string& key, std::string& target, const std::vector<std::string>& choices);

  bool has(const std::string& key) const { return node_.IsMap() && node_[key].IsDefined(); }
  /// The maps of a list; none where the key is not there.
  std::vector<YamlMap> list(const std::string& key);
  /// An empty map where the key is not there.
  YamlMap map(const std::string& key);

  std::string where() const;  ///< "FILE:LINE: NAME", of the whole file "FILE:LINE:"
  void fault(const std::string& sentence) { faults_->add(where() + " " + sentence); }
  void finish();

 private:
  YAML::Node find(const std::string& key);
  std::string at(const YAML::Node& node, const std::string& key) const;
  void wrongType(const YAML::Node& node, const std::string& key, const std::string& type);
  void checkRange(const YAML::Node& node, const std::string& key, const std::vector<double>& values,
                  const Range& range);

  bool decode(const YAML::Node& node, double& value, const std::string& key);
  bool decode(const YAML::Node& node, int& value, const std::string& key);
  bool decode(const YAML::Node& node, std::int64_t& value, const std::string& key);
  bool decode(const YAML::Node& node, std::string& value, const std::string& key);
  bool decode(const YAML::Node& node, bool& value, const std::string& key);
  bool decode(const YAML::Node& node, std::vector<double>& value, const std::string& key);
  bool decode(const YAML::Node& node, Eigen::Vector2d& value, const std::string& key);
  bool decode(const YAML::Node& node, Eigen::Vector3d& value, const std::string& key);
  bool decode(const YAML::Node& node, std::vector<Eigen::Vector2d>& value, const std::string& key);

  static std::vector<double> coordinatesOf(const std::vector<Eigen::Vector2d>& points);
  template <class T>
  static std::vector<double> numbersOf(const T& value) {
    if constexpr (std::is_same_v<T, std::string>)
      return {};
    else if constexpr (std::is_same_v<T, std::vector<Eigen::Vector2d>>)
      return coordinatesOf(value);
    else if constexpr (std::is_arithmetic_v<T>)
      return {static_cast<double>(value)};
    else
      return std::vector<double>(value.data(), value.data() + value.size());
  }

  std::string file_, name_;
  YAML::Node node_;
  FaultCollector* faults_;
  std::set<std::string> asked_;
};

}  // namespace slam::sim
