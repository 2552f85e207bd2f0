// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

#include <Eigen/LU>
#include <utility>
#include <vector>

#include "slam_core/grid_map/scan_matcher.hpp"

namespace slam::scan_matching {
namespace {

/// Of all ends: where as many agree with the map, the coarse resolution would tell nothing new.
constexpr double kSettled = 0.9;
constexpr double kMostContradict = 0.5;
/// By how much better a place must fit that the prior did not lead to, of all ends: among many
/// places some fit by chance.
constexpr double kWorthAStep = 0.05, kWorthAJump = 0.4;
/// Of all ends, by a place that is worth a jump.
constexpr double kExplained = 0.75;
/// Of an end that has nothing to do with the map, relative to the best.
constexpr double kOutlier = 0.05;

/// The scan with fewer ends, that are as far apart as about two cells: they tell as well where it
/// fits roughly, and sooner.
grid_map::ScanPoints thinned(grid_map::ScanPoints scan) {
  constexpr double kApart = 2.5;  // [cells]
  std::vector<Eigen::Vector2d> kept;
  for (const auto& end : scan.ends)
    if (kept.empty() || (end - kept.back()).norm() >= kApart) kept.push_back(end);
  scan.ends = std::move(kept);
  return scan;
}

}  // namespace

Match ScanToMapMatcher::match(const ScanMap& map, const ScanLevels& scan,
                              const PosePrior& prior) const {
  const auto ends = static_cast<double>(scan[0].ends.size());
  auto best = refined(map, scan, prior.pose, prior);
  const auto consider = [&best](const Match& found, double surplus) {
    if (found.agreement.surplus() > best.agreement.surplus() + surplus) best = found;
  };
  if (best.agreement.agreeing < kSettled * ends) {
    const auto coarse =
        registerScan(map.levels()[1].map, scan[1], prior.pose, prior, kCoarser * config_.sigma);
    if (coarse.isDetermined()) consider(refined(map, scan, coarse.pose, prior), 0.0);
  }
  if (best.agreement.contradictingShare() > config_.doubt_share)
    consider(searched(map, scan, prior.pose, config_.window_position, config_.window_heading),
             kWorthAStep * ends);
  if (best.agreement.contradictingShare() > kMostContradict) {
    const auto found = searched(map, scan, prior.pose, config_.wide_position, config_.wide_heading);
    if (found.agreement.agreeing > kExplained * ends) consider(found, kWorthAJump * ends);
  }
  return best;
}

Match ScanToMapMatcher::refined(const ScanMap& map, const ScanLevels& scan, const Pose2& start,
                                const PosePrior& prior) const {
  const auto& [model, grid] = map.finest();
  const auto fine = registerScan(grid, scan[0], start, prior, config_.sigma);
  Match match;
  match.is_determined = fine.isDetermined();
  match.pose = match.is_determined ? fine.pose : start;
  match.information = fine.information / config_.correlation;
  match.prior_weight = fine.prior_weight;
  match.agreement = agreementOf(model, grid, scan[0], match.pose);
  return match;
}

Match ScanToMapMatcher::searched(const ScanMap& map, const ScanLevels& scan, const Pose2& middle,
                                 double position, double heading) const {
  const grid_map::ScanLikelihood likelihood(kOutlier, 1.0);
  const Eigen::Matrix3d covariance =
      Eigen::Vector3d(position * position, position * position, heading * heading).asDiagonal();
  const auto few = thinned(scan[0]);
  const grid_map::MatchObjective objective(likelihood, map.finest().map, few, middle, covariance);
  const grid_map::CorrelativeMatching correlative({position, heading}, {});
  const PosePrior found{correlative.match(objective).pose, covariance.inverse()};
  auto match = refined(map, scan, found.pose, found);
  match.information += found.information;
  match.prior_weight = 0.0;
  match.was_searched = true;
  return match;
}

}  // namespace slam::scan_matching
