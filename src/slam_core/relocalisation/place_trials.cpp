// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/place_trials.hpp"

#include <algorithm>
#include <cmath>

#include "slam_core/geometry/one_place.hpp"

namespace slam::relocalisation {
namespace {

constexpr std::size_t kMostTrials = 4;  // at a time

bool hasMoreEvidence(const PlaceTrial& a, const PlaceTrial& b) {
  return a.evidence() > b.evidence();
}

}  // namespace

void PlaceTrials::forget() {
  trials_.clear();
  tried_ = 0.0;
}

double PlaceTrials::enough() const {
  return std::min(std::log(odds_ * std::max(1.0, tried_)), most());
}

double PlaceTrials::most() const { return 2.0 * std::log(odds_); }

void PlaceTrials::see(const LocalScan& scan, const scan_matching::MapView& map,
                      const scan_matching::ScanToMapMatcher& matcher) {
  for (auto& trial : trials_) trial.see(scan, map, matcher, most());
  std::stable_sort(trials_.begin(), trials_.end(), hasMoreEvidence);
  for (std::size_t i = 0; i < trials_.size(); ++i) {
    const auto is_same = [&](const PlaceTrial& other) {
      return areOnePlace(trials_[i].placeOf(scan.pose), other.placeOf(scan.pose));
    };
    const auto next = trials_.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    trials_.erase(std::remove_if(next, trials_.end(), is_same), trials_.end());
  }
}

PlaceTrials::Trials::iterator PlaceTrials::find(const Pose2& place, const Pose2& local) {
  return std::find_if(trials_.begin(), trials_.end(), [&](const PlaceTrial& trial) {
    return areOnePlace(trial.placeOf(local), place);
  });
}

PlaceTrials::Trials::const_iterator PlaceTrials::find(const Pose2& place,
                                                      const Pose2& local) const {
  return const_cast<PlaceTrials*>(this)->find(place, local);
}

void PlaceTrials::lead(const scan_matching::Match& found, const Pose2& local,
                       const std::deque<LocalScan>& seen, Prior prior) {
  if (find(found.pose, local) != trials_.end()) return;
  if (trials_.size() >= kMostTrials) dropWorst();
  ++tried_;
  trials_.emplace_back(found.pose * local.inverse(), seen, evidenceAtFirst(found, prior));
}

double PlaceTrials::evidenceAtFirst(const scan_matching::Match& found, Prior prior) const {
  if (prior == Prior::kExpected) return enough();
  const double of_scans = PlaceTrial::evidenceAgainst(found.agreement);
  return prior == Prior::kUnlikely ? of_scans - std::log(odds_) : of_scans;
}

void PlaceTrials::dropWorst() {
  trials_.erase(std::max_element(trials_.begin(), trials_.end(), hasMoreEvidence));
}

bool PlaceTrials::isEnough(const PlaceTrial& trial) const {
  double of_others = 0.0;
  for (const auto& other : trials_)
    if (&other != &trial) of_others = std::max(of_others, other.evidence());
  return trial.evidence() - of_others >= enough();
}

bool PlaceTrials::isEnoughFor(const Pose2& place, const Pose2& local) const {
  const auto trial = find(place, local);
  return trial != trials_.end() && isEnough(*trial);
}

bool PlaceTrials::hasEnough() const {
  return std::any_of(trials_.begin(), trials_.end(),
                     [this](const PlaceTrial& trial) { return isEnough(trial); });
}

void PlaceTrials::keepOnly(const Pose2& place, const Pose2& local) {
  const auto trial = *find(place, local);
  trials_.assign(1, trial);
}

}  // namespace slam::relocalisation
