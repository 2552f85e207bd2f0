// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/landmark_recogniser.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/geometry/one_place.hpp"
#include "slam_core/models/moved_pose.hpp"
#include "slam_core/relocalisation/map_repeats.hpp"
#include "slam_core/relocalisation/pose_agreement.hpp"

namespace slam::relocalisation {
namespace {

/// The observations as from a sensor at the base: all sensors share one SensorReach.
LandmarkObservationArray aroundBase(LandmarkObservationArray array) {
  for (auto& z : array.observations) {
    const Eigen::Vector2d place =
        array.sensor_pose.transform({z.range * std::cos(z.bearing), z.range * std::sin(z.bearing)});
    z.range = place.norm();
    z.bearing = std::atan2(place.y(), place.x());
  }
  return array;
}

/// Whether a search shows the place to which odometry leads. Maps and searches are uncertain, too.
bool isLedTo(const PoseEstimate& predicted, PoseEstimate place) {
  constexpr double kInAnyCase = 0.05;  // [m, rad]
  place.covariance += kInAnyCase * kInAnyCase * Eigen::Matrix3d::Identity();
  return areOnePlace(predicted.pose, place.pose) && agree(predicted, place);
}

}  // namespace

void LandmarkRecogniser::move(const Motion& motion) {
  local_.move(motion);
  rivals_.move(motion);
  if (candidate_) candidate_->robot = moved(candidate_->robot, motion);
}

void LandmarkRecogniser::see(const LandmarkObservationArray& array) {
  local_.see(array);
  reach_.see(aroundBase(array));
  has_news_ |= !array.observations.empty();
}

void LandmarkRecogniser::forget() {
  local_.forget();
  rivals_.forget();
  candidate_.reset();
  has_news_ = false;
}

void LandmarkRecogniser::begin(LandmarkMap map) {
  map_ = std::move(map);
  search_ = std::make_unique<association::ConstellationSearch>(map_, config_.outlier_share);
  repeats_.reset();
  rivals_.forget();
  candidate_.reset();
  has_news_ = true;
}

/// Landmarks that cannot be told apart stand in rows and at equal distances: constellations of them
/// look alike more often than those of landmarks that stand at random, so that their evidence
/// counts half.
double LandmarkRecogniser::leastLogOdds() const {
  constexpr double kNameless = 0.5;
  return std::log(config_.odds) / (has_ids_ ? 1.0 : kNameless);
}

Recognition::Verdict LandmarkRecogniser::verdictOn(const std::vector<association::Place>& places) {
  using Verdict = Recognition::Verdict;
  const double at_least = leastLogOdds();
  const auto& evidence = search_->evidence();
  if (!has_ids_) updateRivals(places);
  const double alone = evidence.logOddsOfOneAlone(local_.all());
  if (places.empty() || places[0].log_odds < alone + at_least) return Verdict::kNothing;
  const bool has_second = places.size() > 1 && places[0].log_odds < places[1].log_odds + at_least;
  return has_second || rivals_.hasOtherThan(places[0].robot.pose) ? Verdict::kAmbiguous
                                                                  : Verdict::kLikely;
}

/// A place of which the map has no second one may have one beyond the map, where the map repeats
/// itself.
void LandmarkRecogniser::updateRivals(const std::vector<association::Place>& places) {
  const double at_least = leastLogOdds();
  std::vector<Pose2> likely;
  for (const auto& place : places)
    if (place.log_odds >= at_least) likely.push_back(place.robot.pose);
  if (!likely.empty() && !repeats_) repeats_ = repeatsOf(map_, *search_, at_least);
  if (!likely.empty()) rivals_.add(likely, *repeats_);
  rivals_.check(search_->evidence(), local_.all(), reach_);
}

std::optional<Recognition> LandmarkRecogniser::find(Stamp stamp) {
  if (!std::exchange(has_news_, false)) return std::nullopt;
  const auto places = search_->placesOf(local_.all(), reach_);
  Recognition found{verdictOn(places), {}};
  if (!found.hasPlace()) {
    candidate_.reset();
    return found;
  }
  found.robot = places[0].robot;
  if (stays(found.robot, stamp)) found.verdict = Recognition::Verdict::kConfirmed;
  return found;
}

/// Whether the place has been the best one for long enough to be confirmed. Odometry has to lead
/// there from where it was found first: a camera that was turned by hand shows another motion.
bool LandmarkRecogniser::stays(const PoseEstimate& place, Stamp stamp) {
  constexpr int kLeastTimes = 3;
  if (!candidate_ || !isLedTo(candidate_->robot, place)) {
    candidate_ = Candidate{place, stamp};
    return false;
  }
  ++candidate_->times;
  return candidate_->times >= kLeastTimes &&
         seconds(stamp - candidate_->since) >= config_.confirmation;
}

}  // namespace slam::relocalisation
