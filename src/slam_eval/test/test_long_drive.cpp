// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "program.hpp"

namespace slam::eval {
namespace {

ProgramRun runLongDrive(const std::string& arguments) {
  return runCommand("'" SLAM_EVAL_LONG_DRIVE "' " + arguments);
}

TEST(LongDriveProgram, PrintsARowForEachPartOfTheWay) {
  const auto run = runLongDrive("--loop 10 --metres 60 --rows 3");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 5) << run.output;
  EXPECT_NE(run.output.find("\n| 20 | "), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("\n| 60 | "), std::string::npos) << run.output;
}

TEST(LongDriveProgram, RefusesWrongUse) {
  EXPECT_EQ(runLongDrive("--metres 0").exit_code, 2);
  const auto run = runLongDrive("--metres 10 --set graph.nodes_per_place=0");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.output.find("nodes_per_place"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace slam::eval
