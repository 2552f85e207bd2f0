// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/place_trial.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "slam_core/models/independence.hpp"
#include "slam_core/scan_matching/usual_fit.hpp"

namespace slam::relocalisation {
namespace {

/// Edge of a patch, of which a surface shows one after the other [m].
constexpr double kPatch = 0.25;
/// Probability that a surface that is seen for the first time stands in the map: in the right
/// place, where furniture has been moved and people come by, and in one that looks alike up to
/// there.
constexpr double kStandsIfRight = 0.9, kStandsIfAlike = 0.5;
/// Neighbouring patches belong to the same wall: so many tell as much as one alone would. What is
/// seen in one area is limited besides (AreaEvidence).
constexpr double kPatchesAlike = 2.0;
/// What the rest of a scan counts: the search has chosen the place by the surfaces that it shows.
constexpr double kOfSeen = 0.25;
/// The share of a scan that contradicts the map has this distribution in a wrong place (ScanDoubt).
constexpr scan_matching::ShareDistribution kWrongPlace{1.5, 3.0};
/// No single scan tells more.
constexpr double kMostOfOneScan = 6.0;

std::pair<int, int> patchOf(const Eigen::Vector2d& point) {
  return {static_cast<int>(std::floor(point.x() / kPatch)),
          static_cast<int>(std::floor(point.y() / kPatch))};
}

/// A scan's ends, seen from a place, sorted into patches. Each keeps the place of its laser.
std::map<std::pair<int, int>, grid_map::ScanPoints> byPatches(const grid_map::ScanPoints& scan,
                                                              const Pose2& place) {
  std::map<std::pair<int, int>, grid_map::ScanPoints> patches;
  scan.forEachFan([&](const auto& fan, const auto&, const auto& ends) {
    for (const auto& end : ends) {
      const Eigen::Vector2d point = end / scan.cells_per_metre;
      auto& part = patches[patchOf(place.transform(point))];
      part.cells_per_metre = scan.cells_per_metre;
      if (part.fans.empty() || part.fans.back().origin != fan.origin)
        part.startFan(fan.origin, fan.relative_sigma);
      part.ends.push_back(end);
    }
  });
  return patches;
}

/// Takes a patch and those that are connected with it out of a set.
std::vector<std::pair<int, int>> takeConnected(std::set<std::pair<int, int>>& patches) {
  std::vector<std::pair<int, int>> connected = {*patches.begin()};
  patches.erase(patches.begin());
  for (std::size_t i = 0; i < connected.size(); ++i)
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) {
        const std::pair<int, int> next(connected[i].first + dx, connected[i].second + dy);
        if (patches.erase(next) > 0) connected.push_back(next);
      }
  return connected;
}

/// The patches that belong to more than people or a piece of furniture: those come and go in the
/// right place, too.
std::vector<std::pair<int, int>> largerThanFurniture(std::set<std::pair<int, int>> patches) {
  constexpr std::size_t kOfFurniture = 6;
  std::vector<std::pair<int, int>> larger;
  while (!patches.empty()) {
    const auto connected = takeConnected(patches);
    if (connected.size() > kOfFurniture)
      larger.insert(larger.end(), connected.begin(), connected.end());
  }
  return larger;
}

/// The logarithm of how many times likelier a whole scan is in the right place than in a wrong one.
double ofShare(const scan_matching::Agreement& agreement) {
  const auto usual = scan_matching::UsualFit().distribution();
  return std::clamp(usual.logLikelihood(agreement) - kWrongPlace.logLikelihood(agreement),
                    -kMostOfOneScan, kMostOfOneScan);
}

}  // namespace

PlaceTrial::PlaceTrial(const Pose2& map_local, const std::deque<LocalScan>& seen, double prior)
    : map_local_(map_local), last_(seen.back().pose), evidence_(prior) {
  for (const auto& scan : seen)
    for (const auto& [patch, part] : byPatches(scan.points[0], placeOf(scan.pose)))
      for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy) seen_.emplace(patch.first + dx, patch.second + dy);
}

double PlaceTrial::evidenceAgainst(const scan_matching::Agreement& agreement) {
  return std::min(0.0, ofShare(agreement));
}

void PlaceTrial::see(const LocalScan& scan, const scan_matching::MapView& map,
                     const scan_matching::ScanToMapMatcher& matcher, double most) {
  constexpr double kSigma = 0.2, kSigmaHeading = 0.1;  // of the local scans, in a step [m], [rad]
  const Eigen::Vector3d sigma(kSigma, kSigma, kSigmaHeading);
  const scan_matching::PosePrior prior{placeOf(scan.pose),
                                       sigma.cwiseAbs2().cwiseInverse().asDiagonal()};
  const auto match = matcher.believed(matcher.matchNearby(map, scan.points, prior), prior);
  map_local_ = match.pose * scan.pose.inverse();
  const double news = ofNewSurfaces(scan.points[0], map, match.pose) +
                      kOfSeen * weightOf(scan.pose) * ofShare(match.agreement);
  evidence_ = std::clamp(evidence_ + news, -most, most);
  last_ = scan.pose;
}

double PlaceTrial::ofNewSurfaces(const grid_map::ScanPoints& scan,
                                 const scan_matching::MapView& map, const Pose2& place) {
  const double for_right = std::log(kStandsIfRight / kStandsIfAlike);
  const double for_alike = std::log((1.0 - kStandsIfAlike) / (1.0 - kStandsIfRight));
  const auto& [model, grid] = map.finest();
  double sum = 0.0;
  std::set<Patch> missing;
  for (const auto& [patch, part] : byPatches(scan, place)) {
    if (seen_.count(patch) > 0) continue;
    const auto agreement = scan_matching::agreementOf(model, grid, part, place);
    if (agreement.surplus() < 0)
      missing.insert(patch);
    else if (agreement.known() > 0 && seen_.insert(patch).second)
      sum += areas_.add(patch, for_right / kPatchesAlike);
  }
  for (const auto& patch : largerThanFurniture(std::move(missing)))
    if (seen_.insert(patch).second) sum += areas_.add(patch, -for_alike / kPatchesAlike);
  return std::clamp(sum, -kMostOfOneScan, kMostOfOneScan);
}

double PlaceTrial::weightOf(const Pose2& local) const {
  constexpr Independence kScans{0.4, 0.6};
  return kScans.weightOf(last_.between(local), Duration::zero());
}

}  // namespace slam::relocalisation
