// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/seif/surroundings.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

namespace slam::seif {
namespace {

/// The first landmarks are in one local map, and so many are gathered.
constexpr std::size_t kLandmarks = 40, kInMap = 30, kMost = 5;

/// Landmarks at 1, 2, ... 40 m before the robot, all seen from its first pose.
class RowOfLandmarks : public testing::Test {
 protected:
  RowOfLandmarks() {
    MappedPart part;
    for (std::size_t i = 0; i < kLandmarks; ++i) {
      LandmarkObservation z;
      z.range = 1.0 + static_cast<double>(i);
      z.covariance = 1e-4 * Eigen::Matrix2d::Identity();
      const Eigen::Vector2d place(z.range, 0.0);
      landmarks_.append(static_cast<LandmarkId>(i), place, z, Pose2());
      if (i >= kInMap) continue;
      part.landmarks.push_back(i);
      part.map.points.push_back(place);
    }
    const auto size = 2 * static_cast<Eigen::Index>(kInMap);
    part.map.covariance = 1e-4 * Eigen::MatrixXd::Identity(size, size);
    maps_.add(std::move(part));
  }

  std::vector<graph::Key> keysOf(std::size_t first, std::size_t last) const {
    std::vector<graph::Key> keys;
    for (std::size_t i = first; i <= last; ++i) keys.push_back(keyOf(landmarks_, i));
    return keys;
  }

  /// The shell of each landmark.
  std::vector<int> shellsOf(const graph::Vicinity& vicinity) const {
    std::vector<int> shells;
    for (std::size_t i = 0; i < kLandmarks; ++i)
      shells.push_back(vicinity.shell(keyOf(landmarks_, i)));
    return shells;
  }

  landmark_graph::PathGraph path_{{0.05, 0.05}, {Pose2(), 1e-6 * Eigen::Matrix3d::Identity()}};
  landmark_graph::LandmarkGraph landmarks_{path_};
  LocalMaps maps_{{45, 0.05}, path_, landmarks_};
  Surroundings surroundings_{kMost, path_, landmarks_, maps_};
};

TEST_F(RowOfLandmarks, GathersNothingWhileOnlyNewLandmarksAreSeen) {
  EXPECT_TRUE(surroundings_.follow({kInMap, kInMap + 1}).gathered.empty());
}

TEST_F(RowOfLandmarks, GathersTheNearestLandmarksOfTheMapThatIsSeenAgain) {
  EXPECT_EQ(surroundings_.follow({2}).gathered, keysOf(0, kMost - 1));
}

TEST_F(RowOfLandmarks, GathersAgainOnlyWhereALandmarkThatWasNotGatheredIsSeen) {
  surroundings_.follow({2});
  EXPECT_TRUE(surroundings_.follow({0, kMost - 1}).gathered.empty());
  EXPECT_FALSE(surroundings_.follow({kMost}).gathered.empty());
}

/// The radius of what is gathered is 5 m, so the smallest cells are 2 m wide.
TEST_F(RowOfLandmarks, PutsWhatIsTwiceAsFarIntoTheNextShell) {
  const auto shells = shellsOf(surroundings_.follow({2}));
  for (std::size_t i = 0; i < kLandmarks; ++i) {
    const auto distance = i + 1;
    const int expected = distance <= kMost ? 0
                         : distance < 8    ? 2
                         : distance < 16   ? 3
                         : distance < 32   ? 4
                                           : 5;
    EXPECT_EQ(shells[i], expected) << distance << " m";
  }
}

TEST_F(RowOfLandmarks, LeavesTheBordersOfTheShellsWhereTheyAreWhileTheRobotDrivesThroughACell) {
  const auto before = shellsOf(surroundings_.follow({2}));
  Motion motion;
  motion.increment = Pose2(1.9, 0.0, 0.0);
  motion.covariance = 1e-6 * Eigen::Matrix3d::Identity();
  path_.predict(motion);
  ASSERT_NEAR(path_.graph().pose(path_.nodeNearby()).x(), 1.9, 1e-6);
  EXPECT_EQ(shellsOf(surroundings_.follow({2})), before);
}

}  // namespace
}  // namespace slam::seif
