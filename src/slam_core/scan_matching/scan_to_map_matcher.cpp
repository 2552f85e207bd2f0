// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/scan_to_map_matcher.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/geometry/difference.hpp"
#include "slam_core/geometry/principal_axes.hpp"

namespace slam::scan_matching {
namespace {

/// Of all ends: where as many agree with the map, the coarse resolution would show nothing new.
constexpr double kSettled = 0.9;
/// A wide search is worth its time where more than this share of the ends in known cells
/// contradicts the map.
constexpr double kManyContradict = 0.3;
/// By how much better a place must fit that the prior did not lead to, of all ends: among many
/// places some fit by chance.
constexpr double kWorthAStep = 0.05, kWorthAJump = 0.4;
/// By how much a place that is worth a jump must fit better than all that are not near it.
constexpr double kBetterThanRivals = 0.1;
/// The same of a place that more contradicts than is usual, where nothing is known but the map.
constexpr double kUnmistakable = 0.4;
/// Of all ends, by a place that is worth a jump.
constexpr double kExplained = 0.75;
/// Of all ends, by a place that is near where it should be.
constexpr double kRecognised = 0.5;

/// A place that is found is compared with all other places within this distance.
constexpr SearchWindow kAround{10.0, M_PI};  // [m], [rad]
/// Two poses that are further from each other are two places.
constexpr SearchWindow kOtherPlace{0.5, 0.3};  // [m], [rad]
/// Without odometry, the windows grow until they cover the sigma of the guess, or this where it is
/// smaller. They are doubled, so that the last one may be up to twice as large.
constexpr SearchWindow kWidestGuess{2.0, 1.6};  // [m], [rad]

/// Ends of the scan, without its beams, that are as far apart as about two cells: they show as well
/// where it fits roughly, and sooner.
grid_map::ScanPoints thinned(const grid_map::ScanPoints& scan) {
  constexpr double kApart = 2.5;  // [cells]
  grid_map::ScanPoints kept;
  kept.cells_per_metre = scan.cells_per_metre;
  scan.forEachFan([&](const auto& fan, const auto&, const auto& ends) {
    kept.startFan(fan.origin, fan.relative_sigma);
    for (const auto& end : ends)
      if (kept.ends.empty() || (end - kept.ends.back()).norm() >= kApart) kept.ends.push_back(end);
  });
  return kept;
}

/// The search runs in the finest resolution that leaves it within memory.
PlaceSearch searchOf(const MapView& map, const ScanLevels& scan, const Pose2& middle,
                     const SearchWindow& window) {
  const std::size_t level = PlaceSearch::isWithinMemory(scan[0], window) ? 0 : 1;
  return {map.levels[level].map, thinned(scan[level]), middle, window};
}

/// The middle of all places, and the window around it that holds them and what is not far away.
std::pair<Pose2, SearchWindow> wholeOf(const Eigen::AlignedBox2d& places) {
  constexpr double kBeyond = 2.0;  // [m]
  return {Pose2(places.center().x(), places.center().y(), 0.0),
          {0.5 * places.sizes().maxCoeff() + kBeyond, M_PI}};
}

/// Whether the scan tells the place in every direction. Where it does not, as along a wall, a
/// search has found the best of many cells by chance.
bool showsOnePlace(const Match& match) {
  constexpr double kSigmas = 2.0;
  const Eigen::Matrix3d P = match.information.inverse();
  return kSigmas * std::sqrt(largestVariance(P.topLeftCorner<2, 2>())) <= kOtherPlace.position &&
         kSigmas * std::sqrt(P(2, 2)) <= kOtherPlace.heading;
}

double endsOf(const ScanLevels& scan) { return static_cast<double>(scan[0].ends.size()); }

bool isBetter(const Match& found, const Match& best, double surplus) {
  return found.is_determined && found.agreement.surplus() > best.agreement.surplus() + surplus;
}

/// Whether motion may have led to this place, if the map has drifted as usual.
bool isPlausible(const Match& match, const PosePrior& prior) {
  constexpr double kSquaredSigmas = 16.27;  // 0.999 of chi-square with three degrees of freedom
  if (!prior.information_among_older) return true;
  const Eigen::Vector3d error = difference(match.pose, prior.pose);
  return error.dot(*prior.information_among_older * error) < kSquaredSigmas;
}

/// Whether the place that was found explains most of what contradicted the map nearby.
bool explainsMost(const Match& found, const Match& nearby) {
  return 2 * found.agreement.contradicting <= nearby.agreement.contradicting;
}

}  // namespace

Match ScanToMapMatcher::match(const MapView& map, const ScanLevels& scan, const PosePrior& prior,
                              bool may_use_wide_window) const {
  auto best = matchNearby(map, scan, prior);
  if (isDoubtful(best))
    best = prior.information_among_older ? orAmongOlder(map, scan, prior, best)
                                         : orInWindows(map, scan, prior, best);
  if (may_use_wide_window && best.agreement.contradictingShare() > kManyContradict)
    best = foundFarAway(map, scan, prior, best);
  return believed(best, prior);
}

Match ScanToMapMatcher::orInWindows(const MapView& map, const ScanLevels& scan,
                                    const PosePrior& prior, Match best) const {
  for (const auto& window : windowsAround(prior)) {
    if (!isDoubtful(best)) break;
    const auto found = searched(map, scan, prior.pose, window.position, window.heading);
    const bool is_local = window.position <= config_.window_position;
    if (isBetter(found, best, kWorthAStep * endsOf(scan)) &&
        (is_local || !hasRival(found, map, scan, found.pose, kAround, kBetterThanRivals)))
      best = found;
  }
  return best;
}

std::vector<SearchWindow> ScanToMapMatcher::windowsAround(const PosePrior& prior) const {
  std::vector<SearchWindow> windows = {{config_.window_position, config_.window_heading}};
  if (prior.is_measured || prior.information.determinant() <= 0.0) return windows;
  const Eigen::Matrix3d P = prior.information.inverse();
  const double position = std::sqrt(largestVariance(P.topLeftCorner<2, 2>()));
  const SearchWindow widest{std::min(kWidestGuess.position, position),
                            std::min(kWidestGuess.heading, std::sqrt(P(2, 2)))};
  const auto is_narrower = [&](const SearchWindow& window) {
    return window.position < widest.position || window.heading < widest.heading;
  };
  while (is_narrower(windows.back()))
    windows.push_back({2.0 * windows.back().position, 2.0 * windows.back().heading});
  return windows;
}

std::optional<Match> ScanToMapMatcher::recognise(const MapView& map, const ScanLevels& scan,
                                                 const PosePrior& prior,
                                                 const SearchWindow& window) const {
  const bool is_local =
      window.position <= config_.window_position && window.heading <= config_.window_heading;
  const double enough = (is_local ? kRecognised : kExplained) * endsOf(scan);
  const auto found = is_local ? matchNearby(map, scan, prior)
                              : searched(map, scan, prior.pose, window.position, window.heading);
  const bool fits = found.is_determined && found.agreement.agreeing > enough && !isDoubtful(found);
  if (!fits) return std::nullopt;
  const bool is_known = is_local || (showsOnePlace(found) && !hasRival(found, map, scan, prior.pose,
                                                                       window, kBetterThanRivals));
  return is_known ? std::make_optional(found) : std::nullopt;
}

std::optional<Match> ScanToMapMatcher::recogniseAnywhere(const MapView& map, const ScanLevels& scan,
                                                         const Eigen::AlignedBox2d& places) const {
  const auto found = bestAnywhere(map, scan, places);
  if (!found || found->agreement.agreeing <= kExplained * endsOf(scan)) return std::nullopt;
  const double margin = isDoubtful(*found) ? kUnmistakable : kBetterThanRivals;
  const auto [middle, window] = wholeOf(places);
  if (hasRival(*found, map, scan, middle, window, margin)) return std::nullopt;
  return found;
}

std::optional<Match> ScanToMapMatcher::bestAnywhere(const MapView& map, const ScanLevels& scan,
                                                    const Eigen::AlignedBox2d& places) const {
  if (map.isEmpty() || places.isEmpty()) return std::nullopt;
  const auto [middle, window] = wholeOf(places);
  const auto search = searchOf(map, scan, middle, window);
  if (!search.isWithinReach()) return std::nullopt;
  const auto found = refinedWithin(map, scan, search.best().value_or(middle), window);
  return found.is_determined ? std::make_optional(found) : std::nullopt;
}

std::optional<Match> ScanToMapMatcher::rivalAnywhere(const Match& found, const MapView& map,
                                                     const ScanLevels& scan,
                                                     const Eigen::AlignedBox2d& places) const {
  const auto [middle, window] = wholeOf(places);
  const auto place = searchOf(map, scan, middle, window).bestApartFrom(found.pose, kOtherPlace);
  return place ? std::make_optional(refinedWithin(map, scan, *place, kOtherPlace)) : std::nullopt;
}

Match ScanToMapMatcher::foundFarAway(const MapView& map, const ScanLevels& scan,
                                     const PosePrior& prior, const Match& nearby) const {
  const auto found = searched(map, scan, prior.pose, config_.wide_position, config_.wide_heading);
  const bool is_worth_a_jump = found.agreement.agreeing > kExplained * endsOf(scan) &&
                               !isDoubtful(found) &&
                               isBetter(found, nearby, kWorthAJump * endsOf(scan)) &&
                               (isPlausible(found, prior) || nearby.agreement.mostlyContradicts());
  std::optional<Match> elsewhere;
  if (is_worth_a_jump)
    elsewhere = found;
  else if (prior.information_among_older && isPlausible(found, prior))
    elsewhere = amongOlder(found.pose, map, scan, prior, nearby);
  auto best = nearby;
  if (elsewhere && !hasRival(*elsewhere, map, scan, elsewhere->pose, kAround, kBetterThanRivals)) {
    best = *elsewhere;
    best.jumped = prior.pose.between(best.pose);
  }
  best.wide_search_done = true;
  return best;
}

Match ScanToMapMatcher::believed(Match match, const PosePrior& prior) const {
  if (!match.agreement.mostlyContradicts()) return match;
  Match nothing;
  nothing.pose = prior.pose;
  nothing.agreement = match.agreement;
  nothing.wide_search_done = match.wide_search_done;
  return nothing;
}

Match ScanToMapMatcher::matchNearby(const MapView& map, const ScanLevels& scan,
                                    const PosePrior& prior) const {
  const auto best = refined(map, scan, prior.pose, prior);
  if (best.agreement.agreeing >= kSettled * endsOf(scan)) return best;
  const auto coarse =
      registerScan(map.levels[1].map, scan[1], prior.pose, prior, kCoarser * config_.sigma);
  if (!coarse.isDetermined()) return best;
  const auto found = refined(map, scan, coarse.pose, prior);
  return isBetter(found, best, 0.0) ? found : best;
}

bool ScanToMapMatcher::isDoubtful(const Match& match) const {
  return match.agreement.contradictingShare() > config_.doubt_share;
}

Match ScanToMapMatcher::orAround(const Pose2& place, const MapView& map, const ScanLevels& scan,
                                 const Match& nearby) const {
  const auto found =
      refinedWithin(map, scan, place, {config_.window_position, config_.window_heading});
  const double worth = kWorthAStep * endsOf(scan);
  return isBetter(found, nearby, worth) ? found : nearby;
}

Match ScanToMapMatcher::refined(const MapView& map, const ScanLevels& scan, const Pose2& start,
                                const PosePrior& prior) const {
  const auto& [model, grid] = map.finest();
  const auto fine = registerScan(grid, scan[0], start, prior, config_.sigma);
  Match match;
  match.is_determined = fine.isDetermined();
  match.pose = start;
  if (match.is_determined) {
    match.pose = fine.pose;
    match.information = fine.information / config_.correlation;
    match.prior_weight = fine.prior_weight;
  }
  match.agreement = agreementOf(model, grid, scan[0], match.pose);
  return match;
}

bool ScanToMapMatcher::hasRival(const Match& found, const MapView& map, const ScanLevels& scan,
                                const Pose2& middle, const SearchWindow& window,
                                double margin) const {
  const bool is_wider = window.position > kAround.position;
  const auto search = is_wider ? searchOf(map, scan, middle, {window.position, M_PI})
                               : searchOf(map, scan, found.pose, kAround);
  if (!search.isWithinReach()) return true;  // none has been ruled out
  const auto place = search.bestApartFrom(found.pose, kOtherPlace);
  if (!place) return false;
  const auto rival = refinedWithin(map, scan, *place, kOtherPlace);
  return !isBetter(found, rival, margin * endsOf(scan));
}

Match ScanToMapMatcher::searched(const MapView& map, const ScanLevels& scan, const Pose2& middle,
                                 double position, double heading) const {
  const auto search = searchOf(map, scan, middle, {position, heading});
  return refinedWithin(map, scan, search.best().value_or(middle), {position, heading});
}

/// The older surfaces may be as far away as the map has drifted since they were drawn. The local
/// window comes first: a robot whose wheels slipped is near where they say, and a larger window may
/// hold places that look alike.
Match ScanToMapMatcher::orAmongOlder(const MapView& map, const ScanLevels& scan,
                                     const PosePrior& prior, const Match& nearby) const {
  const auto foundWithin = [&](double reach) {
    const auto search = searchOf(map, scan, prior.pose, {reach, config_.window_heading});
    return amongOlder(search.best().value_or(prior.pose), map, scan, prior, nearby);
  };
  if (const auto found = foundWithin(config_.window_position)) return *found;
  const Eigen::Matrix3d P = prior.information_among_older->inverse();
  const double drift = std::sqrt(largestVariance(P.topLeftCorner<2, 2>()));
  if (!(drift > config_.window_position)) return nearby;
  return foundWithin(std::min(drift, kWidestGuess.position)).value_or(nearby);
}

/// In directions in which the scan does not tell the place, as along a corridor, the prior does:
/// there a search has found one of many places by chance.
std::optional<Match> ScanToMapMatcher::amongOlder(const Pose2& place, const MapView& map,
                                                  const ScanLevels& scan, const PosePrior& prior,
                                                  const Match& nearby) const {
  auto found = refined(map, scan, place, {prior.pose, *prior.information_among_older});
  found.was_searched = found.is_among_older = true;
  if (!isBetter(found, nearby, kWorthAStep * endsOf(scan)) || !explainsMost(found, nearby))
    return std::nullopt;
  return found;
}

/// What a search has found is all that is known of the place.
Match ScanToMapMatcher::refinedWithin(const MapView& map, const ScanLevels& scan,
                                      const Pose2& middle, const SearchWindow& window) const {
  const Eigen::Vector3d sigma(window.position, window.position, window.heading);
  const PosePrior found{middle, sigma.cwiseAbs2().cwiseInverse().asDiagonal()};
  auto match = refined(map, scan, found.pose, found);
  if (!match.is_determined) return match;
  match.information += found.information;
  match.prior_weight = 0.0;
  match.was_searched = true;
  return match;
}

}  // namespace slam::scan_matching
