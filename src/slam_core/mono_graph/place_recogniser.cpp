// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/place_recogniser.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/common/random.hpp"

namespace slam::mono_graph {
namespace {

constexpr std::size_t kCandidates = 4;
constexpr int kSamples = 80, kSampleSize = 3;
constexpr std::size_t kLeastConsensus = 12;
constexpr int kAlike = 50;                   // distance of descriptors that match
constexpr double kAlikeRatio = 0.8;          // to the second one
constexpr double kSearchRadius = 8.0;        // [px]
constexpr double kLeastShare = 0.25;         // of the points that were to be seen
constexpr double kElsewhere = 0.5;           // [m], distance of another place
constexpr double kRivalShare = 0.5;          // of the points that fit
constexpr double kMostSigma = 0.1;           // of a position that counts [m]
constexpr double kDependentPoints = 4.0;     // their positions come of the same keyframes
constexpr double kLeastLinkVariance = 1e-6;  // [m^2, rad^2]

/// The features of an image, found by their orientation.
class FeaturesByAngle {
 public:
  explicit FeaturesByAngle(const Features& features) {
    for (std::size_t i = 0; i < features.size(); ++i) sorted_.emplace_back(features[i].angle, i);
    std::sort(sorted_.begin(), sorted_.end());
  }

  /// Visits those that a camera which does not roll may see of a point.
  template <class Visit>
  void forEachNear(double angle, const Visit& visit) const {
    for (const double round : {-2.0 * M_PI, 0.0, 2.0 * M_PI}) {
      const std::pair<double, std::size_t> least(angle + round - kLargestRoll, 0);
      auto each = std::lower_bound(sorted_.begin(), sorted_.end(), least);
      for (; each != sorted_.end() && each->first <= angle + round + kLargestRoll; ++each)
        visit(each->second);
    }
  }

 private:
  std::vector<std::pair<double, std::size_t>> sorted_;
};

/// The features that look like the points of a keyframe, wherever they are in the image.
std::vector<PointMatch> alikeIn(const VisualMap& map, const Features& features,
                                const FeaturesByAngle& by_angle, int keyframe) {
  std::vector<PointMatch> matches;
  std::vector<int> taken(features.size(), 0);
  for (const int number : map.keyframe(keyframe).points) {
    if (number == kNoPoint) continue;
    const auto& point = map.point(number);
    BestMatch best;
    by_angle.forEachNear(point.angle, [&](std::size_t i) {
      best.consider(i, distanceOf(features[i].descriptor, point.descriptor));
    });
    if (!best.isClear(kAlike, kAlikeRatio)) continue;
    ++taken[best.candidate];
    matches.push_back({number, best.candidate});
  }
  const auto is_shared = [&](const PointMatch& match) { return taken[match.feature] > 1; };
  matches.erase(std::remove_if(matches.begin(), matches.end(), is_shared), matches.end());
  return matches;
}

}  // namespace

std::optional<Pose2> PlaceRecogniser::consensus(const VisualMap& map, const Features& features,
                                                int candidate,
                                                const std::vector<PoseSighting>& sightings) const {
  RandomStream random(seed_, queries_, static_cast<std::uint32_t>(candidate));
  const auto& camera = features.camera();
  std::optional<Pose2> best;
  std::size_t most = kLeastConsensus - 1;
  for (int i = 0; i < kSamples; ++i) {
    std::vector<PoseSighting> sample;
    for (int k = 0; k < kSampleSize; ++k)
      sample.push_back(sightings[std::min(
          sightings.size() - 1,
          static_cast<std::size_t>(random.uniform() * static_cast<double>(sightings.size())))]);
    const auto fit = fitPose(camera, sample, map.keyframe(candidate).pose, std::nullopt);
    if (!fit) continue;
    const std::size_t count = countFits(camera, sightings, fit->pose);
    if (count <= most) continue;
    most = count;
    best = fit->pose;
  }
  return best;
}

std::optional<RecognisedPlace> PlaceRecogniser::verify(const VisualMap& map,
                                                       const Features& features,
                                                       int candidate) const {
  const auto alike = alikeIn(map, features, FeaturesByAngle(features), candidate);
  if (alike.size() < kLeastConsensus) return std::nullopt;
  const auto start = consensus(map, features, candidate, sightingsOf(map, features, alike));
  if (!start) return std::nullopt;
  SearchLimits limits;
  limits.radius = kSearchRadius;
  const auto points = pointsSeenBy(map, keyframesAround(map, candidate));
  const auto found = searchPoints(map, points, features, *start, limits);
  const auto fit =
      fitPose(features.camera(), sightingsOf(map, features, found.matches), *start, std::nullopt);
  if (!fit || fit->count < least_points_ ||
      static_cast<double>(fit->count) < kLeastShare * static_cast<double>(found.expected.size()))
    return std::nullopt;
  RecognisedPlace place{candidate, fit->pose, kDependentPoints * fit->covariance, {}};
  place.covariance.diagonal().array() += kLeastLinkVariance;
  if (std::sqrt(place.covariance.topLeftCorner<2, 2>().trace()) > kMostSigma) return std::nullopt;
  for (std::size_t i = 0; i < found.matches.size(); ++i)
    if (fit->fits[i]) place.matches.push_back(found.matches[i]);
  return place;
}

std::optional<RecognisedPlace> PlaceRecogniser::find(const VisualMap& map, const Features& features,
                                                     const BagOfWords& bag,
                                                     const std::set<int>& left_out, double least) {
  ++queries_;
  std::vector<RecognisedPlace> places;
  for (const auto& candidate : index_.find(bag, left_out, kCandidates))
    if (candidate.similarity >= least)
      if (auto place = verify(map, features, candidate.keyframe)) places.push_back(*place);
  const auto best = std::max_element(
      places.begin(), places.end(),
      [](const auto& a, const auto& b) { return a.matches.size() < b.matches.size(); });
  if (best == places.end()) return std::nullopt;
  const bool has_rival = std::any_of(places.begin(), places.end(), [&](const auto& other) {
    const double apart = (other.pose.position() - best->pose.position()).norm();
    return apart > kElsewhere && static_cast<double>(other.matches.size()) >
                                     kRivalShare * static_cast<double>(best->matches.size());
  });
  return has_rival ? std::nullopt : std::optional<RecognisedPlace>(*best);
}

}  // namespace slam::mono_graph
