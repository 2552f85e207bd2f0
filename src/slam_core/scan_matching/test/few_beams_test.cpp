// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "slam_core/common/random.hpp"
#include "slam_core/scan_matching/test/matching.hpp"

namespace slam::scan_matching {
namespace {

struct Beams {
  const char* name;
  int count;
  double field_of_view, most_range, relative_noise;  ///< [rad], [m], [1]
};
void PrintTo(const Beams& beams, std::ostream* out) { *out << beams.name; }

/// Along the x axis of a frame that is turned against the map's raster.
struct BareCorridor {
  double half_width;                  ///< [m]
  double turned;                      ///< [rad]
  std::optional<double> wall_at_end;  ///< across it [m]

  double rangeTo(const Eigen::Vector2d& from, double direction) const {
    const double to_side = std::copysign(half_width, std::sin(direction)) - from.y();
    const double range = to_side / std::sin(direction);
    if (!wall_at_end || std::cos(direction) <= 0.0) return range;
    return std::min(range, (*wall_at_end - from.x()) / std::cos(direction));
  }
  Pose2 inMap(const Pose2& pose) const { return Pose2(0, 0, turned) * pose; }
};

class FewBeams : public testing::TestWithParam<Beams> {
 protected:
  ScanLevels scanAt(const Pose2& pose, const BareCorridor& corridor, RandomStream& random) const {
    const auto& laser = GetParam();
    LaserScan scan;
    scan.relative_sigma = laser.relative_noise;
    for (int i = 0; i < laser.count; ++i) {
      const double bearing = laser.field_of_view * (i / (laser.count - 1.0) - 0.5);
      const double range = corridor.rangeTo(pose.position(), pose.theta() + bearing) *
                           (1.0 + laser.relative_noise * random.gaussian());
      const bool hit = range < laser.most_range;
      scan.beams.push_back(
          {static_cast<float>(bearing), static_cast<float>(hit ? range : laser.most_range), hit});
    }
    return pointsOf(scan, models, 0.02);
  }
  void drawTo(double end, const BareCorridor& corridor, RandomStream& random, ScanMap& map) const {
    for (double x = 0.0; x < end; x += 0.4)
      map.insert(scanAt({x, 0, 0}, corridor, random), corridor.inMap({x, 0, 0}));
  }
  const LevelModels models = levelModels({});
};

const std::vector<BareCorridor> kCorridors = {
    {1.1, 0.0, {}}, {1.1, 0.02, {}}, {0.7, 0.3, {}}, {2.0, 0.1, {}}};

/// Turns (x, y, theta) along the corridor to the map.
Eigen::Matrix3d toMap(const BareCorridor& corridor) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = Pose2(0, 0, corridor.turned).rotation();
  return R;
}

constexpr double kVagueAlong = 0.3, kSureAcross = 0.03, kSureHeading = 0.02;  // [m], [rad]

/// What is known of the pose after a match, seen along the corridor.
struct Outcome {
  double sigma_along, sigma_across;              ///< [m]
  double error_across;                           ///< [m]
  double nees_along, nees_across, nees_heading;  ///< of one degree of freedom each
};

Outcome outcomeOf(const Match& match, const PosePrior& prior, const Pose2& truth,
                  const BareCorridor& corridor) {
  const Eigen::Matrix3d R = toMap(corridor);
  const Eigen::Matrix3d of_map =
      (match.prior_weight * prior.information + match.information).inverse();
  const Eigen::Vector3d P = (R.transpose() * of_map * R).diagonal();
  const Eigen::Vector3d error = R.transpose() * (match.pose.vector() - truth.vector());
  const Eigen::Vector3d nees = error.cwiseAbs2().cwiseQuotient(P);
  return {std::sqrt(P.x()), std::sqrt(P.y()), error.y(), nees.x(), nees.y(), nees.z()};
}

/// A prior that errs as much as it says.
PosePrior vaguePrior(const Pose2& truth, const BareCorridor& corridor, RandomStream& random) {
  const Eigen::Vector3d sigma(kVagueAlong, kSureAcross, kSureHeading);
  const Eigen::Vector3d white(random.gaussian(), random.gaussian(), random.gaussian());
  const Eigen::Matrix3d R = toMap(corridor);
  const Eigen::Matrix3d of_corridor = sigma.cwiseAbs2().cwiseInverse().asDiagonal();
  return {Pose2::fromVector(truth.vector() + R * sigma.cwiseProduct(white)),
          Eigen::Matrix3d(R * of_corridor * R.transpose())};
}

TEST_P(FewBeams, KnowNothingAlongABareCorridorAndMuchAcross) {
  for (const auto& corridor : kCorridors) {
    double along = 0.0, across = 0.0, heading = 0.0;
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      RandomStream random{seed, 0};
      ScanMap map{grid_map::GridMapConfig()};
      drawTo(4.0, corridor, random, map);
      for (double x = 1.0; x < 5.0; x += 0.37) {  // also where the map has just begun
        const Pose2 truth = corridor.inMap({x, 0, 0});
        const auto prior = vaguePrior(truth, corridor, random);
        const auto match =
            ScanToMapMatcher().match(map.view(), scanAt({x, 0, 0}, corridor, random), prior);
        ASSERT_TRUE(match.is_determined);
        const auto outcome = outcomeOf(match, prior, truth, corridor);
        EXPECT_GT(outcome.sigma_along, 0.5 * kVagueAlong)
            << "half width " << corridor.half_width << ", turned " << corridor.turned << ", seed "
            << seed << ", at " << x;
        EXPECT_LT(outcome.sigma_across, 0.02);
        EXPECT_LT(std::abs(outcome.error_across), 0.03);
        along += outcome.nees_along;
        across += outcome.nees_across;
        heading += outcome.nees_heading;
        ++count;
      }
    }
    for (const double nees : {along, across, heading})
      EXPECT_LT(nees / count, 2.0) << "no surer than right; half width " << corridor.half_width;
  }
}

