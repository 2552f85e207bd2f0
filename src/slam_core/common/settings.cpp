// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/settings.hpp"

#include <algorithm>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/yaml_file.hpp"

namespace slam {
namespace {

std::string place(const ConfigDocument& document, const YAML::Node& node) {
  const auto mark = node.Mark();
  return mark.is_null() || mark.line < 0 ? document.name
                                         : document.name + ":" + std::to_string(mark.line + 1);
}

std::string path(const std::string& section, const std::string& key) {
  return section.empty() ? key : section + "." + key;
}

std::string text(const YAML::Node& node) {
  return node.IsScalar() ? "'" + node.Scalar() + "'" : node.IsNull() ? "nothing" : "a list or map";
}

std::string quoted(const std::string& value) {
  YAML::Emitter yaml;
  yaml << YAML::DoubleQuoted << value;
  return yaml.c_str();
}

template <class Value>
bool decode(const YAML::Node& node, Value& value) {
  return YAML::convert<Value>::decode(node, value);
}
bool decode(const YAML::Node& node, Choice& choice) {
  std::string text;
  const bool is_text = YAML::convert<std::string>::decode(node, text);
  if (is_text) choice.assign(text);
  return is_text;
}

/// Empty when the node was of the field's type, else the fault.
std::string assign(const Field& field, const YAML::Node& node) {
  const auto convert = [&](auto* target) {
    using Value = std::remove_pointer_t<decltype(target)>;
    // yaml-cpp reads "-1" into an unsigned number without complaint
    const bool negative = std::is_unsigned_v<Value> && node.IsScalar() && node.Scalar()[0] == '-';
    try {
      return !negative && decode(node, *target);
    } catch (const YAML::Exception&) {  // of an entry of a list or map
      return false;
    }
  };
  if (!std::visit(convert, field.target)) return text(node) + " is not of type " + field.typeName();
  return field.fault();
}

/// The text of an override is YAML where the field is a list or map: [1, 2], {3: 0.2}.
YAML::Node nodeOf(const Field& field, const std::string& text) {
  if (!field.isListOrMap()) return YAML::Node(text);
  try {
    return parseYaml(text, YamlLimits::configuration());
  } catch (const YAML::Exception&) {
    return YAML::Node(text);
  }
}

const ConfigDocument& requireMap(const ConfigDocument& document) {
  if (document.root && !document.root.IsMap() && !document.root.IsNull())
    throw ConfigError(document.name + " is not a map of keys and values");
  return document;
}

void requireVersion(const ConfigDocument& document) {
  if (!document.root || document.root.IsNull()) return;
  const auto version = document.root["version"];
  int number = 0;
  if (version && YAML::convert<int>::decode(version, number) && number == Settings::kVersion)
    return;
  throw ConfigError(document.name + " has " +
                    (version ? "version " + text(version) : std::string("no version")) +
                    "; this program reads version " + std::to_string(Settings::kVersion));
}

/// yaml-cpp keeps both of two equal keys, and would take the one or the other.
void findDoubles(const ConfigDocument& document, const YAML::Node& node, const std::string& section,
                 FaultCollector& faults) {
  if (!node.IsMap()) return;
  std::set<std::string> seen;
  for (const auto& entry : node) {
    const auto name = path(section, entry.first.Scalar());
    if (!seen.insert(name).second)
      faults.add(name + " in " + place(document, entry.first) + " stands there a second time");
    findDoubles(document, entry.second, name, faults);
  }
}

}  // namespace

ConfigDocument loadConfigFile(const std::string& file) {
  try {
    const auto root = loadYamlFile(file, "the file", YamlLimits::configuration());
    if (root.IsNull()) throw ConfigError(file + " is empty");
    return {file, root};
  } catch (const ConfigError&) {
    throw;
  } catch (const YAML::Exception& error) {
    throw ConfigError(file + " is not YAML that can be used: " + error.what());
  } catch (const std::runtime_error& error) {
    throw ConfigError(error.what());
  }
}

Settings::Settings(ConfigDocument product, ConfigDocument robot, std::vector<std::string> overrides)
    : product_(std::move(product)), robot_(std::move(robot)) {
  FaultCollector faults;
  for (const auto* document : {&product_, &robot_})
    faults.attempt([&] {
      requireVersion(requireMap(*document));
      if (document->root) findDoubles(*document, document->root, "", faults);
    });
  for (const auto& entry : overrides) {
    const auto equals = entry.find('=');
    const auto dot = entry.substr(0, equals).rfind('.');
    if (equals == std::string::npos || equals == 0)
      faults.add("override '" + entry + "' is not of the form section.key=value");
    else if (dot == std::string::npos)
      overrides_.push_back({"", entry.substr(0, equals), entry.substr(equals + 1)});
    else
      overrides_.push_back({entry.substr(0, dot), entry.substr(dot + 1, equals - dot - 1),
                            entry.substr(equals + 1)});
  }
  faults.raise();
}

void Settings::readSection(const std::string& section, const Fields& fields) {
  std::vector<std::string> faults;
  applyDocument(product_, Scope::kProduct, section, fields, faults);
  applyDocument(robot_, Scope::kRobot, section, fields, faults);
  applyOverrides(section, fields, faults);
  if (read_.insert(section).second) {
    std::string values;
    const std::string indent = section.empty() ? "" : "  ";
    for (const auto& field : fields.all()) {
      const auto value = field.isText() ? quoted(field.valueText()) : field.valueText();
      values += indent + field.name + ": " + value + "\n";
    }
    in_force_.emplace_back(section, values);
  }
  if (!faults.empty()) throw ConfigError(faults);
}

void Settings::checkUnusedSection(const std::string& section, const Fields& fields) {
  if (read_.count(section) > 0) return;
  unused_.insert(section);
  std::vector<std::string> faults;
  applyDocument(product_, Scope::kProduct, section, fields, faults);
  applyDocument(robot_, Scope::kRobot, section, fields, faults);
  if (!faults.empty()) throw ConfigError(faults);
}

void Settings::applyDocument(const ConfigDocument& document, Scope scope,
                             const std::string& section, const Fields& fields,
                             std::vector<std::string>& faults) const {
  if (!document.root || !document.root.IsMap()) return;
  const YAML::Node node = section.empty() ? document.root : document.root[section];
  if (!node || node.IsNull()) return;
  if (!node.IsMap()) {
    faults.push_back(section + " in " + place(document, node) + " is not a map of keys and values");
    return;
  }
  for (const auto& entry : node) {
    const auto key = entry.first.Scalar();
    const bool is_section_or_version =
        section.empty() && (entry.second.IsMap() || entry.second.IsNull() || key == "version");
    if (is_section_or_version) continue;
    const auto where = path(section, key) + " in " + place(document, entry.first) + ": ";
    const auto* field = fields.find(key);
    if (field == nullptr) {
      faults.push_back(where + "unknown" + didYouMean(key, fields.names()) +
                       "; known are: " + join(fields.names()));
    } else if (field->scope != scope) {
      faults.push_back(where + "belongs in the " +
                       (field->scope == Scope::kRobot ? "robot" : "product") + " file");
    } else if (const auto fault = assign(*field, entry.second); !fault.empty()) {
      faults.push_back(where + fault);
    }
  }
}

void Settings::applyOverrides(const std::string& section, const Fields& fields,
                              std::vector<std::string>& faults) const {
  for (const auto& given : overrides_) {
    if (given.section != section) continue;
    const auto where = "override " + path(section, given.key) + ": ";
    const auto* field = fields.find(given.key);
    if (field == nullptr) {
      faults.push_back(where + "unknown" + didYouMean(given.key, fields.names()));
      continue;
    }
    const auto fault = assign(*field, nodeOf(*field, given.text));
    if (!fault.empty()) faults.push_back(where + fault);
  }
}

void Settings::requireAllRead() const {
  FaultCollector faults;
  std::vector<std::string> known(read_.begin(), read_.end());
  known.insert(known.end(), unused_.begin(), unused_.end());
  for (const auto* document : {&product_, &robot_}) {
    if (!document->root || !document->root.IsMap()) continue;
    for (const auto& entry : document->root) {
      const auto key = entry.first.Scalar();
      const bool is_section = entry.second.IsMap() || entry.second.IsNull();
      if (is_section && read_.count(key) == 0 && unused_.count(key) == 0)
        faults.add("section " + key + " in " + place(*document, entry.first) +
                   " belongs to no component of this product" + didYouMean(key, known));
    }
  }
  for (const auto& given : overrides_)
    if (read_.count(given.section) == 0)
      faults.add("override " + path(given.section, given.key) + "=" + given.text +
                 " names no section of this product" + didYouMean(given.section, known));
  faults.raise();
}

std::string Settings::inForce() const {
  std::string text;
  for (const auto& [section, values] : in_force_)
    text += section.empty() ? values : section + ":\n" + values;
  return text;
}

}  // namespace slam
