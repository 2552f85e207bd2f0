// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/landmark_meeting.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace slam::graph_slam {
namespace {

constexpr double kGate = 13.8;        // 0.999 of chi-square with two degrees of freedom
constexpr double kLeastSigma = 0.02;  // by which two maps may differ in any case [m]
constexpr double kSpread = 1.0;       // landmarks that tell a heading are so far apart [m]
constexpr std::size_t kLeastAgreeing = 3;
constexpr std::size_t kMostTried = 40;  // landmarks of which all pairs are tried

/// The rigid motion that takes the points of some landmarks from the second map to the first with
/// the least squared error (Umeyama 1991, in the plane).
Pose2 alignmentOf(const std::vector<SharedLandmark>& shared,
                  const std::vector<std::size_t>& chosen) {
  Eigen::Vector2d first = Eigen::Vector2d::Zero(), second = Eigen::Vector2d::Zero();
  for (const auto i : chosen) {
    first += shared[i].in_first;
    second += shared[i].in_second;
  }
  first /= static_cast<double>(chosen.size());
  second /= static_cast<double>(chosen.size());
  double along = 0.0, across = 0.0;
  for (const auto i : chosen) {
    const Eigen::Vector2d a = shared[i].in_second - second, b = shared[i].in_first - first;
    along += a.dot(b);
    across += a.x() * b.y() - a.y() * b.x();
  }
  const Pose2 turn(0.0, 0.0, std::atan2(across, along));
  const Eigen::Vector2d shift = first - turn.transform(second);
  return {shift.x(), shift.y(), turn.theta()};
}

bool agrees(const SharedLandmark& landmark, const Pose2& first_second) {
  const Eigen::Matrix2d R = first_second.rotation();
  const Eigen::Matrix2d S = landmark.first_covariance +
                            R * landmark.second_covariance * R.transpose() +
                            kLeastSigma * kLeastSigma * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d d = landmark.in_first - first_second.transform(landmark.in_second);
  return d.dot(S.inverse() * d) < kGate;
}

std::vector<std::size_t> agreeingWith(const std::vector<SharedLandmark>& shared,
                                      const Pose2& first_second) {
  std::vector<std::size_t> agreeing;
  for (std::size_t i = 0; i < shared.size(); ++i)
    if (agrees(shared[i], first_second)) agreeing.push_back(i);
  return agreeing;
}

bool isSpread(const std::vector<SharedLandmark>& shared, const std::vector<std::size_t>& chosen) {
  return std::any_of(chosen.begin(), chosen.end(), [&](std::size_t i) {
    return (shared[i].in_first - shared[chosen.front()].in_first).norm() >= kSpread;
  });
}

}  // namespace

std::vector<std::size_t> evenlyChosen(std::size_t most, std::size_t size) {
  const std::size_t count = std::min(most, size);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(i * size / count);
  return chosen;
}

std::optional<LandmarkMeeting> meetingOf(const std::vector<SharedLandmark>& shared) {
  LandmarkMeeting best;
  const auto tried = evenlyChosen(kMostTried, shared.size());
  for (const auto i : tried)
    for (const auto j : tried) {
      if (j <= i || (shared[i].in_first - shared[j].in_first).norm() < kSpread) continue;
      const Pose2 guess = alignmentOf(shared, {i, j});
      auto agreeing = agreeingWith(shared, guess);
      if (agreeing.size() > best.agreeing.size()) best = {guess, std::move(agreeing)};
    }
  if (best.agreeing.size() < kLeastAgreeing) return std::nullopt;
  best.first_second = alignmentOf(shared, best.agreeing);
  best.agreeing = agreeingWith(shared, best.first_second);
  const bool is_majority = 2 * best.agreeing.size() > shared.size();
  if (best.agreeing.size() < kLeastAgreeing || !is_majority || !isSpread(shared, best.agreeing))
    return std::nullopt;
  return best;
}

}  // namespace slam::graph_slam
