// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "slam_core/common/archive_reader.hpp"
#include "slam_core/common/archive_writer.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/calibrator.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/contract/trajectory_capabilities.hpp"
#include "slam_core/models/test/miscalibrated_robot.hpp"

// Tests that each back-end passes which calibrates wheels and landmark sensor. A back-end
// instantiates SelfCalibration with a struct that has
//   Filter, Config               the back-end, and what its configure() takes
//   static constexpr int kSeeds, kRobots   how many drives the means are of
//   static constexpr double kDelay         [s] by which stamps are off where all is; 0: none
//   static std::vector<std::string> all()  what is estimated where all but the ranges is off

namespace slam::test {

constexpr int kCalibrationSteps = 500;  // 100 s, three rounds

inline CalibrationVector offBy(CalibrationParameter parameter, double by) {
  CalibrationVector off = CalibrationVector::Zero();
  off(parameter) = by;
  return off;
}

/// @param Config of a back-end, with a CalibrationConfig `calibration`
template <class Config>
Config estimating(const std::vector<std::string>& parameters) {
  Config config;
  config.calibration.estimate = parameters;
  return config;
}

/// What came out of a drive.
struct CalibratedDrive {
  CalibrationEstimate known;
  std::vector<double> errors;  ///< of the position, by step [m]
  double nees = 0.0;           ///< the mean
  double revised = 0.0;        ///< error of the path as known at the end, its root mean square [m]

