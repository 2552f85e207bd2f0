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
      local_(grid, matcher, config.local_way) {}

void GridRecogniser::see(const LaserScan& scan) {
  constexpr double kMost = 2.0;  // times what is enough, so that a refuted place is given up soon
  if (local_.take(scan) && trial_)
    trial_->see(local_.kept().back(), map_->view(), matcher_, kMost * enough());
  has_news_ = true;
}

void GridRecogniser::forget() {
  local_.forget();
  trial_.reset();
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
  saved_ = saved;
  trial_.reset();
  confirmed_at_.reset();
  is_due_ = true;
}

void GridRecogniser::end() {
  map_.reset();
  trial_.reset();
  confirmed_at_.reset();
}

double GridRecogniser::enough() const { return std::log(config_.odds); }

bool GridRecogniser::isDue() const {
  if (!has_news_ || local_.isEmpty()) return false;
  return is_due_ || local_.way() - searched_ >= config_.search_distance;
}

std::optional<Recognition> GridRecogniser::find() {
  if (!isDue()) return std::nullopt;
  is_due_ = has_news_ = false;
  searched_ = local_.way();
  const auto match = matcher_.recogniseAnywhere(map_->view(), local_.together(), box_);
  if (!match) return Recognition();
  using Verdict = Recognition::Verdict;
  return Recognition{confirms(match->pose) ? Verdict::kConfirmed : Verdict::kLikely,
                     estimateOf(*match)};
}

bool GridRecogniser::confirms(const Pose2& place) {
  const auto& robot = local_.robot();
  if (!trial_ || !areOnePlace(trial_->placeOf(robot), place)) {
    const bool is_saved = saved_ && areOnePlace(*saved_ * robot, place);
    trial_.emplace(place * robot.inverse(), local_.kept(), is_saved ? enough() : 0.0);
  }
  return trial_->evidence() >= enough();
}

GridRecogniser::Test GridRecogniser::test(const Pose2& believed) {
  constexpr double kTested = 10.0;  // way after which a place has passed [m]
  if (trial_->evidence() <= 0.0) return Test::kRefuted;
  trial_->moveTo(believed * local_.robot().inverse());
  return local_.way() - *confirmed_at_ < kTested ? Test::kGoesOn : Test::kPassed;
}

}  // namespace slam::relocalisation
