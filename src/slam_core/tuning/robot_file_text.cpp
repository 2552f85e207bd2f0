// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/tuning/robot_file_text.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/nearest_name.hpp"

namespace slam::tuning {
namespace {

using Lines = std::vector<std::string>;

/// A comment that tells where values are from: its first words and its last.
struct Remark {
  const char *begin, *end;
};
constexpr Remark kTuned = {"Noise tuned by slam_tune", "are no test of it."};
constexpr Remark kCalibrated = {"Calibrated by a run", "Other drives may tell more."};

Lines linesOf(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string textOf(const Lines& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

bool begins(const std::string& line, const std::string& with) { return line.rfind(with, 0) == 0; }

bool ends(const std::string& line, const std::string& with) {
  return line.size() >= with.size() && line.substr(line.size() - with.size()) == with;
}

bool isKey(const std::string& line) {
  return !line.empty() && line[0] != ' ' && line[0] != '#' && line.find(':') != std::string::npos;
}

std::string formatted(const TunedParameter& parameter) {
  return fmt::format("{:.{}g}", parameter.value, parameter.digits);
}

/// The key of a map and where it stands.
struct Entry {
  YAML::Node key, value;
};

std::optional<Entry> entryOf(const YAML::Node& map, const std::string& key) {
  if (!map.IsMap()) return std::nullopt;
  for (const auto& entry : map)
    if (entry.first.Scalar() == key) return Entry{entry.first, entry.second};
  return std::nullopt;
}

std::string& lineAt(Lines& lines, const YAML::Mark& mark) {
  return lines.at(static_cast<std::size_t>(mark.line));
}

/// The comment behind it stays in its column where there is room.
void replaceValue(Lines& lines, const YAML::Node& value, const std::string& by) {
  auto& line = lineAt(lines, value.Mark());
  const auto column = static_cast<std::size_t>(value.Mark().column);
  const auto head = line.substr(0, column) + by;
  const bool is_quoted = line.find_first_of("'\"", column) == column;
  const auto size = value.Scalar().size() + (is_quoted ? 2 : 0);
  const auto rest = line.substr(std::min(line.size(), column + size));
  const auto comment = rest.find_first_not_of(' ');
  if (comment == std::string::npos || rest[comment] != '#') {
    line = head + rest;
    return;
  }
  const auto wanted = line.size() - (rest.size() - comment);
  const auto gap = head.size() < wanted ? wanted - head.size() : 2;
  line = head + std::string(gap, ' ') + rest.substr(comment);
}

void insertIntoFlow(Lines& lines, const YAML::Node& map, const std::string& entry) {
  auto& line = lineAt(lines, map.Mark());
  const auto behind = static_cast<std::size_t>(map.Mark().column) + 1;  // the brace
  line.insert(std::min(behind, line.size()), map.size() == 0 ? entry : entry + ", ");
}

/// Below the last line of the section, indented as its first key.
void insertIntoBlock(Lines& lines, const Entry& section, const std::string& entry) {
  const auto& map = section.value;
  const int indentation = map.IsMap() ? map.begin()->first.Mark().column : 2;
  const auto begin = lines.begin() + section.key.Mark().line + 1;
  auto end = std::find_if(begin, lines.end(), isKey);
  // A comment above the next section belongs to that.
  while (end != begin && (end[-1].empty() || end[-1][0] == '#')) --end;
  lines.insert(end, std::string(static_cast<std::size_t>(indentation), ' ') + entry);
}

void put(Lines& lines, const TunedParameter& parameter) {
  const auto root = YAML::Load(textOf(lines));
  const auto section = entryOf(root, parameter.section);
  const auto entry = parameter.key + ": " + formatted(parameter);
  if (!section) {
    lines.insert(lines.end(), {"", parameter.section + ":", "  " + entry});
    return;
  }
  if (const auto known = entryOf(section->value, parameter.key))
    replaceValue(lines, known->value, formatted(parameter));
  else if (section->value.IsMap() && section->value.Style() == YAML::EmitterStyle::Flow)
    insertIntoFlow(lines, section->value, entry);
  else
    insertIntoBlock(lines, *section, entry);
}

/// An earlier remark of this kind tells of values that are no longer there.
void remove(const Remark& remark, Lines& lines) {
  const auto begin = std::find_if(lines.begin(), lines.end(), [&](const auto& line) {
    return begins(line, std::string("# ") + remark.begin);
  });
  auto end = begin;
  while (end != lines.end() && begins(*end, "#") && !ends(*end, remark.end)) ++end;
  if (end != lines.end() && ends(*end, remark.end)) lines.erase(begin, end + 1);
}

/// All that a file says, by the path of its keys.
void flatten(const YAML::Node& node, const std::string& path,
             std::map<std::string, std::string>& values) {
  if (node.IsScalar()) values[path] = node.Scalar();
  if (node.IsSequence())
    for (std::size_t i = 0; i < node.size(); ++i)
      flatten(node[i], path + "[" + std::to_string(i) + "]", values);
  if (!node.IsMap()) return;
  for (const auto& entry : node)
    flatten(entry.second, path + (path.empty() ? "" : ".") + entry.first.Scalar(), values);
}

std::map<std::string, std::string> valuesOf(const std::string& text) {
  std::map<std::string, std::string> values;
  flatten(YAML::Load(text), "", values);
  return values;
}

bool saysTheSameBut(const std::string& text, const std::string& before,
                    const std::vector<TunedParameter>& parameters) {
  auto expected = valuesOf(before);
  for (const auto& parameter : parameters)
    if (parameter.why_unseen.empty()) expected[parameter.name()] = formatted(parameter);
  return valuesOf(text) == expected;
}

}  // namespace

std::string tuningRemark(const std::string& product, const std::string& bags) {
  return fmt::format("{} with the product {} on {}: figures of these bags\n{}", kTuned.begin,
                     product, bags, kTuned.end);
}

std::string calibrationRemark(const std::vector<std::string>& told) {
  return fmt::format("{}, which estimated beside pose and map:\n{}\n{}", kCalibrated.begin,
                     join(told, "\n"), kCalibrated.end);
}

std::string withTunedValues(const std::string& text, const std::vector<TunedParameter>& parameters,
                            const std::string& remark) try {
  Lines lines = linesOf(text);
  for (const auto& parameter : parameters)
    if (parameter.why_unseen.empty()) put(lines, parameter);
  for (const auto& kind : {kTuned, kCalibrated})
    if (begins(remark, kind.begin)) remove(kind, lines);
  Lines comment;
  for (const auto& line : linesOf(remark)) comment.push_back(line.empty() ? "#" : "# " + line);
  lines.insert(std::find_if(lines.begin(), lines.end(), isKey), comment.begin(), comment.end());
  const auto result = textOf(lines);
  if (!saysTheSameBut(result, text, parameters)) throw std::runtime_error("other values");
  return result;
} catch (const std::exception&) {
  throw ConfigError(
      "tuned values cannot be put into the robot file as it is laid out; write each section as its "
      "name on a line and a line 'key: value' for each value below it, indented alike");
}

}  // namespace slam::tuning
