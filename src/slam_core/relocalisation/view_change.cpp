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
constexpr double kVague = 2.0;  ///< a landmark that is less certain is left out [m]
/// Probability that a lost robot sees, by chance, a landmark where there was one before.
constexpr double kByChance = 0.25;
/// Bound of the learnt rates, since errors of a view are not independent.
constexpr double kMostSure = 0.95;
/// Landmarks of a view are not independent: they count as so many at most.
constexpr double kMostIndependent = 8.0;
/// What is gone and what is new have to say the same: the sum of both is so many times the lesser
/// at most.
constexpr double kMostOfLesser = 3.0;
constexpr double kRemembered = 500.0;  ///< landmarks that a learnt rate goes by

/// The log-likelihood ratio of "lost" to "right" of a binomial number of hits.
double ratioOf(double hits, double misses, double learnt) {
  const double right = std::min(learnt, kMostSure);
  const double lost = std::min(kByChance, 0.5 * right);
  const double ratio =
      hits * std::log(lost / right) + misses * std::log((1.0 - lost) / (1.0 - right));
  return ratio * std::min(1.0, kMostIndependent / std::max(1.0, hits + misses));
}

bool isSame(const LocalLandmark& a, const LocalLandmark& b) {
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

void ViewChange::Rate::learn(const Rate& more) {
  yes += more.yes;
  no += more.no;
  const double excess = std::max(1.0, (yes + no) / kRemembered);
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
}

void ViewChange::add(const LandmarkObservationArray& array) {
  View view;
  view.sensor = array.sensor_pose;
  for (const auto& z : array.observations) {
    if (z.isLine()) continue;
    const auto seen = localised(z, array.sensor_pose);
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

/// How many landmarks of a view the other block shows as well, and how many not, of those that
/// all views of their own block show.
ViewChange::Rate ViewChange::seenAlso(const Views& block, std::size_t reference,
                                      const Views& other) {
  Rate rate{0.0, 0.0};
  for (const auto& landmark : block[reference].seen) {
    const auto shows = [&](const View& view) { return isIn(landmark, view.seen); };
    if (!std::all_of(block.begin(), block.end(), shows)) continue;
    ++(std::any_of(other.begin(), other.end(), shows) ? rate.yes : rate.no);
  }
  return rate;
}

double ViewChange::judge(const LandmarkObservationArray& array, bool is_right) {
  add(array);
  if (before_.size() < kBlock || !areNear()) return 0.0;
  const Rate kept = seenAlso(before_, kBlock - 1, after_);
  const Rate known = seenAlso(after_, 0, before_);
  const double gone = ratioOf(kept.yes, kept.no, kept_.share());
  const double other = ratioOf(known.yes, known.no, known_.share());
  if (is_right) {
    kept_.learn(kept);
    known_.learn(known);
  }
  const double lesser = std::min(gone, other);
  return lesser > 0.0 ? std::min(gone + other, kMostOfLesser * lesser) : 0.0;
}

}  // namespace slam::relocalisation
