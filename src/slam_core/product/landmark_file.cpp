// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/landmark_file.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/input_file.hpp"
#include "slam_core/common/yaml_file.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/product/place_fault.hpp"
#include "slam_core/product/stamp_text.hpp"

namespace slam {
namespace {

/// The shortest digits that read back as the same number.
template <class Matrix>
void appendNumbers(const Matrix& matrix, fmt::memory_buffer& text) {
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
      fmt::format_to(fmt::appender(text), FMT_COMPILE("{}{}"), row + column == 0 ? "" : ", ",
                     matrix(row, column));
}

template <class Matrix>
std::string numbers(const Matrix& matrix) {
  fmt::memory_buffer text;
  appendNumbers(matrix, text);
  return fmt::to_string(text);
}

/// Of a large map this is most of the file.
std::string jointText(const Eigen::MatrixXd& joint) {
  fmt::memory_buffer text;
  const auto append = [&](const std::string& part) { text.append(part); };
  append("joint_covariance:  # of pose, then landmarks; lower triangle, a row a line\n");
  for (Eigen::Index row = 0; row < joint.rows(); ++row) {
    append("  - [");
    appendNumbers(joint.row(row).head(row + 1), text);
    append("]\n");
  }
  return fmt::to_string(text);
}

/// Whose numbers are not finite; empty where all are.
std::string notFinite(const MapState& map) {
  if (!map.robot.pose.isFinite() || !map.robot.covariance.allFinite()) return "the pose";
  for (const auto& landmark : map.landmarks)
    if (!landmark.position.allFinite() || !landmark.covariance.allFinite() ||
        !std::isfinite(landmark.direction))
      return fmt::format("landmark {}", landmark.id);
  return map.joint_covariance.allFinite() ? "" : "the joint covariance";
}

double number(const YAML::Node& parent, const std::string& key) {
  const double value = parent[key].as<double>();
  if (!std::isfinite(value)) throw std::runtime_error(key + " is not a finite number");
  return value;
}

Eigen::Vector2d position(const YAML::Node& parent, const std::string& owner) {
  const Eigen::Vector2d found(number(parent, "x"), number(parent, "y"));
  if (found.lpNorm<Eigen::Infinity>() > kFarthestInMap)
    throw std::runtime_error(fmt::format("{} is more than {:.0f} km from the map's origin", owner,
                                         kFarthestInMap / 1000));
  return found;
}

void requireUnits(const YAML::Node& units) {
  if (!units) return;
  const auto lengths = units["position"].as<std::string>(),
             angles = units["angle"].as<std::string>();
  if (lengths != "m" || angles != "rad")
    throw std::runtime_error(fmt::format(
        "its units are {} and {}: write positions in m, angles in rad", lengths, angles));
}

template <int N>
Eigen::Matrix<double, N, N> covariance(const YAML::Node& node, const std::string& owner) {
  const auto values = node.as<std::vector<double>>();
  if (values.size() != static_cast<std::size_t>(N * N))
    throw std::runtime_error(fmt::format("covariance of {} has not {} numbers", owner, N * N));
  const Eigen::Matrix<double, N, N> matrix =
      Eigen::Map<const Eigen::Matrix<double, N, N, Eigen::RowMajor>>(values.data());
  if (!isCovariance(matrix))
    throw std::runtime_error("covariance of " + owner + " is not positive definite");
  return matrix;
}

std::string textOf(const Landmark& landmark) {
  const auto line = fmt::format(", kind: line, direction: {}, begin: {}, end: {}",
                                landmark.direction, landmark.extent.begin, landmark.extent.end);
  const auto& [values, sigmas] = landmark.descriptor;
  const auto descriptor =
      fmt::format(", descriptor: [{}], descriptor_sigma: [{}]", numbers(values), numbers(sigmas));
  return fmt::format("  - {{id: {}, x: {}, y: {}, covariance: [{}]{}{}}}\n", landmark.id,
                     landmark.position.x(), landmark.position.y(), numbers(landmark.covariance),
                     landmark.isLine() ? line : "",
                     landmark.descriptor.isEmpty() ? "" : descriptor);
}

Descriptor::Vector descriptorNumbers(const YAML::Node& node) {
  const auto numbers = node ? node.as<std::vector<float>>() : std::vector<float>();
  constexpr std::size_t kRoom = Descriptor::kMostElements + 1;
  const auto size = static_cast<Eigen::Index>(std::min(numbers.size(), kRoom));
  return Eigen::Map<const Eigen::VectorXf>(numbers.data(), size);
}

void readDescriptor(const YAML::Node& entry, Landmark& landmark) {
  landmark.descriptor = {descriptorNumbers(entry["descriptor"]),
                         descriptorNumbers(entry["descriptor_sigma"])};
  if (const auto fault = faultOf(landmark.descriptor); !fault.empty())
    throw std::runtime_error(fmt::format("landmark {}{}", landmark.id, fault));
}

/// A landmark without a kind is a point.
void readKind(const YAML::Node& entry, Landmark& landmark) {
  if (!entry["kind"]) return;
  const auto kind = entry["kind"].as<std::string>(), owner = std::to_string(landmark.id);
  if (kind != "point" && kind != "line")
    throw std::runtime_error("kind '" + kind + "' of landmark " + owner +
                             " is neither point nor line");
  if (kind == "point") return;
  landmark.kind = LandmarkKind::kLine;
  landmark.direction = number(entry, "direction");
  landmark.extent = {number(entry, "begin"), number(entry, "end")};
  if (landmark.extent.begin >= landmark.extent.end)
    throw std::runtime_error("line " + owner + " ends where it begins, or before");
}

LandmarkMap readLandmarks(const YAML::Node& list) {
  LandmarkMap landmarks;
  for (const auto& entry : list) {
    Landmark landmark;
    landmark.id = entry["id"].as<LandmarkId>();
    const auto owner = "landmark " + std::to_string(landmark.id);
    landmark.position = position(entry, owner);
    landmark.covariance = covariance<2>(entry["covariance"], owner);
    readKind(entry, landmark);
    readDescriptor(entry, landmark);
    landmarks.push_back(landmark);
  }
  const auto by_id = [](const Landmark& a, const Landmark& b) { return a.id < b.id; };
  if (!std::is_sorted(landmarks.begin(), landmarks.end(), by_id))
    throw std::runtime_error("landmarks are not sorted by id");
  const auto same_id = [](const Landmark& a, const Landmark& b) { return a.id == b.id; };
  const auto twin = std::adjacent_find(landmarks.begin(), landmarks.end(), same_id);
  if (twin != landmarks.end())
    throw std::runtime_error(fmt::format("landmark {} is there twice", twin->id));
  return landmarks;
}

Eigen::MatrixXd readJoint(const YAML::Node& rows, std::size_t landmarks) {
  if (!rows) return {};
  const auto size = 3 + 2 * landmarks;
  if (rows.size() != size)
    throw std::runtime_error(fmt::format("joint_covariance has not {} rows", size));
  Eigen::MatrixXd joint(size, size);
  for (std::size_t row = 0; row < size; ++row) {
    const auto values = rows[row].as<std::vector<double>>();
    if (values.size() != row + 1)
      throw std::runtime_error(
          fmt::format("row {} of joint_covariance has not {} numbers", row, row + 1));
    for (std::size_t column = 0; column <= row; ++column) {
      const auto r = static_cast<Eigen::Index>(row), c = static_cast<Eigen::Index>(column);
      joint(r, c) = joint(c, r) = values[column];
    }
  }
  if (!isCovariance(joint)) throw std::runtime_error("joint_covariance is not positive definite");
  return joint;
}

/// A file that was cut off between two lines is valid YAML: it says itself what must be in it.
void requireContents(const YAML::Node& contents, const MapState& map) {
  if (!contents) return;
  const auto landmarks = contents["landmarks"].as<std::size_t>();
  if (map.landmarks.size() != landmarks)
    throw std::runtime_error(fmt::format("it should hold {} landmarks and holds {}; it is cut off",
                                         landmarks, map.landmarks.size()));
  if (contents["joint_covariance"].as<bool>() && map.joint_covariance.size() == 0)
    throw std::runtime_error("its joint_covariance is missing; it is cut off");
}

/// "12.000000345", or nothing in a file that was written by hand.
Stamp readStamp(const YAML::Node& node) {
  if (!node) return {};
  const auto text = node.as<std::string>();
  const auto point = text.find('.');
  const auto digits = [](const std::string& part) {
    return !part.empty() && part.find_first_not_of("0123456789") == std::string::npos;
  };
  if (point == std::string::npos || !digits(text.substr(0, point)) || text.size() != point + 10 ||
      point > 10 || !digits(text.substr(point + 1)))
    throw std::runtime_error("stamp '" + text + "' is not seconds with nine decimals");
  return stampFromNanoseconds(std::stoll(text.substr(0, point) + text.substr(point + 1)));
}

LandmarkFile parse(const YAML::Node& root, const std::string& frame) {
  if (!root.IsMap() || !root["version"]) throw std::runtime_error("it has no version");
  if (const auto version = root["version"].as<int>(); version != LandmarkFile::kVersion)
    throw std::runtime_error(fmt::format("it has version {}, this program reads version {}",
                                         version, LandmarkFile::kVersion));
  LandmarkFile file;
  file.frame = root["frame"].as<std::string>();
  if (file.frame != frame)
    throw std::runtime_error("it is in frame '" + file.frame + "', the map frame here is '" +
                             frame + "'");
  requireUnits(root["units"]);
  const auto pose = root["pose"];
  const auto robot = position(pose, "the pose");
  file.map.robot.pose = Pose2(robot.x(), robot.y(), number(pose, "theta"));
  file.map.robot.covariance = covariance<3>(pose["covariance"], "the pose");
  file.stamp = readStamp(root["stamp"]);
  if (!root["landmarks"]) throw std::runtime_error("it has no landmarks; it may be cut off");
  file.map.landmarks = readLandmarks(root["landmarks"]);
  file.map.joint_covariance = readJoint(root["joint_covariance"], file.map.landmarks.size());
  requireContents(root["contents"], file.map);
  return file;
}

}  // namespace

std::string toYaml(const LandmarkFile& file) {
  const auto& robot = file.map.robot;
  std::string text = fmt::format(
      "version: {}\nframe: {}\nunits: {{position: m, angle: rad}}\nstamp: \"{}\"\n"
      "contents: {{landmarks: {}, joint_covariance: {}}}\n"
      "pose: {{x: {}, y: {}, theta: {}, covariance: [{}]}}\nlandmarks:{}\n",
      LandmarkFile::kVersion, file.frame, stampText(file.stamp), file.map.landmarks.size(),
      file.map.joint_covariance.size() > 0, robot.pose.x(), robot.pose.y(), robot.pose.theta(),
      numbers(robot.covariance), file.map.landmarks.empty() ? " []" : "");
  for (const auto& landmark : file.map.landmarks) text += textOf(landmark);
  if (file.map.joint_covariance.size() > 0) text += jointText(file.map.joint_covariance);
  return text;
}

void saveLandmarks(const std::string& path, const LandmarkFile& file) {
  if (const auto culprit = notFinite(file.map); !culprit.empty())
    throw std::runtime_error("cannot save the landmark map " + path + ": " + culprit +
                             " is not finite, the filter has failed; check the noise in the robot "
                             "file and the configuration");
  writeFileAtomically(path, toYaml(file));
}

LandmarkFile loadLandmarks(const std::string& path, const std::string& frame) {
  requireInputFile(path, "the landmark map");
  try {
    return parse(loadYamlFile(path, "the landmark map", YamlLimits::map()), frame);
  } catch (const std::exception& error) {
    throw std::runtime_error("cannot use the landmark map " + path + ": " + error.what());
  }
}

}  // namespace slam
