// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "yaml_map.hpp"

#include <algorithm>
#include <cmath>

namespace slam::sim {
namespace {

std::string place(const std::string& file, const YAML::Node& node) {
  const auto mark = node.Mark();
  return mark.is_null() || mark.line < 0 ? file : file + ":" + std::to_string(mark.line + 1);
}

std::string textOf(const YAML::Node& node) {
  if (node.IsScalar()) return "'" + node.Scalar() + "'";
  return node.IsSequence() ? "a list" : node.IsMap() ? "a map" : "nothing";
}

bool finiteNumber(const YAML::Node& node, double& value) {
  return YAML::convert<double>::decode(node, value) && std::isfinite(value);
}

bool finiteNumbers(const YAML::Node& node, std::vector<double>& values) {
  if (!node.IsSequence()) return false;
  std::vector<double> all(node.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!finiteNumber(node[i], all[i])) return false;
  values = all;
  return true;
}

}  // namespace

YamlMap::YamlMap(std::string file, std::string name, const YAML::Node& node, FaultCollector& faults)
    : file_(std::move(file)), name_(std::move(name)), node_(node), faults_(&faults) {
  if (node_.IsMap() || node_.IsNull()) return;
  fault("is not a map of keys and values");
}

std::string YamlMap::where() const {
  return place(file_, node_) + ":" + (name_.empty() ? "" : " " + name_);
}

std::string YamlMap::at(const YAML::Node& node, const std::string& key) const {
  return place(file_, node) + ": " + (name_.empty() ? "" : name_ + ": ") + key;
}

YAML::Node YamlMap::find(const std::string& key) {
  asked_.insert(key);
  return has(key) ? node_[key] : YAML::Node(YAML::NodeType::Undefined);
}

void YamlMap::read(const std::string& key, std::string& target,
                   const std::vector<std::string>& choices) {
  const auto node = find(key);
  std::string text;
  if (!node || !decode(node, text, key)) return;
  if (std::find(choices.begin(), choices.end(), text) != choices.end())
    target = text;
  else
    faults_->add(at(node, key) + " '" + text + "' is none of " + join(choices) +
                 didYouMean(text, choices));
}

std::vector<YamlMap> YamlMap::list(const std::string& key) {
  std::vector<YamlMap> maps;
  const auto node = find(key);
  if (!node || node.IsNull()) return maps;
  if (!node.IsSequence()) {
    wrongType(node, key, "a list");
    return maps;
  }
  for (std::size_t i = 0; i < node.size(); ++i)
    maps.emplace_back(file_, key + "[" + std::to_string(i) + "]", node[i], *faults_);
  return maps;
}

YamlMap YamlMap::map(const std::string& key) {
  const auto node = find(key);
  return YamlMap(file_, key, node ? node : YAML::Node(YAML::NodeType::Null), *faults_);
}

void YamlMap::finish() {
  if (!node_.IsMap()) return;
  std::set<std::string> seen;
  const std::vector<std::string> known(asked_.begin(), asked_.end());
  for (const auto& entry : node_) {
    const auto& key = entry.first.Scalar();
    if (asked_.count(key) == 0)
      faults_->add(at(entry.first, key) + " is unknown" + didYouMean(key, known) +
                   "; known are: " + join(known));
    if (!seen.insert(key).second) faults_->add(at(entry.first, key) + " is given twice");
  }
}

void YamlMap::wrongType(const YAML::Node& node, const std::string& key, const std::string& type) {
  faults_->add(at(node, key) + " is " + textOf(node) + ", not " + type);
}

void YamlMap::checkRange(const YAML::Node& node, const std::string& key,
                         const std::vector<double>& values, const Range& range) {
  for (const double value : values)
    if (!range.contains(value)) {
      faults_->add(at(node, key) + " holds " + textOf(YAML::Node(value)) + ", which is not in " +
                   range.text());
      return;
    }
}

std::vector<double> YamlMap::coordinatesOf(const std::vector<Eigen::Vector2d>& points) {
  std::vector<double> all;
  for (const auto& point : points) all.insert(all.end(), {point.x(), point.y()});
  return all;
}

bool YamlMap::decode(const YAML::Node& node, double& value, const std::string& key) {
  if (finiteNumber(node, value)) return true;
  wrongType(node, key, "a number");
  return false;
}

bool YamlMap::decode(const YAML::Node& node, int& value, const std::string& key) {
  if (YAML::convert<int>::decode(node, value)) return true;
  wrongType(node, key, "a whole number");
  return false;
}

bool YamlMap::decode(const YAML::Node& node, std::int64_t& value, const std::string& key) {
  if (YAML::convert<std::int64_t>::decode(node, value)) return true;
  wrongType(node, key, "a whole number");
  return false;
}

bool YamlMap::decode(const YAML::Node& node, std::string& value, const std::string& key) {
  if (node.IsScalar()) return value = node.Scalar(), true;
  wrongType(node, key, "a text");
  return false;
}

bool YamlMap::decode(const YAML::Node& node, bool& value, const std::string& key) {
  if (YAML::convert<bool>::decode(node, value)) return true;
  wrongType(node, key, "true or false");
  return false;
}

bool YamlMap::decode(const YAML::Node& node, std::vector<double>& value, const std::string& key) {
  if (finiteNumbers(node, value)) return true;
  wrongType(node, key, "a list of numbers");
  return false;
}

bool YamlMap::decode(const YAML::Node& node, Eigen::Vector2d& value, const std::string& key) {
  std::vector<double> numbers;
  if (finiteNumbers(node, numbers) && numbers.size() == 2)
    return value = Eigen::Vector2d(numbers[0], numbers[1]), true;
  wrongType(node, key, "a list of 2 numbers");
  return false;
}

bool YamlMap::decode(const YAML::Node& node, Eigen::Vector3d& value, const std::string& key) {
  std::vector<double> numbers;
  if (finiteNumbers(node, numbers) && numbers.size() == 3)
    return value = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]), true;
  wrongType(node, key, "a list of 3 numbers");
  return false;
}

bool YamlMap::decode(const YAML::Node& node, std::vector<Eigen::Vector2d>& value,
                     const std::string& key) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; node.IsSequence() && i < node.size(); ++i) {
    std::vector<double> numbers;
    if (!finiteNumbers(node[i], numbers) || numbers.size() != 2) break;
    points.emplace_back(numbers[0], numbers[1]);
  }
  if (node.IsSequence() && points.size() == node.size()) return value = points, true;
  wrongType(node, key, "a list of points [x, y]");
  return false;
}

}  // namespace slam::sim
