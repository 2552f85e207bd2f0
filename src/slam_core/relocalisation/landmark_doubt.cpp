// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/landmark_doubt.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/models/independence.hpp"

namespace slam::relocalisation {
namespace {

constexpr double kViewEdge = 2.0, kViewAngle = M_PI / 4;  // [m], [rad]
/// Two steps are independent if they are apart by this distance, this turn, or this time, in which
/// people walk on.
constexpr Independence kViews{0.4, 0.6, 4.0};
/// Probability that a lost robot sees, by chance, a landmark where one is expected.
constexpr double kByChance = 0.25;
/// Landmarks are not independent, since an object that hides one often hides others: they count as
/// so many at most.
constexpr double kMostIndependent = 6.0;
/// Bound of the evidence of one step.
constexpr double kMostOfAStep = 3.0;
/// Bound of the evidence of one missing landmark, which may have been moved.
constexpr double kMostOfOne = 3.0;
/// Log-likelihood ratio by which a step in which most observations fit is evidence for "right".
constexpr double kOfWhatFits = 1.0;
/// The same of a step of a robot that explores, in which no landmark is expected: a healthy one is
/// not to be in doubt for ever since a view of it has changed.
constexpr double kOfNothingExpected = 0.2;
constexpr double kMostDoubt = 2.0;     ///< bound of the sum, relative to the threshold
constexpr double kRemembered = 200.0;  ///< expected landmarks that the learnt probability goes by

/// The landmarks of the map that observations were taken for, or that they have begun.
std::set<LandmarkId> landmarksOf(const std::vector<AssociatedObservation>& associations,
                                 TakenFor what) {
  std::set<LandmarkId> landmarks;
  for (const auto& observation : associations)
    if (observation.taken_for == what) landmarks.insert(observation.landmark);
  return landmarks;
}

int countOfBoth(const std::set<LandmarkId>& a, const std::set<LandmarkId>& b) {
  return static_cast<int>(
      std::count_if(a.begin(), a.end(), [&](LandmarkId id) { return b.count(id) > 0; }));
}

}  // namespace

LandmarkDoubt::Cell LandmarkDoubt::cellOf(const Pose2& robot) {
  return {std::lround(robot.x() / kViewEdge), std::lround(robot.y() / kViewEdge),
          std::lround(wrapAngle(robot.theta()) / kViewAngle)};
}

void LandmarkDoubt::move(const Motion& motion) {
  for (auto& [frame, sensor] : sensors_) sensor.move(motion);
}

void LandmarkDoubt::see(const LandmarkObservationArray& array) {
  change_ += sensors_[array.sensor_frame].judge(array, isRight(), ids_);
  if (ids_ == LocalLandmarks::Ids::kKnown)
    for (const auto& z : array.observations) seen_.insert(z.id);
}

void LandmarkDoubt::judge(const UpdateStatistics& statistics, const Pose2& robot, Stamp stamp) {
  if (ids_ == LocalLandmarks::Ids::kKnown) return judgeByIds(statistics, robot, stamp);
  const double change = std::exchange(change_, 0.0);
  if (statistics.associations.empty()) return;
  const auto seen = landmarksOf(statistics.associations, TakenFor::kLandmark);
  const auto expected = expectedAt(robot, seen);
  const double weight = weightOf(robot, stamp);
  const auto fitting = static_cast<std::size_t>(countOfBoth(seen, trusted_));
  const bool fits = 2 * fitting >= statistics.associations.size();
  const double evidence = evidenceOf(expected, seen);
  // where most observations fit, the missing landmarks are taken for hidden, not the robot for lost
  const double otherwise = expected.empty() ? -kOfNothingExpected : evidence;
  sum_ += weight * (fits ? std::min(0.0, evidence) - kOfWhatFits : otherwise);
  sum_ += change;
  sum_ = std::clamp(sum_, 0.0, kMostDoubt * kThreshold);
  if (!fits) noteMissing(expected, seen, weight * evidence);
  if (isRight()) {
    learn(expected, seen, weight);
    views_[cellOf(robot)].insert(seen.begin(), seen.end());
  }
  auto mapped = landmarksOf(statistics.associations, TakenFor::kNew);
  mapped.insert(seen.begin(), seen.end());
  note(mapped);
  robot_ = robot;
  stamp_ = stamp;
}

void LandmarkDoubt::judgeByIds(const UpdateStatistics& statistics, const Pose2& robot,
                               Stamp stamp) {
  const double change = std::exchange(change_, 0.0);
  const auto seen = std::exchange(seen_, {});
  if (seen.empty()) return;
  const auto& innovations = statistics.innovations;
  const auto fitting = std::count_if(innovations.begin(), innovations.end(), [&](const auto& each) {
    return each.used && isTrusted(each.id);
  });
  const bool fits = 2 * static_cast<std::size_t>(fitting) >= seen.size();
  sum_ += change - weightOf(robot, stamp) * (fits ? kOfWhatFits : kOfNothingExpected);
  sum_ = std::clamp(sum_, 0.0, kMostDoubt * kThreshold);
  note(seen);
  robot_ = robot;
  stamp_ = stamp;
}

/// The trusted landmarks that were seen from this cell before, without those that have been missing
/// for so long that they are no new evidence.
LandmarkDoubt::Ids LandmarkDoubt::expectedAt(const Pose2& robot, const Ids& seen) {
  Ids expected;
  for (const auto id : views_[cellOf(robot)])
    if (isTrusted(id) && (seen.count(id) > 0 || missing_[id] < kMostOfOne)) expected.insert(id);
  return expected;
}

/// @param evidence for "lost", which is divided among the missing landmarks
void LandmarkDoubt::noteMissing(const Ids& expected, const Ids& seen, double evidence) {
  const int missing = static_cast<int>(expected.size()) - countOfBoth(expected, seen);
  for (const auto id : expected)
    if (seen.count(id) == 0) missing_[id] += std::max(0.0, evidence) / missing;
}

double LandmarkDoubt::weightOf(const Pose2& robot, Stamp stamp) const {
  return robot_ ? kViews.weightOf(robot_->between(robot), stamp - stamp_) : 1.0;
}

/// The log-likelihood ratio of "lost" to "right". The number of expected landmarks that are seen is
/// binomial, with the probability of a sighting by chance or with the learnt one.
double LandmarkDoubt::evidenceOf(const Ids& expected, const Ids& seen) const {
  if (expected.empty()) return 0.0;
  const double right = hits_ / (hits_ + misses_);
  const double lost = std::min(kByChance, 0.5 * right);
  const auto count = static_cast<double>(expected.size());
  const double hits = countOfBoth(expected, seen);
  const double ratio =
      hits * std::log(lost / right) + (count - hits) * std::log((1.0 - lost) / (1.0 - right));
  return std::clamp(ratio * std::min(1.0, kMostIndependent / count), -kMostOfAStep, kMostOfAStep);
}

void LandmarkDoubt::learn(const Ids& expected, const Ids& seen, double weight) {
  const double hits = countOfBoth(expected, seen);
  hits_ += weight * hits;
  misses_ += weight * (static_cast<double>(expected.size()) - hits);
  const double excess = std::max(1.0, (hits_ + misses_) / kRemembered);
  hits_ /= excess;
  misses_ /= excess;
}

/// Landmarks that were mapped in doubt are trusted when the robot counts as right again. A change
/// of the view is evident three views after it, and those with ids that came with it must not be
/// trusted until then.
void LandmarkDoubt::note(const Ids& mapped) {
  constexpr int kViewsOfAChange = 6;
  const int last =
      ids_ == LocalLandmarks::Ids::kKnown ? kViewsOfAChange * static_cast<int>(sensors_.size()) : 0;
  for (const auto id : mapped)
    if (!isTrusted(id)) young_.emplace(id, 0);
  if (sum_ <= 0.0) missing_.clear();
  if (!isRight()) return;
  for (auto young = young_.begin(); young != young_.end();) {
    const bool is_trusted = young->second++ >= last;
    if (is_trusted) trusted_.insert(young->first);
    young = is_trusted ? young_.erase(young) : std::next(young);
  }
}

std::vector<LandmarkId> LandmarkDoubt::doubtful() const {
  std::vector<LandmarkId> ids;
  for (const auto& [id, steps] : young_) ids.push_back(id);
  return ids;
}

void LandmarkDoubt::know(const LandmarkMap& map) {
  for (const auto& landmark : map) trusted_.insert(landmark.id);
}

void LandmarkDoubt::relocate() {
  sum_ = change_ = 0.0;
  missing_.clear();
  seen_.clear();
  young_.clear();
  robot_.reset();
  for (auto& [frame, sensor] : sensors_) sensor.forgetBefore();
}

void LandmarkDoubt::forget() { *this = LandmarkDoubt(ids_); }

}  // namespace slam::relocalisation
