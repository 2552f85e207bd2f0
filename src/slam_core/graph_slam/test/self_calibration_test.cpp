// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/test/calibrator_contract.hpp"
#include "slam_core/graph_slam/graph_slam.hpp"

namespace slam::graph_slam {
namespace {

using test::driven;
using test::estimating;
using test::MiscalibratedRobot;
using test::offBy;

struct CalibratingGraph {
  using Filter = GraphSlam;
  using Config = GraphConfig;
  static constexpr int kSeeds = 4, kRobots = 16;
  static constexpr double kDelay = 0.0;  // it does not calibrate time_offset
  static std::vector<std::string> all() {
    return {"wheel_scale", "wheel_base", "wheel_drift", "sensor_yaw", "sensor_offset"};
  }
};

/// It wanders by the noise of a motion that is measured as none.
TEST(GraphSelfCalibration, StandingStillTellsNothingOfTheWheels) {
  GraphSlam graph;
  const auto config = estimating<GraphConfig>({"wheel_scale", "sensor_yaw"});
  graph.configure(config);
  MiscalibratedRobot robot(1, offBy(kSensorYaw, 0.1));
  for (int i = 0; i < 1000; ++i) {
    const auto step = robot.next(false);
    graph.set(step.motion);
    graph.set(step.observations);
    graph.execute();
  }
  const auto known = *as<Calibrator>(graph).calibration();
  EXPECT_NEAR(std::sqrt(known.covariance(kWheelScale, kWheelScale)), 0.2, 0.01);
  EXPECT_GT(std::sqrt(known.covariance(kSensorYaw, kSensorYaw)), 0.04);
  for (const auto& parameter : config.calibration.parametersOf(known))
    EXPECT_FALSE(parameter.is_told) << parameter.name;
}

std::vector<std::string> faultsOf(const std::string& yaml, MapKind map = MapKind::kLandmarks) {
  return test::faultsOf([&] {
    Settings settings({"product", YAML::Load("{version: 1, " + yaml + "}")}, {}, {});
    GraphSlam graph;
    as<MapChooser>(graph).useMap(map);
    graph.configure(settings);
  });
}

TEST(GraphSelfCalibration, RefusesWhatItCannotEstimate) {
  EXPECT_TRUE(
      test::oneSays(faultsOf("graph: {mode: localization}, calibration: {estimate: [wheel_scale]}"),
                    {"calibration.estimate", "fixed map", "graph.mode"}));
  EXPECT_TRUE(test::oneSays(faultsOf("calibration: {estimate: [wheel_scale, time_offset]}"),
                            {"calibration.estimate", "time_offset", "backend=ekf"}));
  EXPECT_TRUE(test::oneSays(faultsOf("calibration: {estimate: [wheel_scale]}", MapKind::kGrid),
                            {"calibration.estimate", "map=grid", "map=landmarks"}));
  EXPECT_TRUE(faultsOf("calibration: {estimate: [wheel_scale, range_scale]}").empty());
  EXPECT_TRUE(faultsOf("calibration: {estimate: []}", MapKind::kGrid).empty());
}

TEST(GraphSelfCalibration, RefusesToMergeASession) {
  GraphSlam other, graph;
  other.configure(GraphConfig());
  driven(other, MiscalibratedRobot(1, CalibrationVector::Zero()), 50);
  graph.configure(estimating<GraphConfig>({"wheel_scale"}));
  EXPECT_TRUE(
      test::oneSays(test::faultsOf([&] {
                      try {
                        as<SessionMerger>(graph).merge(as<SessionKeeper>(other).session());
                      } catch (const std::runtime_error& error) {
                        throw ConfigError(error.what());
                      }
                    }),
                    {"while parameters are calibrated no session is merged", "robot file"}));
}

/// The session holds the graph as it is with what was calibrated, and no parameters.
TEST(GraphSelfCalibration, SavesASessionThatIsAsItIsWithWhatWasFound) {
  auto off = offBy(kWheelScale, 0.25);
  off(kSensorYaw) = 0.1;
  off(kRangeScale) = 0.05;
  GraphSlam graph, later, calibrating;
  graph.configure(
      estimating<GraphConfig>({"wheel_scale", "sensor_yaw", "wheel_base", "range_scale"}));
  driven(graph, MiscalibratedRobot(3, off), 300);
  const auto session = as<SessionKeeper>(graph).session();
  later.configure(GraphConfig());
  calibrating.configure(estimating<GraphConfig>({"wheel_scale"}));
  for (auto* each : {&later, &calibrating}) {
    as<SessionKeeper>(*each).set(session);
    each->execute();
    EXPECT_LT(graph.pose().pose.between(each->pose().pose).vector().norm(), 1e-9);
    const auto before = as<LandmarkMapper>(graph).landmarks();
    const auto after = as<LandmarkMapper>(*each).landmarks();
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_LT((before[i].position - after[i].position).norm(), 1e-9);
  }
  // it is at rest where it was: the factors say what they said
  later.set(PoseEstimate{later.pose().pose, 1e-4 * Eigen::Matrix3d::Identity()});
  MiscalibratedRobot right(3, CalibrationVector::Zero());
  for (int i = 0; i < 300; ++i) right.next(i > 0);
  for (int i = 0; i < 50; ++i) {
    const auto step = right.next();
    later.set(step.motion);
    later.set(step.observations);
    EXPECT_TRUE(later.execute().isOk());
  }
  const auto moved = as<LandmarkMapper>(later).landmarks();
  for (std::size_t i = 0; i < moved.size(); ++i)
    EXPECT_LT((moved[i].position - as<LandmarkMapper>(graph).landmarks()[i].position).norm(), 0.1);
}

/// What is seen is decided on by place while the sensor's pose is still wrong.
TEST(GraphSelfCalibration, WorksWithoutIds) {
  auto off = offBy(kSensorYaw, 0.08);
  off(kSensorX) = 0.1;
  GraphConfig config = estimating<GraphConfig>({"sensor_yaw", "sensor_offset"});
  config.association = "nearest";
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    GraphSlam graph;
    graph.configure(config);
    MiscalibratedRobot robot(seed, off);
    for (int i = 0; i < test::kCalibrationSteps; ++i) {
      auto step = robot.next(i > 0);
      for (auto& z : step.observations.observations) z.id = kUnknownId;
      graph.set(step.motion);
      graph.set(step.observations);
      graph.execute();
    }
    const auto known = *as<Calibrator>(graph).calibration();
    for (const auto row : {kSensorYaw, kSensorX})
      EXPECT_LT(std::abs(known.parameters(row) - off(row)),
                4.0 * std::sqrt(known.covariance(row, row)))
          << "seed " << seed << ", row " << row;
    EXPECT_NEAR(known.parameters(kSensorYaw), 0.08, 0.02) << seed;
  }
}

}  // namespace
}  // namespace slam::graph_slam

namespace slam::test {
INSTANTIATE_TYPED_TEST_SUITE_P(Graph, SelfCalibration, graph_slam::CalibratingGraph);
}  // namespace slam::test
