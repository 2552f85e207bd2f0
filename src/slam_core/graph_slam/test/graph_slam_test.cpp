// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/graph_slam.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <chrono>
#include <cmath>
#include <vector>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/models/test/simulated_world.hpp"

namespace slam::graph_slam {
namespace {

using test::SimulatedStep;
using test::SimulatedWorld;

GraphConfig localization() {
  GraphConfig config;
  config.mode = BackendMode::kLocalization;
  return config;
}

/// In front of a robot that knows where it is; each has a standard deviation of 1 m.
MapState threeLandmarks() {
  MapState map;
  map.robot.covariance = 1e-6 * Eigen::Matrix3d::Identity();
  map.landmarks = {{1, {2, 0}, Eigen::Matrix2d::Identity()},
                   {2, {3, 1}, Eigen::Matrix2d::Identity()},
                   {3, {3, -1}, Eigen::Matrix2d::Identity()}};
  return map;
}

class GraphSlamTest : public testing::Test {
 protected:
  void SetUp() override { graph.configure(GraphConfig()); }
  static Status run(GraphSlam& slam, const SimulatedStep& step) {
    slam.set(step.motion);
    slam.set(step.observations);
    return slam.execute();
  }
  static LandmarkObservationArray arrayOf(LandmarkId id, double range, double bearing) {
    LandmarkObservationArray array;
    array.observations.resize(1);
    auto& z = array.observations.front();
    z.id = id;
    z.range = range;
    z.bearing = bearing;
    z.covariance = Eigen::Vector2d(1e-4, 1e-6).asDiagonal();
    return array;
  }
  /// Loads the map, and then sees one of its landmarks without error.
  Eigen::MatrixXd jointAfterSeeingTheFirst(const MapState& map) {
    as<MapKeeper>(graph).set(map);
    graph.execute();
    graph.set(arrayOf(1, 2, 0));
    EXPECT_TRUE(graph.execute().isOk());
    return as<MapKeeper>(graph).state().joint_covariance;
  }
  LandmarkMap landmarks() { return as<LandmarkMapper>(graph).landmarks(); }

  GraphSlam graph;
};

TEST_F(GraphSlamTest, MovesThePastWhenALoopCloses) {
  double online = 0.0, revised = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    graph.reset();
    SimulatedWorld world(seed);
    std::vector<Pose2> told, truth;
    for (int i = 0; i < SimulatedWorld::kLap + 10; ++i) {
      auto step = world.next();
      // between its first metres and the end of the lap it sees hardly anything
      if (i > 10 && i < SimulatedWorld::kLap && i % 10 != 0) step.observations.observations.clear();
      if (i > 10 && i < SimulatedWorld::kLap && step.observations.observations.size() > 1)
        step.observations.observations.resize(1);
      run(graph, step);
      told.push_back(graph.pose().pose);
      truth.push_back(step.truth);
    }
    const auto path = as<PathReviser>(graph).path();
    ASSERT_EQ(path.size(), truth.size());
    EXPECT_EQ(path.back().pose.vector(), told.back().vector());
    for (std::size_t i = 0; i < path.size(); ++i) {
      online += (told[i].position() - truth[i].position()).squaredNorm();
      revised += (path[i].pose.position() - truth[i].position()).squaredNorm();
    }
  }
  EXPECT_LT(std::sqrt(revised), 0.8 * std::sqrt(online));
}

TEST_F(GraphSlamTest, TakesNothingFromAFalseObservationFarOutsideTheGate) {
  GraphSlam without;
  without.configure(GraphConfig());
  SimulatedWorld world(3);
  for (int i = 0; i < 60; ++i) {
    auto step = world.next();
    auto& seen = step.observations.observations;
    ASSERT_GT(seen.size(), 1u);
    if (i == 40) {
      const auto falsely = seen.back();
      seen.pop_back();
      run(without, step);
      seen.push_back(falsely);
      seen.back().range += 3.0;
      run(graph, step);
      EXPECT_EQ(as<LandmarkMapper>(graph).statistics().gated, 1);
    } else {
      run(without, step);
      run(graph, step);
    }
    ASSERT_EQ(graph.pose().pose.vector(), without.pose().pose.vector()) << i;
    ASSERT_EQ(graph.pose().covariance, without.pose().covariance) << i;
  }
  EXPECT_EQ(graph.counters()["gated"], 1u);
  EXPECT_EQ(without.counters()["gated"], 0u);
  const auto a = landmarks(), b = as<LandmarkMapper>(without).landmarks();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].position, b[i].position);
}

