// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/calibration_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/product/test/product_run.hpp"

namespace slam {
namespace {

/// Those that concern the calibration; a product may lack other things here.
std::vector<std::string> faultsOf(const std::vector<std::string>& overrides) {
  auto faults = test::faultsOfWords(overrides);
  const auto is_of_another = [](const std::string& fault) {
    return fault.find("calibrat") == std::string::npos;
  };
  faults.erase(std::remove_if(faults.begin(), faults.end(), is_of_another), faults.end());
  return faults;
}

TEST(CalibrationCheck, BackEndsThatDoNotCalibrateSayWhichDo) {
  for (const std::string backend : {"pf", "grid"})
    EXPECT_TRUE(
        test::oneSays(faultsOf({"backend=" + backend,
                                "map=" + std::string(backend == "pf" ? "landmarks" : "grid"),
                                "calibration.estimate=[wheel_scale]"}),
                      {("calibration.estimate: backend=" + backend + " does not calibrate").c_str(),
                       "backend=ekf", "backend=graph"}));
  EXPECT_TRUE(
      test::oneSays(faultsOf({"backend=graph", "map=grid", "calibration.estimate=[wheel_scale]"}),
                    {"calibration.estimate: with map=grid nothing is calibrated"}));
}

TEST(CalibrationCheck, WheelsAreNotCalibratedWhereTheyDoNotTellTheMotion) {
  for (const std::string backend : {"ekf", "graph"}) {
    for (const std::string odometry : {"visual", "visual_wheel", "laser", "laser_wheel"}) {
      const std::vector<std::string> product = {"backend=" + backend, "odometry=" + odometry};
      auto wheels = product, sensor = product;
      wheels.push_back("calibration.estimate=[sensor_yaw, wheel_drift]");
      sensor.push_back("calibration.estimate=[sensor_yaw]");
      EXPECT_TRUE(test::oneSays(faultsOf(wheels),
                                {("calibration.estimate: with odometry=" + odometry).c_str(),
                                 "wheel_drift", "odometry=wheel"}));
      EXPECT_TRUE(faultsOf(sensor).empty());
    }
    EXPECT_TRUE(faultsOf({"backend=" + backend, "calibration.estimate=[wheel_scale]"}).empty());
  }
}

TEST(CalibrationCheck, AnEmptyListIsRefusedByNobody) {
  EXPECT_TRUE(faultsOf({"backend=pf"}).empty());
  EXPECT_TRUE(faultsOf({"backend=graph", "odometry=visual"}).empty());
}

}  // namespace
}  // namespace slam
