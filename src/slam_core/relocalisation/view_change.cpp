// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/view_change.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/geometry/angle.hpp"

namespace slam::relocalisation {
namespace {

constexpr double kNear = 0.3, kNearTurn = 0.3;  ///< of views that are compared [m], [rad]
constexpr std::size_t kFewest = 4;              ///< landmarks of a view to compare with
/// So many views have to be changed, since a single image may be blurred.
constexpr int kPersistent = 3;
/// Probability that a lost robot takes an observation for a landmark, or sees one again, by chance.
constexpr double kByChance = 0.25;
/// Bound of the learnt rates, since errors of a view are not independent.
constexpr double kMostSure = 0.9;
/// Observations of a view are not independent: they count as so many at most.
constexpr double kMostIndependent = 8.0;
constexpr double kRemembered = 500.0;  ///< observations that a learnt rate goes by

/// The log-likelihood ratio of "lost" to "right" of a binomial number of hits.
double ratioOf(double hits, double misses, double learnt) {
  const double right = std::min(learnt, kMostSure);
  const double lost = std::min(kByChance, 0.5 * right);
  const double ratio =
      hits * std::log(lost / right) + misses * std::log((1.0 - lost) / (1.0 - right));
  return ratio * std::min(1.0, kMostIndependent / std::max(1.0, hits + misses));
}

}  // namespace

void ViewChange::Rate::learn(const Rate& more) {
  yes += more.yes;
  no += more.no;
  const double excess = std::max(1.0, (yes + no) / kRemembered);
  yes /= excess;
  no /= excess;
}

bool ViewChange::isNear(const Pose2& robot) const {
  if (!robot_) return false;
  const Pose2 step = robot_->between(robot);
  return step.position().norm() < kNear && std::abs(wrapAngle(step.theta())) < kNearTurn;
}

std::size_t ViewChange::keptOf(const View& view) const {
  return static_cast<std::size_t>(
      std::count_if(before_.known.begin(), before_.known.end(),
                    [&](LandmarkId id) { return view.known.count(id) > 0; }));
}

double ViewChange::evidenceOf(const View& view) const {
  const auto kept = static_cast<double>(keptOf(view));
  const double gone =
      ratioOf(kept, static_cast<double>(before_.known.size()) - kept, kept_.share());
  const double other = ratioOf(static_cast<double>(view.known.size()),
                               static_cast<double>(view.others), known_.share());
  return gone > 0.0 && other > 0.0 ? gone + other : 0.0;
}

void ViewChange::note(const View& view) {
  const auto kept = static_cast<double>(keptOf(view));
  new_kept_.learn({kept, static_cast<double>(before_.known.size()) - kept});
  new_known_.learn({static_cast<double>(view.known.size()), static_cast<double>(view.others)});
}

/// Later views are compared with this one. @return the evidence of the views until then
double ViewChange::begin(const View& view, const Pose2& robot) {
  before_ = view;
  robot_ = robot;
  new_kept_ = new_known_ = {0.0, 0.0};
  changed_ = 0;
  return std::exchange(evidence_, 0.0);
}

double ViewChange::judge(const View& view, const Pose2& robot, bool is_right) {
  const bool is_comparable = isNear(robot) && before_.known.size() >= kFewest;
  const double evidence = is_comparable ? evidenceOf(view) : 0.0;
  if (is_comparable) note(view);
  evidence_ = changed_ == 0 ? evidence : std::min(evidence_, evidence);
  ++changed_;
  if (evidence > 0.0 && changed_ < kPersistent) return 0.0;
  if (is_comparable && is_right && evidence == 0.0) {
    kept_.learn(new_kept_);
    known_.learn(new_known_);
  }
  return begin(view, robot);
}

}  // namespace slam::relocalisation