TEST_F(GraphSlamTest, TellsALoadedMapAsItWasWhileItLocalises) {
  SimulatedWorld first(8);
  for (int i = 0; i < SimulatedWorld::kLap; ++i) run(graph, first.next());
  for (const bool has_joint : {true, false}) {
    auto map = as<MapKeeper>(graph).state();
    if (!has_joint) map.joint_covariance.resize(0, 0);
    GraphSlam localizing;
    localizing.configure(localization());
    as<MapKeeper>(localizing).set(map);
    localizing.set(PoseEstimate{Pose2(), 1e-4 * Eigen::Matrix3d::Identity()});
    int used = 0;
    SimulatedWorld world(9);
    Pose2 truth;
    for (int i = 0; i < 60; ++i) {
      const auto step = world.next();
      EXPECT_TRUE(run(localizing, step).isOk());
      used += as<LandmarkMapper>(localizing).statistics().used;
      truth = step.truth;
    }
    EXPECT_GT(used, 100);
    EXPECT_LT((localizing.pose().pose.position() - truth.position()).norm(), 0.1);
    const auto told = as<LandmarkMapper>(localizing).landmarks();
    const auto kept = as<MapKeeper>(localizing).state();
    ASSERT_EQ(told.size(), map.landmarks.size());
    for (std::size_t i = 0; i < told.size(); ++i) {
      EXPECT_EQ(told[i].position, map.landmarks[i].position);
      EXPECT_EQ(told[i].covariance, map.landmarks[i].covariance);
      EXPECT_EQ(kept.landmarks[i].position, map.landmarks[i].position);
    }
  }
}

TEST_F(GraphSlamTest, IsDeterminedByOnePoseAndOneLandmarkSeenOnce) {
  graph.set(arrayOf(5, 2, 0.3));
  EXPECT_TRUE(graph.execute().isOk());
  const auto state = as<MapKeeper>(graph).state();
  ASSERT_EQ(state.joint_covariance.rows(), 5);
  EXPECT_EQ(state.joint_covariance.llt().info(), Eigen::Success);
  EXPECT_EQ(graph.pose().covariance.llt().info(), Eigen::Success);
  ASSERT_EQ(landmarks().size(), 1u);
  EXPECT_EQ(landmarks()[0].covariance.llt().info(), Eigen::Success);
  EXPECT_LT((landmarks()[0].position - 2 * Eigen::Vector2d(std::cos(0.3), std::sin(0.3))).norm(),
            1e-9);
}

/// Landmark 2 has nearly the error of landmark 1, landmark 3 has nothing to do with it.
TEST_F(GraphSlamTest, LearnsOfLandmarksThatItDoesNotSeeByTheJointCovarianceOfALoadedMap) {
  auto map = threeLandmarks();
  map.joint_covariance = Eigen::MatrixXd::Identity(9, 9);
  map.joint_covariance.topLeftCorner<3, 3>() = map.robot.covariance;
  map.joint_covariance.block<2, 2>(3, 5) = map.joint_covariance.block<2, 2>(5, 3) =
      0.99 * Eigen::Matrix2d::Identity();
  as<MapKeeper>(graph).set(map);
  graph.execute();
  EXPECT_TRUE(as<MapKeeper>(graph).state().joint_covariance.isApprox(map.joint_covariance, 1e-6));
  const auto P = jointAfterSeeingTheFirst(map);
  EXPECT_LT(P(3, 3), 1e-3);
  EXPECT_NEAR(P(5, 5), 1 - 0.99 * 0.99, 1e-3);
  EXPECT_NEAR(P(7, 7), 1.0, 1e-6);
}

TEST_F(GraphSlamTest, InflatesTheMarginalsOfALoadedMapThatHasNothingElse) {
  GraphConfig config;
  config.load_inflation = 3.0;
  graph.configure(config);
  const auto map = threeLandmarks();
  as<MapKeeper>(graph).set(map);
  graph.execute();
  for (const auto& landmark : landmarks())
    EXPECT_TRUE(landmark.covariance.isApprox(9 * Eigen::Matrix2d::Identity(), 1e-9));
  EXPECT_TRUE(graph.pose().covariance.isApprox(map.robot.covariance, 1e-9));
  const auto P = jointAfterSeeingTheFirst(map);
  EXPECT_LT(P(3, 3), 1e-3);
  for (const int row : {5, 6, 7, 8}) EXPECT_NEAR(P(row, row), 9.0, 1e-6);
}