TEST_P(FewBeams, KnowWhereTheyAreBeforeAWallAtTheEnd) {
  const BareCorridor corridor{1.1, 0.02, 5.0};
  RandomStream random{1, 0};
  ScanMap map{grid_map::GridMapConfig()};
  drawTo(4.0, corridor, random, map);
  for (double x = 2.5; x < 4.0; x += 0.37) {
    const Pose2 truth = corridor.inMap({x, 0, 0});
    auto prior = vaguePrior(truth, corridor, random);
    prior.pose = corridor.inMap({x + 0.08, 0.01, 0.002});
    const auto match =
        ScanToMapMatcher().match(map.view(), scanAt({x, 0, 0}, corridor, random), prior);
    EXPECT_LT((match.pose.position() - truth.position()).norm(), 0.04);
    EXPECT_LT(outcomeOf(match, prior, truth, corridor).sigma_along, 0.05);
  }
}

/// What a search finds along a bare corridor is the best of many places by chance.
TEST_P(FewBeams, AreRecognisedOnlyWhereTheyTellTheirPlace) {
  const SearchWindow window{0.9, 0.2};
  for (const std::optional<double> wall_at_end : {std::optional<double>(), {5.0}}) {
    const BareCorridor corridor{1.1, 0.02, wall_at_end};
    RandomStream random{2, 0};
    ScanMap map{grid_map::GridMapConfig()};
    drawTo(4.0, corridor, random, map);
    int recognised = 0;
    for (double x = 2.5; x < 4.0; x += 0.37) {
      const Pose2 truth = corridor.inMap({x, 0, 0});
      const auto found =
          ScanToMapMatcher().recognise(map.view(), scanAt({x, 0, 0}, corridor, random),
                                       vaguePrior(truth, corridor, random), window);
      if (!found) continue;
      ++recognised;
      EXPECT_LT((found->pose.position() - truth.position()).norm(), 0.06);
    }
    if (wall_at_end)
      EXPECT_GE(recognised, 3);
    else
      EXPECT_EQ(recognised, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Lasers, FewBeams,
    testing::Values(Beams{"one each degree, 3.5 m", 360, 6.2657, 3.5, 0.015},
                    Beams{"two each degree, 3.5 m", 720, 6.2744, 3.5, 0.015},
                    Beams{"one each two degrees, 3.5 m", 180, 6.248, 3.5, 0.015},
                    Beams{"one each two degrees, 8 m", 180, 6.248, 8.0, 0.01},
                    Beams{"one each degree in front, 20 m", 181, 3.1416, 20.0, 0.0025},
                    Beams{"four each degree, 10 m", 1440, 6.28, 10.0, 0.01}));

}  // namespace
}  // namespace slam::scan_matching
