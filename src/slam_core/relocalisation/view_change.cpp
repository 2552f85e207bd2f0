// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/view_change.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/association/descriptor_map.hpp"

namespace slam::relocalisation {
namespace {

constexpr std::size_t kBlock = 3;       ///< views that are compared with as many before them
constexpr double kSamePlace = 13.8;     ///< 0.999 of chi-square with two degrees of freedom
constexpr double kRightPasses = 0.999;  ///< of the descriptors of one landmark
/// Of views that are compared [m], [1] of the mean range, [rad].
constexpr double kNear = 0.3, kNearOfRange = 0.15, kNearTurn = 0.5;
/// Within these the sensor stands still between two views [m], [rad].
constexpr double kStill = 0.005, kStillTurn = 0.005;
/// The newest views from one place, this many, have not been learnt from yet. A robot that is lost
/// is reported after fewer of them.
constexpr std::size_t kDoubtful = 10;
constexpr double kVague = 2.0;  ///< a landmark that is less certain is left out [m]
/// Landmarks of a view are not independent: they count as so many at most.
constexpr double kMostIndependentInView = 8.0;
/// What is gone and what is new have to say the same: the sum of both is so many times the lesser
/// at most.
constexpr double kMostOfLesser = 3.0;
constexpr double kRememberedInView = 500.0;  ///< landmarks that a learnt rate goes by

/// @param gone, other evidence of what is gone and of what is new
double bothOf(double gone, double other) {
  const double lesser = std::min(gone, other);
  return lesser > 0.0 ? std::min(gone + other, kMostOfLesser * lesser) : 0.0;
}

bool isSame(const LocalLandmark& a, const LocalLandmark& b) {
  if (a.id != kUnknownId || b.id != kUnknownId) return a.id == b.id;
  const Eigen::Vector2d d = a.position - b.position;
  const Eigen::Matrix2d S = a.covariance + b.covariance;
  return d.squaredNorm() < kSamePlace * S.trace() && d.dot(S.inverse() * d) < kSamePlace &&
         association::fitOf(a.descriptor, b.descriptor, kRightPasses).passes;
}

bool isIn(const LocalLandmark& landmark, const std::vector<LocalLandmark>& seen) {
  return std::any_of(seen.begin(), seen.end(),
                     [&](const LocalLandmark& other) { return isSame(landmark, other); });
}

}  // namespace

/// The log-likelihood ratio of "lost" to "right" of a binomial number of landmarks.
double ViewChange::ratioOf(const Rate& seen, const Rate& usual, const Odds& odds) {
  const double right = std::min(usual.share(), odds.most_sure);
  const double lost = std::min(odds.by_chance, 0.5 * right);
  const double ratio =
      seen.yes * std::log(lost / right) + seen.no * std::log((1.0 - lost) / (1.0 - right));
  return ratio * std::min(1.0, kMostIndependentInView / std::max(1.0, seen.yes + seen.no));
}

void ViewChange::Rate::learn(const Rate& more) {
  yes += more.yes;
  no += more.no;
  const double excess = std::max(1.0, (yes + no) / kRememberedInView);
  yes /= excess;
  no /= excess;
}

void ViewChange::move(const Motion& motion) {
  const Pose2 back = motion.increment.inverse();
  for (auto* const views : {&before_, &after_})
    for (auto& view : *views) {
      relocalisation::move(motion, view.seen);
      view.sensor = back * view.sensor;
    }
}

void ViewChange::forgetBefore() {
  before_.clear();
  after_.clear();
  of_late_.clear();
}

/// The range follows the 0.95 quantile by stochastic approximation (Robbins and Monro 1951).
void ViewChange::Reach::add(const LandmarkObservation& z) {
  constexpr double kNearer = 0.95, kStep = 0.1;  // [1], [m]
  least = std::min(least, z.bearing);
  most = std::max(most, z.bearing);
  far += kStep * (z.range > far ? kNearer : kNearer - 1.0);
}

bool ViewChange::Reach::covers(const Eigen::Vector2d& place) const {
  constexpr double kEdge = 0.15;      // of all bearings, and of the range
  constexpr double kAllAround = 5.5;  // [rad]
  if (place.norm() > (1.0 - kEdge) * far) return false;
  const double width = most - least, bearing = std::atan2(place.y(), place.x());
  if (width > kAllAround) return true;
  return bearing > least + kEdge * width && bearing < most - kEdge * width;
}

void ViewChange::add(const LandmarkObservationArray& array, LocalLandmarks::Ids ids) {
  View view;
  view.sensor = array.sensor_pose;
  for (const auto& z : array.observations) {
    if (z.isLine()) continue;
    auto seen = localised(z, array.sensor_pose);
    if (ids == LocalLandmarks::Ids::kKnown) seen.id = z.id;
    reach_.add(z);
    if (seen.position.allFinite() && seen.covariance.trace() < kVague * kVague)
      view.seen.push_back(seen);
  }
  after_.push_back(std::move(view));
  if (after_.size() <= kBlock) return;
  before_.push_back(std::move(after_.front()));
  after_.erase(after_.begin());
  if (before_.size() > kBlock) before_.erase(before_.begin());
}

/// Whether the sensor has moved so little between the blocks that it sees the same landmarks.
bool ViewChange::areNear() const {
  const auto& before = before_.back();
  const Pose2 step = before.sensor.between(after_.back().sensor);
  double sum = 0.0;
  for (const auto& landmark : before.seen)
    sum += (landmark.position - before.sensor.position()).norm();
  const double mean = sum / std::max(1.0, static_cast<double>(before.seen.size()));
  return step.position().norm() < std::max(kNear, kNearOfRange * mean) &&
         std::abs(step.theta()) < kNearTurn;
}

/// Whether the sensor stood still from each view of the block before to that of the one after.
bool ViewChange::areAtOnePlace() const {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const Pose2 step = before_[i].sensor.between(after_[i].sensor);
    if (step.position().norm() >= kStill || std::abs(step.theta()) >= kStillTurn) return false;
  }
  return true;
}

