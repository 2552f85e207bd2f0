// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "circles_log.hpp"
#include "import_error.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

constexpr char kStepLine[] = "STEP image.0000 0.5 -2.0 0.1 0.04 0.001 0.09 0.002 0.003 0.01\n";

class Circles : public testing::Test {
 protected:
  CirclesLog read(const std::string& content) {
    folder_.write("map.circles", content);
    return readCircles(folder_.file("map.circles"));
  }
  std::string failure(const std::string& content) {
    return messageOf<ImportError>([&] { read(content); });
  }

  TempFolder folder_;
};

TEST_F(Circles, TurnsItsAxesIntoThoseOfRep103) {
  const auto log = read(std::string("# a comment\n\n") + kStepLine);
  ASSERT_EQ(log.steps.size(), 1u);
  const auto& step = log.steps[0];
  EXPECT_EQ(step.displacement, Eigen::Vector3d(2.0, -0.5, -0.1)) << "forward, left, mirrored turn";
  Eigen::Matrix3d Q;
  Q << 0.09, 0.001, 0.003, 0.001, 0.04, 0.002, 0.003, 0.002, 0.01;
  EXPECT_TRUE(step.covariance.isApprox(Q, 1e-12)) << step.covariance;
}

TEST_F(Circles, PropagatesACartesianCovarianceToRangeAndBearing) {
  // four metres ahead and three to the right
  const auto log = read(std::string(kStepLine) + "LANDMARK_C 3 -4 0.9 0.01 0 0.04 17\n");
  ASSERT_EQ(log.steps[0].readings.size(), 1u);
  const auto& reading = log.steps[0].readings[0];
  EXPECT_EQ(reading.id, 17);
  EXPECT_DOUBLE_EQ(reading.range, 5.0);
  EXPECT_DOUBLE_EQ(reading.bearing, std::atan2(-3.0, 4.0));
  // along (0.8, -0.6) and across it, of variances 0.04 forward and 0.01 sideways
  EXPECT_NEAR(reading.covariance(0, 0), 0.64 * 0.04 + 0.36 * 0.01, 1e-12);
  EXPECT_NEAR(reading.covariance(1, 1), (0.36 * 0.04 + 0.64 * 0.01) / 25, 1e-12);
  EXPECT_NEAR(reading.covariance(0, 1), 0.48 * (0.04 - 0.01) / 5, 1e-12);
}

TEST_F(Circles, TakesTheFirstOfSeveralIdsAndKeepsThoseWithout) {
  const auto log = read(std::string(kStepLine) +
                        "LANDMARK 1 -4 0.9 0.01 0 0.04 5 6 7\n"
                        "LANDMARK_C 1 -3 0.9 0.01 0 0.04 -1\n");
  ASSERT_EQ(log.steps[0].readings.size(), 2u);
  EXPECT_EQ(log.steps[0].readings[0].id, 5);
  EXPECT_EQ(log.steps[0].readings[1].id, -1);
  EXPECT_EQ(log.several_ids, 1u);
  EXPECT_EQ(log.unidentified, 1u);
}

TEST_F(Circles, NamesFileAndLineOfWhatIsWrong) {
  EXPECT_NE(failure(std::string(kStepLine) + "STEP image 1 2 3\n").find("map.circles:2: 5 columns"),
            std::string::npos);
  EXPECT_NE(failure("LANDMARK 1 -4 0.9 0.01 0 0.04 5\n").find("before the first step"),
            std::string::npos);
  EXPECT_NE(failure(std::string(kStepLine) + "CIRCLE 1\n").find("neither STEP nor LANDMARK"),
            std::string::npos);
  EXPECT_NE(failure(std::string(kStepLine) + "LANDMARK 1 -4 0.9 0.01 0 -0.04 5\n")
                .find("not positive definite"),
            std::string::npos);
  EXPECT_NE(failure(std::string(kStepLine) + "LANDMARK 1 x 0.9 0.01 0 0.04 5\n").find("'x'"),
            std::string::npos);
  EXPECT_NE(failure(std::string(kStepLine) + "LANDMARK 0 0 0.9 0.01 0 0.04 5\n").find("no bearing"),
            std::string::npos);
  EXPECT_NE(failure(std::string(kStepLine) + "LANDMARK 1 -4 good 0.01 0 0.04 5\n").find("'good'"),
            std::string::npos);
  EXPECT_NE(failure(std::string(kStepLine) + "LANDMARK 1e300 -4 0.9 0.01 0 0.04 5\n")
                .find("map.circles:2: column 2: 1e+300"),
            std::string::npos);
  EXPECT_NE(failure("STEP image.0000 0.5 -2.0 0.1 1e300 0 1e300 0 0 0.01\n").find("column 6"),
            std::string::npos);
  EXPECT_NE(failure(std::string(kStepLine) + "LANDMARK 1 -4 0.9 0.01 0 0.04 -5\n")
                .find("the id -5 is negative"),
            std::string::npos);
  EXPECT_NE(failure("# nothing\n").find("holds no steps"), std::string::npos);
}

}  // namespace
}  // namespace slam::eval
