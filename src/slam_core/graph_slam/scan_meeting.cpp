// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/scan_meeting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/graph_slam/loop_search.hpp"

namespace slam::graph_slam {
namespace {

constexpr std::size_t kLeastAgreeing = 3;
constexpr std::size_t kMajority = 4;  // so many agree for each one that contradicts
constexpr double kApart = 3.0;        // places that confirm each other [m]

}  // namespace

bool areAlike(const Pose2& a, const Pose2& b) {
  constexpr double kLargestShift = 1.0, kLargestTurn = 0.15;  // [m], [rad]
  const Pose2 error = a.between(b);
  return error.position().norm() <= kLargestShift && std::abs(error.theta()) <= kLargestTurn;
}

ScanMeeting::ScanMeeting(const Session& known, const ScanSettings& settings)
    : known_(known),
      drift_(settings.graph.submap_way * settings.graph.driftPerMetre()),
      map_(settings.grid, settings.matcher) {
  for (const auto& scan : known.scans) map_.draw(*scan.scan, known.nodes[scan.node]);
}

bool ScanMeeting::look(std::size_t seen, const LaserScan& scan) {
  const auto found = map_.find(scan);
  if (!found) return false;
  const auto node = nearestNode(found->pose);
  if (!node) return false;
  recognised_.push_back(
      {*node, seen, known_.nodes[*node].between(found->pose), covarianceOf(*found, drift_)});
  return true;
}

std::optional<Session::Index> ScanMeeting::nearestNode(const Pose2& place) const {
  std::optional<Session::Index> nearest;
  double least = INFINITY;
  for (const auto& scan : known_.scans) {
    const double distance = (known_.nodes[scan.node].position() - place.position()).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = scan.node;
  }
  return nearest;
}

std::optional<ScanMeeting::Agreed> ScanMeeting::agreed(
    const std::vector<std::optional<Pose2>>& poses) const {
  Agreed best;
  std::vector<std::size_t> most;
  std::size_t middle = 0;
  for (std::size_t i = 0; i < recognised_.size(); ++i) {
    if (!poses[i]) continue;
    const Pose2 place = known_.nodes[recognised_[i].known] * recognised_[i].known_seen;
    const Pose2 known_drive = place * poses[i]->inverse();
    auto agreeing = agreeingWith(known_drive, poses);
    if (agreeing.size() <= most.size()) continue;
    most = std::move(agreeing);
    middle = i;
    best.known_drive = known_drive;
  }
  std::vector<std::size_t> apart;  // of those that agree
  for (const auto i : most) {
    const bool is_apart = std::all_of(apart.begin(), apart.end(), [&](std::size_t j) {
      return (poses[i]->position() - poses[j]->position()).norm() >= kApart;
    });
    if (is_apart) apart.push_back(i);
  }
  const auto all =
      std::count_if(poses.begin(), poses.end(), [](const auto& pose) { return pose.has_value(); });
  const auto contradicting = static_cast<std::size_t>(all) - most.size();
  if (apart.size() < kLeastAgreeing || most.size() < kMajority * contradicting) return std::nullopt;
  best.scans.push_back(recognised_[middle]);
  for (const auto i : most)
    if (i != middle) best.scans.push_back(recognised_[i]);
  return best;
}

std::vector<std::size_t> ScanMeeting::agreeingWith(
    const Pose2& known_drive, const std::vector<std::optional<Pose2>>& poses) const {
  std::vector<std::size_t> agreeing;
  for (std::size_t i = 0; i < recognised_.size(); ++i) {
    if (!poses[i]) continue;
    const Pose2 place = known_.nodes[recognised_[i].known] * recognised_[i].known_seen;
    if (areAlike(place, known_drive * *poses[i])) agreeing.push_back(i);
  }
  return agreeing;
}

}  // namespace slam::graph_slam
