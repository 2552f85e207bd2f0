// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

// The time of an association in an EKF with many landmarks, as lines of
// policy,p50,p99,p50 with the search,p99 with the search [ms].

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "cpu_time.hpp"
#include "slam_core/association/gate.hpp"
#include "slam_core/common/random.hpp"
#include "slam_core/ekf/candidates.hpp"

namespace {

using slam::LandmarkObservationArray;
using slam::ekf::EkfState;

constexpr int kRow = 40, kLandmarks = 1000, kSeen = 15, kStrays = 5, kPlaces = 300;
constexpr double kSpacing = 1.5;  // [m]

const slam::RangeBearingModel kModel;

Eigen::Matrix2d noise() { return Eigen::Vector2d(25e-4, 4e-4).asDiagonal(); }

Eigen::Vector2d landmark(int number) {
  return {kSpacing * (number % kRow), kSpacing * (number / kRow)};
}

EkfState mapAround(const slam::Pose2& robot) {
  const Eigen::Matrix3d P = Eigen::Vector3d(0.01, 0.01, 4e-4).asDiagonal();
  EkfState state({slam::ekf::makeLinearization("right_invariant")}, {}, {robot, P});
  for (int i = 0; i < kLandmarks; ++i)
    state.append(
        i, {landmark(i), Eigen::Matrix<double, 2, 3>::Zero(), 0.01 * Eigen::Matrix2d::Identity()});
  state.relocate({robot, P});
  return state;
}

/// The nearest landmarks and as many strays as there are, seen from a place beside the prediction.
LandmarkObservationArray seenFrom(const slam::Pose2& robot, slam::RandomStream& random) {
  const slam::Pose2 truth = robot * slam::Pose2(0.1 * random.gaussian(), 0.1 * random.gaussian(),
                                                0.02 * random.gaussian());
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < kLandmarks; ++i) places.push_back(landmark(i));
  std::sort(places.begin(), places.end(), [&](const auto& a, const auto& b) {
    return (a - truth.position()).norm() < (b - truth.position()).norm();
  });
  places.resize(kSeen);
  for (int i = 0; i < kStrays; ++i)
    places.push_back(truth.transform({4.0 * random.gaussian(), 4.0 * random.gaussian()}));
  LandmarkObservationArray array;
  for (const auto& place : places) {
    const auto z = kModel.predict(truth, slam::Pose2(), place);
    array.observations.push_back({slam::kUnknownId, std::max(0.1, z.x() + 0.05 * random.gaussian()),
                                  z.y() + 0.02 * random.gaussian(), noise()});
  }
  return array;
}

std::string percentiles(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return fmt::format("{:.3f},{:.3f}", times[times.size() / 2], times[times.size() * 99 / 100]);
}

void measure(const std::string& name) {
  const auto policy = slam::association::makePolicy(name);
  const double gate = 2.25 * slam::association::gateOf(0.9999);
  std::vector<double> alone, with_search;
  std::vector<slam::association::Decision> decisions;
  slam::RandomStream random(1, 0);
  auto state = mapAround({});
  const slam::association::DescriptorMap descriptors;
  for (int i = 0; i < kPlaces; ++i) {
    const slam::Pose2 robot(kSpacing * kRow * random.uniform(), 20.0 * random.uniform(),
                            6.0 * random.uniform());
    state.relocate({robot, Eigen::Vector3d(0.01, 0.01, 4e-4).asDiagonal()});
    const auto array = seenFrom(robot, random);
    const double start = slam::eval::cpuMilliseconds();
    const auto near = slam::ekf::landmarksByPlace(array, state, kModel, gate);
    state.take(near.all());
    const slam::ekf::PlaceCandidates source(array, state, kModel, near, descriptors);
    const double searched = slam::eval::cpuMilliseconds();
    policy->decide(array, source, false, decisions);
    const double end = slam::eval::cpuMilliseconds();
    alone.push_back(end - searched);
    with_search.push_back(end - start);
  }
  fmt::print("{},{},{}\n", name, percentiles(alone), percentiles(with_search));
}

}  // namespace

int main() {
  for (const std::string policy : {"nearest", "jcbb"}) measure(policy);
}
