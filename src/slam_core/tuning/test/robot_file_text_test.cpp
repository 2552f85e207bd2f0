// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/tuning/robot_file_text.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/test/faults.hpp"

namespace slam::tuning {
namespace {

TEST(RobotFileText, ChangesTheTunedValuesOnlyAndKeepsItsComments) {
  const std::string text =
      "# licence\n\n# The robot.\nversion: 1\nrobot: a\n\nwheel_odometry:\n"
      "  alpha1: 0.003   # [m^2/m]\n  drive: differential\n\n# of the camera\nlandmark_sensor:\n"
      "  sigma_range: 0.1\n";
  TunedParameter alpha1{"wheel_odometry", "alpha1", 0.003, 0.01234, 0.001, ""};
  TunedParameter alpha4{"wheel_odometry", "alpha4", 0.003, 0.02, 0.001, ""};
  TunedParameter range{"landmark_sensor", "sigma_range", 0.1, 0.25, 0.1, "hidden"};
  EXPECT_EQ(withTunedValues(text, {alpha1, alpha4, range}, "Tuned on X."),
            "# licence\n\n# The robot.\n# Tuned on X.\nversion: 1\nrobot: a\n\nwheel_odometry:\n"
            "  alpha1: 0.0123  # [m^2/m]\n  drive: differential\n  alpha4: 0.02\n\n"
            "# of the camera\nlandmark_sensor:\n  sigma_range: 0.1\n");
}

TEST(RobotFileText, AddsASectionThatIsMissing) {
  TunedParameter range{"landmark_sensor", "sigma_range", 0.1, 0.25, 0.1, ""};
  EXPECT_EQ(withTunedValues("version: 1\n", {range}, "R"),
            "# R\nversion: 1\n\nlandmark_sensor:\n  sigma_range: 0.25\n");
}

TEST(RobotFileText, IndentsAsTheSectionDoes) {
  const std::string text =
      "version: 1\nwheel_odometry:\n    alpha1: 0.003\n    drive: differential\n"
      "landmark_sensor:\n    sigma_range: 0.1\n";
  TunedParameter alpha1{"wheel_odometry", "alpha1", 0.003, 0.01, 0.001, ""};
  TunedParameter alpha4{"wheel_odometry", "alpha4", 0.003, 0.012, 0.001, ""};
  EXPECT_EQ(withTunedValues(text, {alpha1, alpha4}, "R"),
            "# R\nversion: 1\nwheel_odometry:\n    alpha1: 0.01\n    drive: differential\n"
            "    alpha4: 0.012\nlandmark_sensor:\n    sigma_range: 0.1\n");
}

TEST(RobotFileText, KeepsSectionsInBraces) {
  const std::string text =
      "version: 1\nwheel_odometry: {alpha1: 0.003, drive: differential}  # wheels\n"
      "landmark_sensor: {}\n";
  TunedParameter alpha1{"wheel_odometry", "alpha1", 0.003, 0.01, 0.001, ""};
  TunedParameter alpha4{"wheel_odometry", "alpha4", 0.003, 0.012, 0.001, ""};
  TunedParameter range{"landmark_sensor", "sigma_range", 0.1, 0.25, 0.1, ""};
  EXPECT_EQ(withTunedValues(text, {alpha1, alpha4, range}, "R"),
            "# R\nversion: 1\nwheel_odometry: {alpha4: 0.012, alpha1: 0.01, drive: differential}"
            "  # wheels\nlandmark_sensor: {sigma_range: 0.25}\n");
}

TEST(RobotFileText, ReplacesAnEarlierRemark) {
  TunedParameter range{"landmark_sensor", "sigma_range", 0.1, 0.25, 0.1, ""};
  const std::string text = "# The robot.\nlandmark_sensor:\n  sigma_range: '0.1'\n";
  const auto once = withTunedValues(text, {range}, tuningRemark("ekf_wheel", "a.bag"));
  EXPECT_NE(once.find("# The robot.\n# Noise tuned by slam_tune"), std::string::npos) << once;
  EXPECT_NE(once.find("sigma_range: 0.25\n"), std::string::npos) << once;
  const auto again = withTunedValues(once, {range}, tuningRemark("ekf_wheel", "b.bag"));
  EXPECT_EQ(again, withTunedValues(text, {range}, tuningRemark("ekf_wheel", "b.bag")));
}

TEST(RobotFileText, RefusesWhatItCannotWriteInto) {
  TunedParameter range{"landmark_sensor", "sigma_range", 0.1, 0.25, 0.1, ""};
  for (const char* text :
       {"{version: 1}\n", "landmark_sensor: ~\n", "landmark_sensor:\n  sigma_range: &a 0.1\n",
        "landmark_sensor:\n  ? sigma_range\n  : 0.1\nx: [\n"})
    EXPECT_TRUE(test::oneSays({test::sentenceOf([&] { withTunedValues(text, {range}, "R"); })},
                              {"cannot be put into the robot file", "below it, indented alike"}))
        << text;
}

}  // namespace
}  // namespace slam::tuning