  double rms() const {
    double sum = 0.0;
    for (const auto error : errors) sum += error * error;
    return std::sqrt(sum / static_cast<double>(errors.size()));
  }
};

inline double errorOf(const std::vector<StampedPose>& path, const std::vector<Pose2>& truth) {
  EXPECT_EQ(path.size(), truth.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    sum += (path[i].pose.position() - truth[i].position()).squaredNorm();
  return std::sqrt(sum / static_cast<double>(truth.size()));
}

template <class Filter>
Status take(Filter& filter, const SimulatedStep& step) {
  filter.set(step.motion);
  filter.set(step.observations);
  return filter.execute();
}

template <class Filter>
CalibratedDrive driven(Filter& filter, MiscalibratedRobot robot, int steps = kCalibrationSteps) {
  CalibratedDrive result;
  std::vector<Pose2> truth;
  for (int i = 0; i < steps; ++i) {
    const auto step = robot.next(i > 0);  // it sees something before it moves off
    take(filter, step);
    const auto pose = filter.pose();
    truth.push_back(step.truth);
    result.errors.push_back((pose.pose.position() - step.truth.position()).norm());
    result.nees += nees(step.truth, pose.pose, pose.covariance) / steps;
  }
  if (const auto known = as<Calibrator>(filter).calibration()) result.known = *known;
  if (const auto* reviser = capabilitiesOf(filter).template find<PathReviser>())
    result.revised = errorOf(reviser->path(), truth);
  return result;
}

template <class Filter, class Config>
CalibratedDrive driven(const Config& config, std::uint64_t seed, const CalibrationVector& off) {
  Filter filter;
  filter.configure(config);
  return driven(filter, MiscalibratedRobot(seed, off));
}

/// What is wrong with a robot, and what is estimated then.
struct MiscalibrationCase {
  const char* name;
  CalibrationVector off;
  std::vector<std::string> estimate;
};

/// The last one is off in all but the ranges.
inline std::vector<MiscalibrationCase> miscalibrations(double delay,
                                                       const std::vector<std::string>& all) {
  CalibrationVector mount = offBy(kSensorX, 0.2), off;
  mount(kSensorY) = -0.15;
  mount(kSensorYaw) = 0.2;
  off << 0.25, -0.08, 0.05, 0.1, 0.0, -0.1, 0.1, delay;
  std::vector<MiscalibrationCase> cases = {
      {"wheels measure 1.3 of each motion", offBy(kWheelScale, -std::log(1.3)), {"wheel_scale"}},
      {"wheels measure 0.7 of each motion", offBy(kWheelScale, -std::log(0.7)), {"wheel_scale"}},
      {"ranges are 1.2 of the true ones", offBy(kRangeScale, -std::log(1.2)), {"range_scale"}},
      {"bearings are off by 0.2", offBy(kSensorYaw, 0.2), {"sensor_yaw"}},
      {"the mount is off", mount, {"sensor_yaw", "sensor_offset"}}};
  if (delay != 0.0) cases.push_back({"stamps are late", offBy(kTimeOffset, -0.1), {"time_offset"}});
  cases.push_back({"all but the ranges", off, all});
  return cases;
}

template <class Traits>
class SelfCalibration : public testing::Test {
 protected:
  struct Means {
    double now = 0.0, revised = 0.0;  // of the errors [m]
  };

  static Means meansOf(const typename Traits::Config& config, const CalibrationVector& off) {
    Means means;
    for (std::uint64_t seed = 1; seed <= Traits::kSeeds; ++seed) {
      const auto result = driven<typename Traits::Filter>(config, seed, off);
      means.now += result.rms() / Traits::kSeeds;
      means.revised += result.revised / Traits::kSeeds;
    }
    return means;
  }
  static std::vector<MiscalibrationCase> cases() {
    return miscalibrations(Traits::kDelay, Traits::all());
  }
};
TYPED_TEST_SUITE_P(SelfCalibration);

TYPED_TEST_P(SelfCalibration, IsNearlyAsGoodAsTheRightRobotFile) {
  using Config = typename TypeParam::Config;
  const auto right = this->meansOf(Config(), CalibrationVector::Zero());
  for (const auto& c : this->cases()) {
    const auto wrong = this->meansOf(Config(), c.off);
    const auto with = this->meansOf(estimating<Config>(c.estimate), c.off);
    EXPECT_LT(with.now, 1.3 * right.now) << c.name;
    EXPECT_GT(wrong.now, 2.0 * with.now) << c.name;
    if (right.revised > 0.0) {
      EXPECT_LT(with.revised, 1.3 * right.revised) << c.name << ", the revised path";
    }
  }
}

/// Robots that are off by as much as the priors say: errors of the parameters in their standard
/// deviations, and NEES of the pose.
TYPED_TEST_P(SelfCalibration, KnowsHowWellItKnows) {
  using Filter = typename TypeParam::Filter;
  using Config = typename TypeParam::Config;
  constexpr int kRobots = TypeParam::kRobots;
  const auto config = estimating<Config>(TypeParam::all());
  const auto prior = config.calibration.prior();
  RandomStream random(5, 0);
  int within = 0, parameters = 0;
  double square = 0.0, nees = 0.0, nees_of_right = 0.0;
  for (int robot = 1; robot <= kRobots; ++robot) {
    const auto seed = static_cast<std::uint64_t>(robot);
    CalibrationVector off;
    for (Eigen::Index i = 0; i < kCalibrationRows; ++i)
      off(i) = random.gaussian() * std::sqrt(prior.covariance(i, i));
    const auto result = driven<Filter>(config, seed, off);
    nees += result.nees / kRobots;
    nees_of_right += driven<Filter>(Config(), seed, CalibrationVector::Zero()).nees / kRobots;
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

TYPED_TEST_P(SelfCalibration, DoesNotClaimToKnowBothScales) {
  const auto config = estimating<typename TypeParam::Config>(
      {"wheel_scale", "wheel_base", "wheel_drift", "sensor_offset", "range_scale"});
  const auto result =
      driven<typename TypeParam::Filter>(config, 2, offBy(kRangeScale, -std::log(1.2)));
  const auto& P = result.known.covariance;
  // what the priors of all that is measured in metres leave: the wheels' scale and distance, the
  // ranges' scale
  const double common = 1.0 / std::sqrt(1.0 / 0.04 + 1.0 / 0.01 + 1.0 / 0.01);
  EXPECT_NEAR(std::sqrt(P(kWheelScale, kWheelScale)), common, 0.15 * common);
  EXPECT_NEAR(std::sqrt(P(kRangeScale, kRangeScale)), common, 0.15 * common);
  EXPECT_LT(result.nees, 4.2) << "the doubt is in the pose as well";
  EXPECT_NE(config.calibration.sentencesOn(result.known).back().find("apart"), std::string::npos);
}

TYPED_TEST_P(SelfCalibration, GoesOnInALoadedMap) {
  using Config = typename TypeParam::Config;
  typename TypeParam::Filter first, second;
  first.configure(Config());
  driven(first, MiscalibratedRobot(3, CalibrationVector::Zero()));
  auto map = as<MapKeeper>(first).state();
  map.robot = {Pose2(), 1e-6 * Eigen::Matrix3d::Identity()};
  map.joint_covariance.resize(0, 0);

  second.configure(estimating<Config>({"wheel_scale", "sensor_yaw"}));
  as<MapKeeper>(second).set(map);
  auto off = offBy(kWheelScale, 0.25);
  off(kSensorYaw) = 0.1;
  const auto result = driven(second, MiscalibratedRobot(3, off));
  EXPECT_NEAR(result.known.parameters(kWheelScale), 0.25, 0.01);
  EXPECT_NEAR(result.known.parameters(kSensorYaw), 0.1, 0.01);
  EXPECT_LT(result.rms(), 0.1);
}

TYPED_TEST_P(SelfCalibration, StaysWithTheRobotWhenItIsPutElsewhere) {
  typename TypeParam::Filter filter;
  filter.configure(estimating<typename TypeParam::Config>({"range_scale", "sensor_offset"}));
  driven(filter, MiscalibratedRobot(4, offBy(kRangeScale, 0.1)), 200);
  const auto before = *as<Calibrator>(filter).calibration();
  const PoseEstimate place{Pose2(3.0, 4.0, 1.0), 0.01 * Eigen::Matrix3d::Identity()};
  filter.set(place);
  filter.execute();
  EXPECT_LT(place.pose.between(filter.pose().pose).vector().norm(), 1e-9);
  EXPECT_LT((place.covariance - filter.pose().covariance).norm(), 1e-9);
  const auto after = *as<Calibrator>(filter).calibration();
  EXPECT_LT((before.parameters - after.parameters).norm(), 1e-12);
}

TYPED_TEST_P(SelfCalibration, GoesOnFromACheckpointWithTheSameBytes) {
  const auto config =
      estimating<typename TypeParam::Config>({"wheel_scale", "sensor_yaw", "range_scale"});
  MiscalibratedRobot robot(2, offBy(kSensorYaw, 0.1));
  typename TypeParam::Filter filter, resumed;
  filter.configure(config);
  resumed.configure(config);
  for (int i = 0; i < 100; ++i) take(filter, robot.next());
  ArchiveWriter writer;
  filter.saveState(writer);
  const auto bytes = writer.take();
  ArchiveReader reader(bytes);
  resumed.restoreState(reader);
  for (int i = 0; i < 100; ++i) {
    const auto next = robot.next();
    take(filter, next);
    take(resumed, next);
  }
  EXPECT_EQ(filter.pose().pose.vector(), resumed.pose().pose.vector());
  EXPECT_EQ(filter.pose().covariance, resumed.pose().covariance);
}

REGISTER_TYPED_TEST_SUITE_P(SelfCalibration, IsNearlyAsGoodAsTheRightRobotFile, KnowsHowWellItKnows,
                            DoesNotClaimToKnowBothScales, GoesOnInALoadedMap,
                            StaysWithTheRobotWhenItIsPutElsewhere,
                            GoesOnFromACheckpointWithTheSameBytes);

}  // namespace slam::test
