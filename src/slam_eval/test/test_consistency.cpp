// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace slam::eval {
namespace {

ProgramRun runConsistency(const std::string& arguments) {
  return runCommand("'" SLAM_EVAL_CONSISTENCY "' " + arguments);
}

TEST(ConsistencyProgram, PrintsTheNeesOfEachStepOfAFilterThatKnowsItsNoise) {
  const auto run = runConsistency("--loop 10 --seeds 4 2>/dev/null");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto result = nlohmann::json::parse(run.output);
  EXPECT_EQ(result["seeds"], 4);
  const auto nees = result["average_nees"].get<std::vector<double>>();
  ASSERT_EQ(nees.size(), 120u);  // three laps of 10 m, a step each 0.25 m
  double sum = 0.0;
  for (const double value : nees) sum += value;
  const double mean = sum / static_cast<double>(nees.size());
  EXPECT_GT(mean, 1.0);
  EXPECT_LT(mean, 9.0);
  EXPECT_NEAR(result["nis_mean"].get<double>(), 1.0, 0.15);
  EXPECT_LT(result["position_rmse_m"].get<double>(), 0.3);
}

TEST(ConsistencyProgram, RefusesWrongUseWithCodeTwo) {
  EXPECT_EQ(runConsistency("--seeds 0").exit_code, 2);
  EXPECT_EQ(runConsistency("--sedes 3").exit_code, 2);
}

TEST(ConsistencyProgram, NamesABackEndThatIsNotThere) {
  const auto run = runConsistency("--backend efk --seeds 1");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.output.find("efk"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace slam::eval
