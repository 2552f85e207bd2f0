// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/scans/scan_proposal.hpp"

#include <gtest/gtest.h>

#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/particle_filter/scans/scan_config.hpp"
#include "slam_core/scan_matching/scan_map.hpp"

namespace slam::particle_filter {
namespace {

/// @return where else the others should look, seen from the truth; nothing if nowhere
std::optional<Pose2> foundFrom(const Pose2& offset, const std::optional<double>& drift) {
  constexpr double kSpacing = 0.02, kSigma = 0.02;  // [m]
  const auto models = scan_matching::levelModels({});
  scan_matching::ScanMap map{grid_map::GridMapConfig()};
  test::RoomDrive drive(3);
  for (int i = 0; i < test::RoomDrive::kLap; ++i) {
    const auto step = drive.next();
    map.insert(scan_matching::pointsOf(step.scan, models, kSpacing), step.truth);
  }
  const auto [motion, scan, truth] = drive.next();
  const auto points = scan_matching::pointsOf(scan, models, kSpacing);
  const ScanConfig config;
  const scan_matching::ScanEvidence evidence(config.outlier, config.unknown,
                                             config.beam_information);
  PoseGaussian prior;
  prior.mean = truth * offset;
  prior.covariance = kSigma * kSigma * Eigen::Matrix3d::Identity();
  std::optional<Eigen::Matrix3d> covariance;
  if (drift) covariance = *drift * *drift * Eigen::Matrix3d::Identity();
  const auto elsewhere =
      MatchedScanProposal({}).search({points, map.view(), evidence}, prior, covariance);
  if (!elsewhere) return std::nullopt;
  return truth.between(prior.mean * *elsewhere);
}

TEST(MatchedScanProposal, SearchesAsFarAsTheMapHasDrifted) {
  const Pose2 offset(1.1, -0.4, 0.05);
  EXPECT_FALSE(foundFrom(offset, 0.3));
  const auto found = foundFrom(offset, 1.5);
  ASSERT_TRUE(found);
  EXPECT_LT(found->position().norm(), 0.02);
}

TEST(MatchedScanProposal, SearchesNoFurtherInAFixedMap) {
  EXPECT_FALSE(foundFrom({1.1, -0.4, 0.05}, std::nullopt));
}

}  // namespace
}  // namespace slam::particle_filter
