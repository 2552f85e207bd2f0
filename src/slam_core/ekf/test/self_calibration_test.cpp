// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/calibrator.hpp"
#include "slam_core/ekf/ekf_slam.hpp"
#include "slam_core/models/test/miscalibrated_robot.hpp"

namespace slam::ekf {
namespace {

using test::MiscalibratedRobot;

constexpr int kSteps = 500;  // 100 s, three rounds

EkfConfig estimating(const std::vector<std::string>& parameters) {
  EkfConfig config;
  config.calibration.estimate = parameters;
  return config;
}

struct Driven {
  CalibrationEstimate known;
  std::vector<double> errors;  ///< of the position, by step [m]
  double nees = 0.0;           ///< the mean
  double rms() const {
    double sum = 0.0;
    for (const auto error : errors) sum += error * error;
    return std::sqrt(sum / static_cast<double>(errors.size()));
  }
};

Driven driven(EkfSlam& ekf, MiscalibratedRobot robot, int steps = kSteps) {
  Driven result;
  for (int i = 0; i < steps; ++i) {
    const auto step = robot.next(i > 0);  // it sees something before it moves off
    ekf.set(step.motion);
    ekf.set(step.observations);
    ekf.execute();
    const auto pose = ekf.pose();
    result.errors.push_back((pose.pose.position() - step.truth.position()).norm());
    result.nees += test::nees(step.truth, pose.pose, pose.covariance) / steps;
  }
  if (const auto known = as<Calibrator>(ekf).calibration()) result.known = *known;
  return result;
}

Driven driven(const EkfConfig& config, std::uint64_t seed, const CalibrationVector& off) {
  EkfSlam ekf;
  ekf.configure(config);
  return driven(ekf, MiscalibratedRobot(seed, off));
}

CalibrationVector offBy(CalibrationParameter parameter, double by) {
  CalibrationVector off = CalibrationVector::Zero();
  off(parameter) = by;
  return off;
}

/// What is wrong with a robot, what is estimated then.
struct Case {
  const char* name;
  CalibrationVector off;
  std::vector<std::string> estimate;
};

std::vector<Case> cases() {
  CalibrationVector mount = offBy(kSensorX, 0.2), all;
  mount(kSensorY) = -0.15;
  mount(kSensorYaw) = 0.2;
  all << 0.25, -0.08, 0.05, 0.1, 0.0, -0.1, 0.1, 0.06;
  return {
      {"wheels measure 1.3 of each motion", offBy(kWheelScale, -std::log(1.3)), {"wheel_scale"}},
      {"wheels measure 0.7 of each motion", offBy(kWheelScale, -std::log(0.7)), {"wheel_scale"}},
      {"ranges are 1.2 of the true ones", offBy(kRangeScale, -std::log(1.2)), {"range_scale"}},
      {"bearings are off by 0.2", offBy(kSensorYaw, 0.2), {"sensor_yaw"}},
      {"the mount is off", mount, {"sensor_yaw", "sensor_offset"}},
      {"stamps are late", offBy(kTimeOffset, -0.1), {"time_offset"}},
      {"all but the ranges",
       all,
       {"wheel_scale", "wheel_base", "wheel_drift", "sensor_yaw", "sensor_offset", "time_offset"}}};
}

TEST(SelfCalibration, IsNearlyAsGoodAsTheRightRobotFile) {
  constexpr int kSeeds = 6;
  for (const auto& c : cases()) {
    double right = 0.0, wrong = 0.0, with = 0.0;  // means of the errors [m]
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      right += driven(EkfConfig(), seed, CalibrationVector::Zero()).rms() / kSeeds;
      wrong += driven(EkfConfig(), seed, c.off).rms() / kSeeds;
      with += driven(estimating(c.estimate), seed, c.off).rms() / kSeeds;
    }
    EXPECT_LT(with, 1.3 * right) << c.name;
    EXPECT_GT(wrong, 2.0 * with) << c.name;
  }
}

/// Robots that are off by as much as the priors say: errors of the parameters in their standard
/// deviations, and NEES of the pose.
TEST(SelfCalibration, KnowsHowWellItKnows) {
  constexpr int kRobots = 20;
  const auto config = estimating(cases().back().estimate);
  const auto prior = config.calibration.prior();
  RandomStream random(5, 0);
  int within = 0, parameters = 0;
  double square = 0.0, nees = 0.0, nees_of_right = 0.0;
  for (int robot = 1; robot <= kRobots; ++robot) {
    CalibrationVector off;
    for (Eigen::Index i = 0; i < kCalibrationRows; ++i)
      off(i) = random.gaussian() * std::sqrt(prior.covariance(i, i));
    const auto result = driven(config, static_cast<std::uint64_t>(robot), off);
    nees += result.nees / kRobots;
    nees_of_right +=
        driven(EkfConfig(), static_cast<std::uint64_t>(robot), CalibrationVector::Zero()).nees /
        kRobots;
    for (Eigen::Index i = 0; i < kCalibrationRows; ++i) {
      if (prior.covariance(i, i) == 0.0) continue;
      const double sigmas =
          (result.known.parameters(i) - off(i)) / std::sqrt(result.known.covariance(i, i));
      square += sigmas * sigmas;
      within += std::abs(sigmas) < 3.0 ? 1 : 0;
      ++parameters;
    }
  }
  EXPECT_GE(within, 0.95 * parameters);
  EXPECT_NEAR(square / parameters, 1.0, 0.5);
  EXPECT_GT(nees, 1.0);
  // robots that are off by twice the prior move off with a scale that is wrong by 40 %, which the
  // first linearisation feels
  EXPECT_LT(nees, 1.8 * nees_of_right);
}

TEST(SelfCalibration, DoesNotClaimToKnowBothScales) {
  CalibrationVector off = offBy(kRangeScale, -std::log(1.2));
  const auto config =
      estimating({"wheel_scale", "wheel_base", "wheel_drift", "sensor_offset", "range_scale"});
  const auto result = driven(config, 2, off);
  const auto& P = result.known.covariance;
  // what the priors of all that is measured in metres leave: the wheels' scale and distance, the
  // ranges' scale
  const double common = 1.0 / std::sqrt(1.0 / 0.04 + 1.0 / 0.01 + 1.0 / 0.01);
  EXPECT_NEAR(std::sqrt(P(kWheelScale, kWheelScale)), common, 0.15 * common);
  EXPECT_NEAR(std::sqrt(P(kRangeScale, kRangeScale)), common, 0.15 * common);
  EXPECT_LT(result.nees, 4.2) << "the doubt is in the pose as well";
  EXPECT_NE(config.calibration.sentencesOn(result.known).back().find("apart"), std::string::npos);
}

TEST(SelfCalibration, StandingStillTellsNothingOfTheWheels) {
  EkfSlam ekf;
  ekf.configure(estimating({"wheel_scale", "sensor_yaw"}));
  MiscalibratedRobot robot(1, offBy(kSensorYaw, 0.1));
  for (int i = 0; i < 300; ++i) {
    const auto step = robot.next(false);
    ekf.set(step.motion);
    ekf.set(step.observations);
    ekf.execute();
  }
  const auto known = *as<Calibrator>(ekf).calibration();
  EXPECT_NEAR(std::sqrt(known.covariance(kWheelScale, kWheelScale)), 0.2, 0.01);
  EXPECT_NEAR(std::sqrt(known.covariance(kSensorYaw, kSensorYaw)), 0.1, 0.01);
}

TEST(SelfCalibration, GoesOnInALoadedMap) {
  EkfSlam first;
  first.configure(EkfConfig());
  driven(first, MiscalibratedRobot(3, CalibrationVector::Zero()));
  auto map = as<MapKeeper>(first).state();
  map.robot = {Pose2(), 1e-6 * Eigen::Matrix3d::Identity()};
  map.joint_covariance.resize(0, 0);

  EkfSlam second;
  second.configure(estimating({"wheel_scale", "sensor_yaw"}));
  as<MapKeeper>(second).set(map);
  auto off = offBy(kWheelScale, 0.25);
  off(kSensorYaw) = 0.1;
  const auto result = driven(second, MiscalibratedRobot(3, off));
  EXPECT_NEAR(result.known.parameters(kWheelScale), 0.25, 0.01);
  EXPECT_NEAR(result.known.parameters(kSensorYaw), 0.1, 0.01);
  EXPECT_LT(result.rms(), 0.1);
}

TEST(SelfCalibration, RefusesALoadedMapWhereTheUnitOfLengthIsEstimated) {
  EkfSlam ekf;
  ekf.configure(estimating({"range_scale"}));
  as<MapKeeper>(ekf).set(MapState{{}, {{1, {2.0, 1.0}, Eigen::Matrix2d::Identity()}}, {}});
  const auto status = ekf.execute();
  EXPECT_EQ(status.level, Status::Level::kError);
  EXPECT_NE(status.message.find("range_scale cannot be estimated in a map that is loaded"),
            std::string::npos)
      << status.message;
  EXPECT_TRUE(as<LandmarkMapper>(ekf).landmarks().empty());
}

TEST(SelfCalibration, StaysWithTheRobotWhenItIsPutElsewhere) {
  EkfSlam ekf;
  ekf.configure(estimating({"range_scale", "sensor_offset"}));
  driven(ekf, MiscalibratedRobot(4, offBy(kRangeScale, 0.1)), 200);
  const auto before = *as<Calibrator>(ekf).calibration();
  const PoseEstimate place{Pose2(3.0, 4.0, 1.0), 0.01 * Eigen::Matrix3d::Identity()};
  ekf.set(place);
  ekf.execute();
  EXPECT_LT(place.pose.between(ekf.pose().pose).vector().norm(), 1e-9);
  EXPECT_LT((place.covariance - ekf.pose().covariance).norm(), 1e-9);
  const auto after = *as<Calibrator>(ekf).calibration();
  EXPECT_LT((before.parameters - after.parameters).norm(), 1e-12);
}

TEST(SelfCalibration, TellsOfACalibrationThatRunsAway) {
  EkfSlam ekf;
  auto config = estimating({"wheel_scale"});
  config.calibration.sigma_wheel_scale = 0.02;
  ekf.configure(config);
  MiscalibratedRobot robot(1, offBy(kWheelScale, 0.12));
  std::string told;
  for (int i = 0; i < 100; ++i) {
    const auto step = robot.next(i > 0);
    ekf.set(step.motion);
    ekf.set(step.observations);
    const auto status = ekf.execute();
    if (!status.isOk()) told = status.message;
    ASSERT_TRUE(ekf.pose().pose.isFinite());
  }
  EXPECT_NE(told.find("wheel_scale is"), std::string::npos) << told;
  EXPECT_NE(told.find("check the robot file"), std::string::npos) << told;
}

TEST(SelfCalibration, IsRefusedInAFixedMap) {
  Settings settings({"product", YAML::Load("{version: 1, ekf: {mode: localization}, "
                                           "calibration: {estimate: [wheel_scale]}}")},
                    {}, {});
  EkfSlam ekf;
  EXPECT_TRUE(test::oneSays(test::faultsOf([&] { ekf.configure(settings); }),
                            {"calibration.estimate", "fixed map", "ekf.mode"}));
}

TEST(SelfCalibration, GoesOnFromACheckpointWithTheSameBytes) {
  const auto config = estimating({"wheel_scale", "sensor_yaw", "range_scale"});
  MiscalibratedRobot robot(2, offBy(kSensorYaw, 0.1));
  EkfSlam ekf, resumed;
  ekf.configure(config);
  resumed.configure(config);
  const auto step = [](EkfSlam& of, const test::SimulatedStep& s) {
    of.set(s.motion);
    of.set(s.observations);
    of.execute();
  };
  for (int i = 0; i < 100; ++i) step(ekf, robot.next());
  ArchiveWriter writer;
  ekf.saveState(writer);
  const auto bytes = writer.take();
  ArchiveReader reader(bytes);
  resumed.restoreState(reader);
  for (int i = 0; i < 100; ++i) {
    const auto next = robot.next();
    step(ekf, next);
    step(resumed, next);
  }
  EXPECT_EQ(ekf.pose().pose.vector(), resumed.pose().pose.vector());
  EXPECT_EQ(ekf.pose().covariance, resumed.pose().covariance);
}

}  // namespace
}  // namespace slam::ekf
