// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/test/calibrator_contract.hpp"
#include "slam_core/ekf/ekf_slam.hpp"

namespace slam::ekf {
namespace {

using test::estimating;
using test::MiscalibratedRobot;
using test::offBy;

struct CalibratingEkf {
  using Filter = EkfSlam;
  using Config = EkfConfig;
  static constexpr int kSeeds = 6, kRobots = 20;
  static constexpr double kDelay = 0.06;
  static std::vector<std::string> all() {
    return {"wheel_scale", "wheel_base",    "wheel_drift",
            "sensor_yaw",  "sensor_offset", "time_offset"};
  }
};

TEST(EkfSelfCalibration, StandingStillTellsNothingOfTheWheels) {
  EkfSlam ekf;
  ekf.configure(estimating<EkfConfig>({"wheel_scale", "sensor_yaw"}));
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

TEST(EkfSelfCalibration, RefusesALoadedMapWhereTheUnitOfLengthIsEstimated) {
  EkfSlam ekf;
  ekf.configure(estimating<EkfConfig>({"range_scale"}));
  as<MapKeeper>(ekf).set(MapState{{}, {{1, {2.0, 1.0}, Eigen::Matrix2d::Identity()}}, {}});
  const auto status = ekf.execute();
  EXPECT_EQ(status.level, Status::Level::kError);
  EXPECT_NE(status.message.find("range_scale cannot be estimated in a map that is loaded"),
            std::string::npos)
      << status.message;
  EXPECT_TRUE(as<LandmarkMapper>(ekf).landmarks().empty());
}

TEST(EkfSelfCalibration, IsRefusedInAFixedMap) {
  Settings settings({"product", YAML::Load("{version: 1, ekf: {mode: localization}, "
                                           "calibration: {estimate: [wheel_scale]}}")},
                    {}, {});
  EkfSlam ekf;
  EXPECT_TRUE(test::oneSays(test::faultsOf([&] { ekf.configure(settings); }),
                            {"calibration.estimate", "fixed map", "ekf.mode"}));
}

}  // namespace
}  // namespace slam::ekf

namespace slam::test {
INSTANTIATE_TYPED_TEST_SUITE_P(Ekf, SelfCalibration, ekf::CalibratingEkf);
}  // namespace slam::test
