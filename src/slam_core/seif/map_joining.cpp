// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/map_joining.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "slam_core/graph/factors.hpp"
#include "slam_core/graph/optimizer.hpp"

namespace slam::seif {
namespace {

template <class T>
std::size_t placeIn(const std::vector<T>& all, const T& one) {
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), one) - all.begin());
}

/// The points of a local map at these places alone.
graph::LocalMap pointsOf(const graph::LocalMap& map, const std::vector<std::size_t>& places) {
  graph::LocalMap part;
  std::vector<Eigen::Index> rows;
  for (const auto place : places) {
    part.points.push_back(map.points[place]);
    rows.push_back(static_cast<Eigen::Index>(3 * map.poses.size() + 2 * place));
    rows.push_back(rows.back() + 1);
  }
  part.covariance = map.covariance(rows, rows);
  return part;
}

/// Two parts in one graph, in the frame of the first one's base.
class Joint {
 public:
  Joint(const MappedPart& first, const MappedPart& second, const Pose2& second_base) {
    constexpr double kHeld = 1e6;  // the weight of what defines the frame [1/m, 1/rad]
    first_base_ = add(first, Pose2());
    graph_.add(std::make_shared<graph::PosePrior>(first_base_, Pose2(),
                                                  kHeld * Eigen::Matrix3d::Identity()));
    second_base_ = add(second, second_base);
  }

  bool isSolved() {
    constexpr int kSteps = 20;
    return graph_.optimize({first_base_}, kSteps);
  }
  /// @return standard deviation of the second base's heading relative to the first one [rad]
  double headingSigma() const { return std::sqrt(graph_.covariance({second_base_})(2, 2)); }
  MappedPart without(const std::vector<graph::Key>& poses) const {
    const Pose2 T_base_map = graph_.pose(first_base_).inverse();
    MappedPart both;
    std::vector<graph::Key> keys;
    for (const auto& [pose, key] : poses_) {
      if (std::find(poses.begin(), poses.end(), pose) != poses.end()) continue;
      both.poses.push_back(pose);
      both.map.poses.push_back(T_base_map * graph_.pose(key));
      keys.push_back(key);
    }
    for (const auto& [landmark, key] : points_) {
      both.landmarks.push_back(landmark);
      both.map.points.push_back(T_base_map.transform(graph_.pose(key).position()));
      keys.push_back(key);
    }
    both.map.covariance = graph_.covariance(keys);
    return both;
  }

 private:
  graph::Key add(const MappedPart& part, const Pose2& base) {
    std::vector<graph::Key> keys = {graph_.add(base)};
    for (std::size_t i = 0; i < part.poses.size(); ++i) {
      const auto [found, is_new] = poses_.try_emplace(part.poses[i], -1);
      if (is_new) found->second = graph_.add(base * part.map.poses[i]);
      keys.push_back(found->second);
    }
    for (std::size_t i = 0; i < part.landmarks.size(); ++i) {
      const auto [found, is_new] = points_.try_emplace(part.landmarks[i], -1);
      if (is_new) found->second = graph_.add(base.transform(part.map.points[i]));
      keys.push_back(found->second);
    }
    graph_.add(std::make_shared<graph::BasedMap>(keys, part.map));
    return keys.front();
  }

  graph::Optimizer graph_;
  std::map<graph::Key, graph::Key> poses_;
  std::map<std::size_t, graph::Key> points_;
  graph::Key first_base_ = -1, second_base_ = -1;
};

/// Where the base of the second part lies in the frame of the first one.
Pose2 meetingOf(const MappedPart& first, const MappedPart& second, const SharedPart& shared) {
  if (!shared.poses.empty()) {
    const auto a = placeIn(first.poses, shared.poses[0]),
               b = placeIn(second.poses, shared.poses[0]);
    return first.map.poses[a] * second.map.poses[b].inverse();
  }
  std::vector<Pose2> at;
  for (const auto place : shared.in_first)
    at.emplace_back(first.map.points[place].x(), first.map.points[place].y(), 0.0);
  return graph::FreeMap(std::vector<graph::Key>(at.size(), 0),
                        pointsOf(second.map, shared.in_second))
      .base(at);
}

/// Whether a Gaussian says where the points are: the bearing of each, seen from the base, is known.
bool isStraight(const graph::LocalMap& map, double largest_sigma) {
  constexpr double kNear = 1.0;  // what is nearer is bent less than that is far [m]
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(3 * map.poses.size() + 2 * i);
    const double sigma = std::sqrt(map.covariance.block<2, 2>(row, row).trace());
    if (sigma > largest_sigma * std::max(kNear, map.points[i].norm())) return false;
  }
  return true;
}

}  // namespace

SharedPart::SharedPart(const MappedPart& first, const MappedPart& second) {
  for (std::size_t i = 0; i < second.landmarks.size(); ++i) {
    const auto place = placeIn(first.landmarks, second.landmarks[i]);
    if (place == first.landmarks.size()) continue;
    in_first.push_back(place);
    in_second.push_back(i);
  }
  for (const auto pose : second.poses)
    if (placeIn(first.poses, pose) < first.poses.size()) poses.push_back(pose);
}

bool determinesBase(const graph::LocalMap& map, const std::vector<std::size_t>& points) {
  constexpr double kLargestSigma = 0.03;  // [rad]
  if (points.size() < 2) return false;
  const auto part = pointsOf(map, points);
  std::vector<Pose2> at = {Pose2()};
  for (const auto& point : part.points) at.emplace_back(point.x(), point.y(), 0.0);
  const Eigen::MatrixXd J =
      graph::BasedMap(std::vector<graph::Key>(at.size(), 0), part).linearized(at).J.leftCols<3>();
  const Eigen::FullPivLU<Eigen::Matrix3d> information(J.transpose() * J);
  return information.isInvertible() && information.inverse()(2, 2) < std::pow(kLargestSigma, 2);
}

std::optional<MappedPart> joined(const MappedPart& first, const MappedPart& second,
                                 const std::vector<graph::Key>& marginalised,
                                 double largest_heading) {
  const SharedPart shared(first, second);
  if (shared.poses.empty() &&
      !(determinesBase(first.map, shared.in_first) && determinesBase(second.map, shared.in_second)))
    return std::nullopt;
  Joint joint(first, second, meetingOf(first, second, shared));
  if (!joint.isSolved() || joint.headingSigma() > largest_heading) return std::nullopt;
  auto both = joint.without(marginalised);
  if (!isStraight(both.map, 2.0 * largest_heading)) return std::nullopt;
  return both;
}

}  // namespace slam::seif
