// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/grid_recogniser.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/geometry/one_place.hpp"
#include "slam_core/scan_matching/drawn_grid.hpp"

namespace slam::relocalisation {
namespace {

PoseEstimate estimateOf(const scan_matching::Match& match) {
  constexpr double kLeastSigma = 0.05, kLeastSigmaHeading = 0.02;  // [m], [rad]
  const Eigen::Vector3d least(kLeastSigma, kLeastSigma, kLeastSigmaHeading);
  PoseEstimate estimate{match.pose, symmetric(match.information.inverse())};
  estimate.covariance.diagonal() += least.cwiseAbs2();
  return estimate;
}

}  // namespace

GridRecogniser::GridRecogniser(const RelocalisationConfig& config,
                               const grid_map::GridMapConfig& grid,
                               const scan_matching::MatcherConfig& matcher)
    : config_(config),
      grid_config_(grid),
      matcher_(matcher),
      local_(grid, matcher, config.local_way),
      trials_(config.odds) {}

void GridRecogniser::see(const LaserScan& scan) {
  const bool is_kept = local_.take(scan);
  if (local_.hasBegunAnew()) {
    trials_.forget();
    confirmed_at_.reset();
    searched_ = 0.0;
  }
  if (is_kept && map_) {
    trials_.see(local_.kept().back(), map_->view(), matcher_);
    if (!confirmed_at_ && trials_.hasEnough()) is_due_ = true;
  }
  has_news_ = true;
}

void GridRecogniser::forget() {
  local_.forget();
  trials_.forget();
  confirmed_at_.reset();
  searched_ = 0.0;
  has_news_ = false;
}

bool GridRecogniser::canSearch(const OccupancyGrid& grid) {
  constexpr double kLargestEdge = 500.0;  // [m]; PlaceSearch has no memory for larger rasters
  return !grid.cells.empty() && grid.resolution * std::max(grid.width, grid.height) <= kLargestEdge;
}

void GridRecogniser::begin(const OccupancyGrid& grid, const std::optional<Pose2>& saved) {
  map_ = scan_matching::drawn(grid, grid_config_).map;
  box_ = Eigen::AlignedBox2d();
  box_.extend(grid.origin);
  box_.extend(grid.origin + grid.resolution * Eigen::Vector2d(grid.width, grid.height));
  expected_ = saved;
  is_carried_rarely_ = false;
  trials_.forget();
  confirmed_at_.reset();
  is_due_ = true;
}

void expect(GridRecogniser& recogniser, const Pose2& place) {
  recogniser.expected_ = place;
  recogniser.is_carried_rarely_ = true;
}

void GridRecogniser::end() {
  map_.reset();
  trials_.forget();
  confirmed_at_.reset();
}

bool GridRecogniser::isDue() const {
  if (!has_news_ || local_.isEmpty()) return false;
  return is_due_ || local_.way() - searched_ >= config_.search_distance;
}

std::optional<Recognition> GridRecogniser::find() {
  if (!isDue()) return std::nullopt;
  is_due_ = has_news_ = false;
  searched_ = local_.way();
  const auto scans = local_.together();
  const auto best = matcher_.bestAnywhere(map_->view(), scans, box_);
  if (!best) return Recognition();
  using Verdict = Recognition::Verdict;
  const auto verdict = weigh(*best, scans);
  if (verdict == Verdict::kNothing || verdict == Verdict::kAmbiguous)
    return Recognition{verdict, {}};
  if (verdict == Verdict::kConfirmed) trials_.keepOnly(best->pose, local_.robot());
  return Recognition{verdict, estimateOf(*best)};
}

/// A place on trial that the evidence speaks for may explain less of the scans than one that goes
/// on trial: walls and furniture may have been moved.
Recognition::Verdict GridRecogniser::weigh(const scan_matching::Match& best,
                                           const scan_matching::ScanLevels& scans) {
  using Verdict = Recognition::Verdict;
  constexpr double kExplained = 0.75, kExplainedOnTrial = 0.5;  // of all ends
  constexpr double kBetterThanRival = 0.1;                      // surplus, of all ends
  const auto& robot = local_.robot();
  const auto ends = static_cast<double>(scans[0].ends.size());
  const bool is_enough = trials_.isEnoughFor(best.pose, robot);
  if (best.agreement.agreeing <= (is_enough ? kExplainedOnTrial : kExplained) * ends)
    return Verdict::kNothing;
  const auto rival = matcher_.rivalAnywhere(best, map_->view(), scans, box_);
  const bool is_only =
      !rival || best.agreement.surplus() - rival->agreement.surplus() > kBetterThanRival * ends;
  trials_.lead(best, robot, local_.kept(), priorOf(best.pose));
  if (is_carried_rarely_) leadExpected();
  if (is_only)
    return trials_.isEnoughFor(best.pose, robot) ? Verdict::kConfirmed : Verdict::kLikely;
  trials_.lead(*rival, robot, local_.kept(), priorOf(rival->pose));
  return Verdict::kAmbiguous;
}

/// The place that motion has led to is a rival of any other one.
void GridRecogniser::leadExpected() {
  scan_matching::Match expected;
  expected.pose = *expected_ * local_.robot();
  trials_.lead(expected, local_.robot(), local_.kept(), PlaceTrials::Prior::kExpected);
}

PlaceTrials::Prior GridRecogniser::priorOf(const Pose2& place) const {
  if (isExpected(place)) return PlaceTrials::Prior::kExpected;
  return is_carried_rarely_ ? PlaceTrials::Prior::kUnlikely : PlaceTrials::Prior::kNone;
}

bool GridRecogniser::isExpected(const Pose2& place) const {
  return expected_ && areOnePlace(*expected_ * local_.robot(), place);
}

GridRecogniser::Test GridRecogniser::test(const Pose2& believed) {
  constexpr double kTested = 10.0;  // way after which a place has passed [m]
  auto& trial = trials_.only();
  if (trial.evidence() <= 0.0) return Test::kRefuted;
  trial.moveTo(believed * local_.robot().inverse());
  return local_.way() - *confirmed_at_ < kTested ? Test::kGoesOn : Test::kPassed;
}

}  // namespace slam::relocalisation