/// As it would do with all of their joint covariance, which makes a clique of them.
TEST_F(GraphSlamTest, TakesTheMarginalsOfAVeryLargeMap) {
  for (const int count : {100, 101}) {
    MapState map;
    map.robot.covariance = 1e-6 * Eigen::Matrix3d::Identity();
    map.joint_covariance = Eigen::MatrixXd::Identity(3 + 2 * count, 3 + 2 * count);
    map.joint_covariance.topLeftCorner<3, 3>() = map.robot.covariance;
    for (int i = 0; i < count; ++i)
      map.landmarks.push_back({i, {double(i), 5}, Eigen::Matrix2d::Identity()});
    as<MapKeeper>(graph).set(map);
    graph.execute();
    const double variance = landmarks()[7].covariance(0, 0);
    EXPECT_NEAR(variance, count == 100 ? 1.0 : 4.0, 1e-6);
  }
}

TEST_F(GraphSlamTest, SaysThatThePoseMayBeLostWhenNothingFitsTheMap) {
  auto array = arrayOf(1, 2, 0);
  for (const LandmarkId id : {2, 3}) {
    array.observations.push_back(array.observations[0]);
    array.observations.back().id = id;
    array.observations.back().bearing = 0.3 * double(id);
  }
  graph.set(array);
  EXPECT_TRUE(graph.execute().isOk());
  for (auto& z : array.observations) z.range += 5.0;
  graph.set(array);
  EXPECT_TRUE(test::oneSays({graph.execute().message}, {"no observation fits", "may be lost"}));
}

/// The robot's heading is off by 0.5 rad of sigma 0.3 rad, and all else is known: that alone costs
/// something, although from the predicted heading the landmarks look far from where they are seen.
TEST_F(GraphSlamTest, TellsTheInnovationsThatRemainWhereAllIsExplainedBest) {
  MapState map;
  map.robot.covariance = Eigen::Vector3d(1e-10, 1e-10, 0.09).asDiagonal();
  map.landmarks = {{1, {2, 0.5}, 1e-10 * Eigen::Matrix2d::Identity()},
                   {2, {1.5, -0.5}, 1e-10 * Eigen::Matrix2d::Identity()}};
  LandmarkObservationArray array;
  array.sensor_pose = Pose2(1, 0, 0);
  for (const auto& landmark : map.landmarks) {
    const Eigen::Vector2d seen =
        (Pose2(0, 0, 0.5) * array.sensor_pose).inverse().transform(landmark.position);
    array.observations.push_back(
        arrayOf(landmark.id, seen.norm(), std::atan2(seen.y(), seen.x())).observations[0]);
  }
  as<MapKeeper>(graph).set(map);
  graph.set(array);
  EXPECT_TRUE(graph.execute().isOk());
  const auto statistics = as<LandmarkMapper>(graph).statistics();
  EXPECT_EQ(statistics.used, 2);
  EXPECT_NEAR(statistics.nis, 0.25 / 0.09, 0.01);
  EXPECT_NEAR(graph.pose().pose.theta(), 0.5, 0.01);
}

/// Robot and landmark 1 are on the far end of a way whose heading is in doubt by 0.3 rad, and off
/// by 0.2 rad, as landmark 2 shows, which is known: that turns both about the way's beginning, and
/// does not stretch what lies between them.
TEST_F(GraphSlamTest, TurnsRobotAndLandmarksTogetherByAHeadingThatTheyHaveInCommon) {
  const Pose2 truth = Pose2(0, 0, 0.2) * Pose2(30, 0, 0);
  MapState map;
  map.robot.pose = Pose2(30, 0, 0);
  map.landmarks = {{1, {32, 0.5}, {}}, {2, {31, -1}, {}}};
  Eigen::Matrix<double, 7, 1> turned;
  turned << 0, 30, 1, -0.5, 32, 0, 0;
  map.joint_covariance =
      0.09 * turned * turned.transpose() + 1e-8 * Eigen::MatrixXd::Identity(7, 7);
  map.robot.covariance = map.joint_covariance.topLeftCorner<3, 3>();
  const std::vector<Eigen::Vector2d> seen = {{2, 0.5},
                                             truth.inverse().transform(map.landmarks[1].position)};
  auto array = arrayOf(1, seen[0].norm(), std::atan2(seen[0].y(), seen[0].x()));
  array.observations.push_back(
      arrayOf(2, seen[1].norm(), std::atan2(seen[1].y(), seen[1].x())).observations[0]);
  as<MapKeeper>(graph).set(map);
  graph.set(array);
  EXPECT_TRUE(graph.execute().isOk());
  const auto statistics = as<LandmarkMapper>(graph).statistics();
  EXPECT_EQ(statistics.used, 2);
  EXPECT_NEAR(statistics.nis, 0.04 / 0.09, 0.02);
}

