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

constexpr double kConfirmingWay = 1.0;  // driven between two searches that confirm each other [m]

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
  local_.take(scan);
  has_news_ = true;
}

void GridRecogniser::forget() {
  local_.forget();
  first_.reset();
  searched_ = 0.0;
  has_news_ = false;
}

bool GridRecogniser::canSearch(const OccupancyGrid& grid) {
  constexpr double kLargestEdge = 500.0;  // [m]; PlaceSearch has no memory for larger rasters
  return !grid.cells.empty() && grid.resolution * std::max(grid.width, grid.height) <= kLargestEdge;
}

void GridRecogniser::begin(const OccupancyGrid& grid) {
  map_ = scan_matching::drawn(grid, grid_config_).map;
  box_ = Eigen::AlignedBox2d();
  box_.extend(grid.origin);
  box_.extend(grid.origin + grid.resolution * Eigen::Vector2d(grid.width, grid.height));
  first_.reset();
  is_due_ = true;
}

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
  if (!first_ || !areOnePlace(first_->map_local * robot, place)) {
    first_ = Found{place * robot.inverse(), local_.way()};
    return false;
  }
  return local_.way() - first_->way >= kConfirmingWay;
}

}  // namespace slam::relocalisation
