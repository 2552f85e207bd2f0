// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <string>

namespace slam {

/// How much YAML may hold. An alias counts as all that it stands for: a few lines of aliases to
/// aliases are billions of nodes for who goes through them.
struct YamlLimits {
  std::uint64_t bytes, nodes;
  std::size_t depth;  ///< of lists and maps within each other

  /// A product, a robot, a world; a map's description.
  static constexpr YamlLimits configuration() { return {4u << 20, 200'000, 32}; }
  /// A landmark map, whose joint covariance grows with the square of the landmarks.
  static constexpr YamlLimits map() { return {1u << 30, 100'000'000, 32}; }
};

/// Parses text once it is known to be within the limits and without an alias that stands within
/// what it refers to.
/// @throw YAML::Exception with line and column
YAML::Node parseYaml(const std::string& text, const YamlLimits& limits);

/// The same of a file. @param what as for requireInputFile()
/// @throw std::runtime_error when it cannot be read, with the whole sentence; YAML::Exception
YAML::Node loadYamlFile(const std::string& path, const std::string& what, const YamlLimits& limits);

}  // namespace slam
