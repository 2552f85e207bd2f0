// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/shared_landmarks.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "slam_core/association/constellation_search.hpp"
#include "slam_core/graph_slam/session_graph.hpp"

namespace slam::graph_slam {
namespace {

using Index = Session::Index;

/// The covariances of the landmarks of a session.
class Marginals {
 public:
  explicit Marginals(const Session& session) : session_(session), graph_(optimizerOf(session)) {
    graph_.update({});
  }
  Eigen::Matrix2d of(std::size_t landmark) const { return graph_.covariance({keyOf(landmark)}); }
  /// The covariance belongs to the vector from one landmark to the other.
  Eigen::Matrix2d ofDifference(std::size_t from, std::size_t to) const {
    const Eigen::MatrixXd P = graph_.covariance({keyOf(from), keyOf(to)});
    const Eigen::Matrix2d cross = P.block<2, 2>(0, 2);
    return P.block<2, 2>(0, 0) + P.block<2, 2>(2, 2) - cross - cross.transpose();
  }
  /// The landmarks that are not retired; their ids are their numbers in the session.
  LandmarkMap map() const {
    LandmarkMap map;
    for (std::size_t i = 0; i < session_.landmarks.size(); ++i)
      if (const auto& landmark = session_.landmarks[i]; !landmark.is_retired)
        map.push_back({static_cast<LandmarkId>(i), landmark.position, of(i), LandmarkKind::kPoint,
                       0.0, LineExtent(), landmark.descriptor});
    return map;
  }

 private:
  graph::Key keyOf(std::size_t landmark) const {
    return keyOfLandmark(session_, static_cast<Index>(landmark));
  }
  const Session& session_;
  graph::Optimizer graph_;
};

SharedLandmark sharedOf(const Landmark& first, const Landmark& second) {
  return {static_cast<std::size_t>(first.id),
          static_cast<std::size_t>(second.id),
          first.position,
          second.position,
          first.covariance,
          second.covariance};
}

/// The landmark of a map that is nearest to a place, up to a limit; null where there is none.
const Landmark* nearestTo(const Eigen::Vector2d& place, const LandmarkMap& map) {
  constexpr double kFarthest = 1.0;  // from one drive to the other [m]
  const Landmark* nearest = nullptr;
  double least = kFarthest;
  for (const auto& landmark : map) {
    const double distance = (landmark.position - place).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = &landmark;
  }
  return nearest;
}

/// A landmark and those around it, in a frame at its place with the axes of the map.
std::vector<association::LocalLandmark> around(const Landmark& middle, const LandmarkMap& map,
                                               const Marginals& marginals) {
  constexpr double kReach = 25.0;       // [m]
  constexpr double kLeastSigma = 0.02;  // by which two maps may differ in any case [m]
  std::vector<association::LocalLandmark> found;
  for (const auto& landmark : map) {
    const Eigen::Vector2d place = landmark.position - middle.position;
    if (place.norm() > kReach) continue;
    Eigen::Matrix2d P = kLeastSigma * kLeastSigma * Eigen::Matrix2d::Identity();
    if (landmark.id != middle.id)
      P += marginals.ofDifference(static_cast<std::size_t>(middle.id),
                                  static_cast<std::size_t>(landmark.id));
    found.push_back({kUnknownId, place, P, landmark.descriptor});
  }
  return found;
}

/// The most likely place of a constellation, where it is beyond doubt.
std::optional<association::Place> placeBeyondDoubt(
    const association::ConstellationSearch& search,
    const std::vector<association::LocalLandmark>& constellation) {
  constexpr std::size_t kLeastMatches = 5;
  const double beyond_doubt = std::log(1e6);
  const auto places = search.placesOf(constellation);
  if (places.empty() || places[0].matches < kLeastMatches || places[0].log_odds < beyond_doubt)
    return std::nullopt;
  if (places.size() > 1 && places[0].log_odds < places[1].log_odds + beyond_doubt)
    return std::nullopt;
  return places[0];
}

/// @return T_map_other, of the map frames
std::optional<Pose2> foundIn(const LandmarkMap& map, const LandmarkMap& other,
                             const Marginals& of_other) {
  constexpr double kOutlierShare = 0.3;  // the drives need not have seen the same
  constexpr std::size_t kMostMiddles = 10;
  const association::ConstellationSearch search(map, kOutlierShare);
  std::optional<Pose2> found;
  double best = -std::numeric_limits<double>::infinity();
  for (const auto i : evenlyChosen(kMostMiddles, other.size())) {
    const auto place = placeBeyondDoubt(search, around(other[i], other, of_other));
    if (!place || place->log_odds <= best) continue;
    best = place->log_odds;
    const Pose2 other_middle(other[i].position.x(), other[i].position.y(), 0.0);
    found = place->robot.pose * other_middle.inverse();
  }
  return found;
}

}  // namespace

std::vector<SharedLandmark> sharedById(const Session& first, const Session& second) {
  std::unordered_map<LandmarkId, std::size_t> numbers;  // looked up only, never iterated
  for (std::size_t i = 0; i < first.landmarks.size(); ++i)
    if (!first.landmarks[i].is_retired) numbers[first.landmarks[i].id] = i;
  std::vector<SharedLandmark> shared;
  for (std::size_t i = 0; i < second.landmarks.size(); ++i) {
    const auto known = numbers.find(second.landmarks[i].id);
    if (known == numbers.end() || second.landmarks[i].is_retired) continue;
    SharedLandmark landmark;
    landmark.first = known->second;
    landmark.second = i;
    landmark.in_first = first.landmarks[known->second].position;
    landmark.in_second = second.landmarks[i].position;
    shared.push_back(landmark);
  }
  if (shared.empty()) return shared;
  const Marginals in_first(first), in_second(second);
  for (auto& landmark : shared) {
    landmark.first_covariance = in_first.of(landmark.first);
    landmark.second_covariance = in_second.of(landmark.second);
  }
  return shared;
}

std::vector<SharedLandmark> sharedByPlace(const Session& first, const Session& second,
                                          const Pose2& first_second) {
  const auto in_first = Marginals(first).map(), in_second = Marginals(second).map();
  std::vector<SharedLandmark> shared;
  for (const auto& landmark : in_second) {
    const auto* nearest = nearestTo(first_second.transform(landmark.position), in_first);
    if (nearest == nullptr) continue;
    if (nearestTo(first_second.inverse().transform(nearest->position), in_second) == &landmark)
      shared.push_back(sharedOf(*nearest, landmark));
  }
  return shared;
}

std::optional<Pose2> constellationMeeting(const Session& first, const Session& second) {
  if (first.landmarks.empty() || second.landmarks.empty()) return std::nullopt;
  const Marginals of_first(first), of_second(second);
  const auto in_first = of_first.map(), in_second = of_second.map();
  if (in_second.size() <= in_first.size()) return foundIn(in_first, in_second, of_second);
  const auto second_first = foundIn(in_second, in_first, of_first);
  if (!second_first) return std::nullopt;
  return second_first->inverse();
}

}  // namespace slam::graph_slam
