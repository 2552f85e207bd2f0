// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "slam_core/common/config_error.hpp"
#include "slam_sim/robot_model.hpp"

namespace slam::sim {
namespace {

class RobotFile : public testing::Test {
 protected:
  RobotFile() : path_(testing::TempDir() + "robot_file_test.yaml") {}
  ~RobotFile() override { std::filesystem::remove(path_); }

  /// The robot scout, whose first camera has these optics.
  RobotModel read(const std::string& optics) {
    std::ifstream file(std::string(SLAM_SIM_FOLDER) + "/robots/scout.yaml");
    std::stringstream text;
    text << file.rdbuf();
    auto content = text.str();
    const std::string there = "optics: {exposure: 0.01, noise_sigma: 3.0}";
    content.replace(content.find(there), there.size(), "optics: {" + optics + "}");
    std::ofstream(path_) << content;
    return readRobotFile(path_);
  }

  void expectFault(const std::string& optics, const std::string& sentence) {
    try {
      read(optics);
      ADD_FAILURE() << optics << " was read";
    } catch (const ConfigError& error) {
      ASSERT_EQ(error.faults().size(), 1U) << error.what();
      const auto& fault = error.faults().front();
      EXPECT_NE(fault.find(path_ + ":"), std::string::npos) << fault;
      EXPECT_NE(fault.find(sentence), std::string::npos) << fault;
    }
  }

  std::string path_;
};

TEST_F(RobotFile, ACameraMayHaveARollingShutter) {
  const auto robot = read("exposure: 0.02, rolling_shutter: 0.03");
  EXPECT_EQ(robot.cameras.front().optics.rolling_shutter, 0.03);
  EXPECT_EQ(robot.cameras.back().optics.rolling_shutter, 0.0);
}

TEST_F(RobotFile, AShutterThatCannotBeIsRefused) {
  expectFault("rolling_shutter: -0.01", "rolling_shutter holds '-0.01'");
  expectFault("rolling_shuter: 0.01",
              "rolling_shuter is unknown (did you mean 'rolling_shutter'?)");
  expectFault("exposure: 0.05, rolling_shutter: 0.06",
              "exposes and reads its rows longer than there is time between two images");
  expectFault("exposure: 0.11", "exposes longer than there is time between two images");
}

}  // namespace
}  // namespace slam::sim
