// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/parameter_check.hpp"

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/yaml_file.hpp"
#include "slam_core/contract/known_sections.hpp"

namespace slam_ros {
namespace {

void requireFaultless(slam::Settings& settings) {
  slam::FaultCollector faults;
  visitSharedSections([&](auto config) { faults.attempt([&] { settings.read(config); }); });
  faults.attempt([&] { slam::KnownSections::instance().readAll(settings); });
  faults.attempt([&] { settings.requireAllRead(); });
  faults.raise();
}

/// What cannot be read as YAML counts as a text, which only few parameters are.
YAML::Node valueOf(const std::string& text) {
  try {
    return slam::parseYaml(text, slam::YamlLimits::configuration());
  } catch (const YAML::Exception&) {
    return YAML::Node(text);
  }
}

/// The parameters as a product file would hold them.
slam::ConfigDocument documentOf(const std::vector<std::string>& parameters) {
  YAML::Node root(YAML::NodeType::Map);
  root["version"] = slam::Settings::kVersion;
  for (const auto& parameter : parameters) {
    const auto equals = parameter.find('=');
    const auto dot = parameter.substr(0, equals).rfind('.');
    if (equals == std::string::npos || dot == std::string::npos)
      throw slam::ConfigError("'" + parameter + "' is not of the form section.key=value");
    root[parameter.substr(0, dot)][parameter.substr(dot + 1, equals - dot - 1)] =
        valueOf(parameter.substr(equals + 1));
  }
  return {"the arguments", root};
}

}  // namespace

void checkProductFile(const std::string& file, const std::vector<std::string>& overrides) {
  const auto document = file.empty() ? slam::ConfigDocument() : slam::loadConfigFile(file);
  slam::Settings settings(document, {}, overrides);
  slam::ProductConfig product;
  slam::FaultCollector faults;
  faults.attempt([&] { slam::readProduct(settings, product); });
  faults.attempt([&] { requireFaultless(settings); });
  faults.raise();
}

void checkRobotFile(const std::string& file) {
  slam::Settings settings({}, slam::loadConfigFile(file), {});
  requireFaultless(settings);
}

void checkProductParameters(const std::vector<std::string>& parameters) {
  slam::Settings settings(documentOf(parameters), {}, {});
  requireFaultless(settings);
}

}  // namespace slam_ros