TEST_F(GraphSlamTest, HasAGridWithoutCellsBeforeTheFirstScan) {
  as<MapChooser>(graph).useMap(MapKind::kGrid);
  graph.configure(GraphConfig());
  const auto grid = as<GridMapper>(graph).grid();
  ASSERT_TRUE(grid);
  EXPECT_TRUE(grid->cells.empty());
  EXPECT_GT(grid->resolution, 0.0);
}

/// A landmark that a false range has put where rounding is larger than what sensors tell.
TEST_F(GraphSlamTest, GatesAndReinitialisesALandmarkThatIsTooFarAwayToComputeWith) {
  for (int drive = 0; drive < 40; ++drive) {
    const double range = std::vector{1e8, 1e9, 3e9, 1e10}[std::size_t(drive) % 4];
    SetUp();
    auto first = arrayOf(1, range, 0.3 * drive);
    first.observations[0].covariance = Eigen::Vector2d(25e-4, 1e-4).asDiagonal();
    graph.set(first);
    graph.execute();
    for (int i = 0; i < 60; ++i) {
      Motion motion;
      motion.start = Stamp(std::chrono::milliseconds(100 * i));
      motion.end = motion.start + std::chrono::milliseconds(100);
      motion.increment = Pose2(0.02, 0.0, 0.01);
      motion.covariance = Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal();
      graph.set(motion);
      auto array = arrayOf(1, 4.0, 0.5);
      array.observations[0].covariance = Eigen::Vector2d(25e-4, 1e-4).asDiagonal();
      array.observations.push_back(arrayOf(2, 2.0, -0.5).observations.front());
      graph.set(array);
      const auto status = graph.execute();
      ASSERT_NE(status.level, Status::Level::kError) << range << " " << i << status.message;
    }
    EXPECT_LT(landmarks()[0].position.norm(), 10.0) << range;
  }
}

/// A false first observation: as in sightings_test.cpp, and the map is sound afterwards.
TEST_F(GraphSlamTest, BeginsALandmarkAnewThatIsNeverWhereTheMapHasIt) {
  LandmarkObservationArray array;
  for (const LandmarkId id : {1, 2, 3, 77}) {
    array.observations.push_back(arrayOf(id, 2, 0.3 * double(id % 10)).observations[0]);
  }
  array.observations.back().range = 50;
  graph.set(array);
  graph.execute();
  array.observations.back().range = 4;
  std::string warning;
  for (int i = 0; i < 20; ++i) {
    graph.set(array);
    const auto status = graph.execute();
    if (!status.isOk()) warning += status.message;
  }
  EXPECT_TRUE(test::oneSays({warning}, {"landmark 77", "re-initialised"})) << warning;
  EXPECT_EQ(graph.counters()["begun_anew"], 1u);
  EXPECT_NEAR(landmarks().back().position.norm(), 4, 0.01);
  EXPECT_EQ(as<LandmarkMapper>(graph).statistics().used, 4);
  EXPECT_EQ(as<MapKeeper>(graph).state().joint_covariance.llt().info(), Eigen::Success);
}

TEST(GraphConfigTest, RefusesWhatMakesNoGraph) {
  for (const auto& spoil : std::vector<void (*)(GraphConfig&)>{
           [](GraphConfig& c) { c.node_distance = -0.1; }, [](GraphConfig& c) { c.iterations = 0; },
           [](GraphConfig& c) { c.gate_probability = 1.0; },
           [](GraphConfig& c) { c.load_inflation = 0.5; },
           [](GraphConfig& c) { c.association = "nearest_star"; }}) {
    GraphConfig config;
    spoil(config);
    GraphSlam graph;
    EXPECT_EQ(test::faultsOf([&] { graph.configure(config); }).size(), 1u);
  }
}

}  // namespace
}  // namespace slam::graph_slam
