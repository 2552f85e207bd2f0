// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/tracker.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "slam_core/common/sorted_unique.hpp"
#include "slam_core/geometry/angle.hpp"

namespace slam::mono_graph {
namespace {

constexpr double kNearRadius = 4.0, kLeastRadius = 8.0, kMostRadius = 320.0;  // [px]
constexpr double kTypicalDepth = 1.5;  // [m], at which an error of position moves points
constexpr double kSigmas = 3.0;
constexpr double kLargestNis = 16.27;  // chi-square: 0.999 with three degrees of freedom
constexpr std::size_t kLeastMatches = 6;
constexpr std::size_t kMostNeighbours = 10;
constexpr int kBeforeAndAfter = 2;

/// @return the standard deviation of a predicted pixel [px]
double predictionSigma(const PosePrior& prior, double focal) {
  const double position = std::sqrt(prior.covariance.topLeftCorner<2, 2>().trace());
  const double heading = std::sqrt(prior.covariance(2, 2));
  return focal * (position / kTypicalDepth + heading);
}

double radiusOf(double sigma) {
  return std::clamp(kLeastRadius + kSigmas * sigma, kLeastRadius, kMostRadius);
}

/// @return the probability of an error within a radius, along one direction mostly
double probabilityWithin(double radius, double sigma) {
  return std::erf(radius / (M_SQRT2 * sigma));
}

void take(const PointMatches& found, const FittedPose& fit, TrackedView& view) {
  view.pose = fit.pose;
  view.information = fit.information;
  view.covariance = fit.covariance;
  view.expected = found.expected;
  view.matches.clear();
  view.rejected.clear();
  for (std::size_t i = 0; i < found.matches.size(); ++i)
    (fit.fits[i] ? view.matches : view.rejected).push_back(found.matches[i]);
}

/// The squared distance from what odometry predicted, in its standard deviations.
double nisOf(const PosePrior& prior, const Pose2& pose) {
  Eigen::Vector3d innovation = pose.vector() - prior.pose.vector();
  innovation.z() = wrapAngle(innovation.z());
  return innovation.dot(prior.covariance.ldlt().solve(innovation));
}

void reject(const PosePrior& prior, TrackedView& view) {
  view.pose = prior.pose;
  view.covariance = prior.covariance;
  view.information.setZero();
  view.rejected.insert(view.rejected.end(), view.matches.begin(), view.matches.end());
  view.matches.clear();
}

}  // namespace

std::vector<PoseSighting> sightingsOf(const VisualMap& map, const Features& features,
                                      const std::vector<PointMatch>& matches) {
  std::vector<PoseSighting> sightings;
  for (const auto& match : matches) {
    const auto& feature = features[match.feature];
    sightings.push_back({map.point(match.point).position, feature.seen, feature.sigma});
  }
  return sightings;
}

TrackedView track(const VisualMap& map, const Features& features, const PosePrior& prior,
                  const std::vector<int>& keyframes) {
  TrackedView view;
  view.pose = prior.pose;
  view.covariance = prior.covariance;
  const auto points = pointsSeenBy(map, keyframes);
  const double sigma = predictionSigma(prior, features.focal());
  view.in_reach = probabilityWithin(radiusOf(sigma), sigma);
  SearchLimits limits;
  for (const double radius : {radiusOf(sigma), kNearRadius}) {
    limits.radius = radius;
    const auto found = searchPoints(map, points, features, view.pose, limits);
    if (view.expected.empty()) view.expected = found.expected;
    if (found.matches.size() < kLeastMatches) {
      if (view.matches.empty() && view.rejected.empty()) view.unfitted = found.matches;
      break;
    }
    const auto fit =
        fitPose(features.camera(), sightingsOf(map, features, found.matches), view.pose, prior);
    if (!fit) break;
    take(found, *fit, view);
  }
  if (nisOf(prior, view.pose) > kLargestNis) reject(prior, view);
  return view;
}

std::optional<int> referenceOf(const VisualMap& map, const std::vector<PointMatch>& matches) {
  std::map<int, int> seen;
  for (const auto& match : matches)
    for (const auto& sighting : map.point(match.point).sightings) ++seen[sighting.keyframe];
  const auto best = std::max_element(
      seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return best == seen.end() ? std::nullopt : std::optional<int>(best->first);
}

std::vector<int> keyframesAround(const VisualMap& map, int keyframe) {
  auto around = neighboursOf(map, keyframe, kMostNeighbours);
  const int last = static_cast<int>(map.keyframes().size()) - 1;
  for (int i = keyframe - kBeforeAndAfter; i <= keyframe + kBeforeAndAfter; ++i)
    if (i >= 0 && i <= last) around.push_back(i);
  return sortedUnique(std::move(around));
}

}  // namespace slam::mono_graph