/// Whether all views of a block would show a landmark that is told apart by its id.
bool ViewChange::isInView(const LocalLandmark& landmark, const Views& block) const {
  if (landmark.id == kUnknownId) return true;
  return std::all_of(block.begin(), block.end(), [&](const View& view) {
    return reach_.covers(view.sensor.inverse().transform(landmark.position));
  });
}

/// How many landmarks of a view the other block shows as well, and how many not, of those that
/// all views of their own block show (with ids most of them) and the other one's would.
ViewChange::Rate ViewChange::seenAlso(const Views& block, std::size_t reference,
                                      const Views& other) const {
  Rate rate{0.0, 0.0};
  for (const auto& landmark : block[reference].seen) {
    const auto shows = [&](const View& view) { return isIn(landmark, view.seen); };
    const auto needed = landmark.id == kUnknownId ? kBlock : kBlock - 1;
    const auto shown = static_cast<std::size_t>(std::count_if(block.begin(), block.end(), shows));
    if (shown < needed || !isInView(landmark, other)) continue;
    ++(std::any_of(other.begin(), other.end(), shows) ? rate.yes : rate.no);
  }
  return rate;
}

double ViewChange::judge(const LandmarkObservationArray& array, bool is_right,
                         LocalLandmarks::Ids ids) {
  if (!is_right) of_late_.clear();
  add(array, ids);
  if (before_.size() < kBlock || !areNear()) return 0.0;
  constexpr Odds kOfIds{0.002, 0.98}, kOfPlaces{0.25, 0.95};
  const auto& odds = ids == LocalLandmarks::Ids::kKnown ? kOfIds : kOfPlaces;
  const double sudden = judgeBlocks(is_right, odds);
  const bool may_drift = ids == LocalLandmarks::Ids::kIgnored && areAtOnePlace();
  return may_drift ? std::max(sudden, judgeDrift(is_right, odds)) : sudden;
}

double ViewChange::judgeBlocks(bool is_right, const Odds& odds) {
  const Rate kept = seenAlso(before_, kBlock - 1, after_);
  const Rate known = seenAlso(after_, 0, before_);
  const double evidence = bothOf(ratioOf(kept, kept_, odds), ratioOf(known, known_, odds));
  if (is_right) {
    kept_.learn(kept);
    known_.learn(known);
  }
  return evidence;
}

/// The blocks show nothing of this, since a landmark that drifts is not at the same place in all
/// views of its own block. So views are compared one by one, and all of a block have to say the
/// same: single ones may be blurred.
double ViewChange::judgeDrift(bool is_right, const Odds& odds) {
  double evidence = INFINITY;
  for (std::size_t i = 0; i < kBlock; ++i) {
    const Rate kept = sharedBy(before_[i], after_[i]);
    const Rate known = sharedBy(after_[i], before_[i]);
    evidence =
        std::min(evidence, bothOf(ratioOf(kept, still_, odds), ratioOf(known, still_, odds)));
  }
  learnStill(is_right);
  return evidence / static_cast<double>(kBlock);
}

void ViewChange::learnStill(bool is_right) {
  if (!is_right) return;
  of_late_.push_back(sharedBy(before_.back(), after_.back()));
  if (of_late_.size() <= kDoubtful) return;
  still_.learn(of_late_.front());
  of_late_.pop_front();
}

/// Counts the landmarks of a view that the other one shows as well, and those that it does not.
ViewChange::Rate ViewChange::sharedBy(const View& view, const View& other) {
  Rate rate{0.0, 0.0};
  for (const auto& landmark : view.seen) ++(isIn(landmark, other.seen) ? rate.yes : rate.no);
  return rate;
}

}  // namespace slam::relocalisation
