// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/triangulation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "slam_core/models/chi_square.hpp"
#include "slam_core/mono_graph/orb_extractor.hpp"

namespace slam::mono_graph {
namespace {

constexpr double kLeastParallax = 0.017;   // [rad]
constexpr int kLargestMatchDistance = 50;  // of descriptors
constexpr double kMatchRatio = 0.8;
constexpr int kLargestLevels = 2;                             // apart
constexpr double kNearestPoint = 0.2, kFarthestPoint = 30.0;  // of a point [m]

/// Two keyframes and the geometry between them.
class Pair {
 public:
  Pair(const Keyframe& a, const Keyframe& b)
      : a_(a),
        b_(b),
        centre_a_(a.features.camera().centre(a.pose)),
        centre_b_(b.features.camera().centre(b.pose)) {}

  bool isWide() const { return (centre_a_ - centre_b_).norm() > 0.03; }

  /// @return the line a x + b y + c = 0 on `b`'s plane that holds a feature of the other keyframe
  Eigen::Vector3d lineOf(const Feature& of_a) const {
    const Eigen::Vector3d ray = a_.features.camera().ray(a_.pose, of_a.seen);
    const auto& camera = b_.features.camera();
    const Eigen::Vector3d from = camera.inCamera(b_.pose, centre_a_);
    const Eigen::Vector3d to = camera.inCamera(b_.pose, centre_a_ + ray);
    return from.cross(to);
  }

  std::optional<Eigen::Vector3d> pointOf(const Feature& of_a, const Feature& of_b) const {
    const auto point =
        intersectionOf(centre_a_, a_.features.camera().ray(a_.pose, of_a.seen), centre_b_,
                       b_.features.camera().ray(b_.pose, of_b.seen), kLeastParallax);
    if (!point || !fits(a_, of_a, *point) || !fits(b_, of_b, *point)) return std::nullopt;
    const double depth = (*point - centre_a_).norm();
    if (depth < kNearestPoint || depth > kFarthestPoint) return std::nullopt;
    // A point looks as large as its distance says.
    const double ratio = (*point - centre_b_).norm() / depth;
    const double levels = std::log(ratio) / std::log(kPyramidScale);
    if (std::abs(of_a.level - of_b.level - levels) > kLargestLevels) return std::nullopt;
    return point;
  }

 private:
  static bool fits(const Keyframe& keyframe, const Feature& feature, const Eigen::Vector3d& point) {
    const auto seen = keyframe.features.camera().project(keyframe.pose, point);
    return seen &&
           (*seen - feature.seen).squaredNorm() <= kGateOfTwo * feature.sigma * feature.sigma;
  }

  const Keyframe &a_, &b_;
  Eigen::Vector3d centre_a_, centre_b_;
};

std::vector<int> freeFeatures(const Keyframe& keyframe) {
  std::vector<int> free;
  for (std::size_t i = 0; i < keyframe.points.size(); ++i)
    if (keyframe.points[i] == kNoPoint) free.push_back(static_cast<int>(i));
  return free;
}

bool isNear(const Eigen::Vector3d& line, const Feature& feature) {
  const double distance = line.dot(feature.seen.homogeneous());
  return distance * distance <=
         kGateOfOne * feature.sigma * feature.sigma * line.head<2>().squaredNorm();
}

/// The feature on the line that looks most alike, if it is clearly that one.
std::optional<int> matchOnLine(const Feature& feature, const Eigen::Vector3d& line,
                               const Keyframe& other, const std::vector<int>& candidates) {
  BestMatch best;
  for (const int i : candidates) {
    const auto& candidate = other.features[static_cast<std::size_t>(i)];
    if (std::abs(candidate.level - feature.level) > kLargestLevels || !isNear(line, candidate) ||
        turnBetween(candidate.angle, feature.angle) > kLargestRoll)
      continue;
    best.consider(static_cast<std::size_t>(i),
                  distanceOf(candidate.descriptor, feature.descriptor));
  }
  if (!best.isClear(kLargestMatchDistance, kMatchRatio)) return std::nullopt;
  return static_cast<int>(best.candidate);
}

}  // namespace

std::optional<Eigen::Vector3d> intersectionOf(const Eigen::Vector3d& centre_a,
                                              const Eigen::Vector3d& ray_a,
                                              const Eigen::Vector3d& centre_b,
                                              const Eigen::Vector3d& ray_b, double least_parallax) {
  const Eigen::Vector3d a = ray_a.normalized(), b = ray_b.normalized(), w = centre_b - centre_a;
  const double cosine = a.dot(b), determinant = 1.0 - cosine * cosine;
  const double least = std::sin(least_parallax);
  if (!(determinant > least * least)) return std::nullopt;
  const double along_a = (w.dot(a) - cosine * w.dot(b)) / determinant;
  const double along_b = (cosine * w.dot(a) - w.dot(b)) / determinant;
  if (along_a <= 0.0 || along_b <= 0.0) return std::nullopt;
  return 0.5 * (centre_a + along_a * a + centre_b + along_b * b);
}

std::vector<MapPoint> triangulate(const VisualMap& map, int now, int before) {
  const auto &a = map.keyframe(now), &b = map.keyframe(before);
  const Pair pair(a, b);
  std::vector<MapPoint> made;
  if (!pair.isWide()) return made;
  const auto candidates = freeFeatures(b);
  std::vector<char> is_taken(b.features.size(), 0);
  for (const int i : freeFeatures(a)) {
    const auto& feature = a.features[static_cast<std::size_t>(i)];
    const auto match = matchOnLine(feature, pair.lineOf(feature), b, candidates);
    if (!match || is_taken[static_cast<std::size_t>(*match)]) continue;
    const auto position = pair.pointOf(feature, b.features[static_cast<std::size_t>(*match)]);
    if (!position) continue;
    is_taken[static_cast<std::size_t>(*match)] = 1;
    MapPoint point;
    point.position = *position;
    point.descriptor = feature.descriptor;
    point.angle = feature.angle;
    const double distance = (*position - a.features.camera().centre(a.pose)).norm();
    point.size = distance * std::pow(kPyramidScale, feature.level) / a.features.focal();
    point.sightings = {{now, i}, {before, *match}};
    made.push_back(point);
  }
  return made;
}

Eigen::Matrix3d covarianceOf(const VisualMap& map, const MapPoint& point) {
  constexpr double kLeastInformation = 1e-3;  // [1/m^2], of a point that nothing determines
  Eigen::Matrix3d H = kLeastInformation * Eigen::Matrix3d::Identity();
  for (const auto& sighting : point.sightings) {
    const auto& keyframe = map.keyframe(sighting.keyframe);
    const double sigma = keyframe.features[static_cast<std::size_t>(sighting.feature)].sigma;
    Eigen::Matrix<double, 2, 3> J;
    if (keyframe.features.camera().project(keyframe.pose, point.position, nullptr, &J))
      H += J.transpose() * J / (sigma * sigma);
  }
  return H.inverse();
}

}  // namespace slam::mono_graph
