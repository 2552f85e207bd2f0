// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

ProgramRun runGraph(const std::string& arguments) {
  return runCommand("'" SLAM_EVAL_GRAPH "' " + arguments);
}

nlohmann::json reportOf(const std::string& arguments) {
  const auto run = runGraph(arguments + " 2>/dev/null");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  return nlohmann::json::parse(run.output, nullptr, false);
}

/// A square of four poses of which the last edge closes the loop.
const char* const kSquare =
    "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 0 0 0\nVERTEX_SE2 2 0 0 0\nVERTEX_SE2 3 0 0 0\nFIX 0\n"
    "EDGE_SE2 0 1 1 0 1.5708 100 0 0 100 0 100\nEDGE_SE2 1 2 1 0 1.5708 100 0 0 100 0 100\n"
    "EDGE_SE2 2 3 1 0 1.5708 100 0 0 100 0 100\nEDGE_SE2 3 0 1.1 0 1.5708 100 0 0 100 0 100\n";

TEST(GraphProgram, PrintsTimesAndChi2OfACity) {
  const auto report = reportOf("--world 1 --poses 300");
  EXPECT_EQ(report["name"], "world_1_300");
  EXPECT_EQ(report["poses"], 300);
  EXPECT_GT(report["loops"], 50);
  EXPECT_GT(report["cpu_s"], 0.0);
  EXPECT_GE(report["worst_ms"], report["p99_ms"]);
  EXPECT_GE(report["p99_ms"], 0.0);
  EXPECT_GT(report["memory_mb"], report["tree_mb"]);
  EXPECT_NEAR(report["chi2_ratio"].get<double>(), 1.0, 1e-3);
  EXPECT_LT(report["error_m"], report["dead_reckoning_error_m"]);
  EXPECT_TRUE(report["ceres"]["has_converged"]);
  EXPECT_EQ(report.count("trajectory"), 0u);
}

TEST(GraphProgram, PrintsWhatAPictureNeeds) {
  const auto report = reportOf("--world 1 --poses 300 --limit 200 --false-loops 7 --detail");
  EXPECT_EQ(report["trajectory"].size(), 200u);
  EXPECT_EQ(report["truth"].size(), 200u);
  EXPECT_EQ(report["steps_ms"].size(), 200u);
  EXPECT_EQ(report["loop_edges"].size(), report["loops"]);
  EXPECT_EQ(report["false_loops"], 7);
}

TEST(GraphProgram, SolvesAFileAndHoldsItAgainstTheTruth) {
  const TempFolder folder;
  folder.write("square.g2o", kSquare);
  folder.write("truth.txt", "3 0 1 0\n0 0 0 0\n1 1 0 0\n2 1 1 0\n");
  const auto arguments =
      "--g2o " + folder.file("square.g2o") + " --truth " + folder.file("truth.txt");
  const auto report = reportOf(arguments);
  EXPECT_EQ(report["left_out"]["FIX"], 1);
  EXPECT_EQ(report["loops"], 1);
  EXPECT_NEAR(report["chi2_ratio"].get<double>(), 1.0, 1e-3);
  EXPECT_LT(report["error_m"], 0.06);
  const auto told = runGraph(arguments);
  EXPECT_NE(told.output.find("records of type FIX are not used"), std::string::npos) << told.output;
}

TEST(GraphProgram, FailsWithOneSentence) {
  const TempFolder folder;
  folder.write("bad.g2o", "VERTEX_SE2 0 0 0 nan\n");
  const auto bad = runGraph("--g2o " + folder.file("bad.g2o"));
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_NE(bad.output.find("bad.g2o:1: column 5 is 'nan'"), std::string::npos) << bad.output;
  EXPECT_EQ(std::count(bad.output.begin(), bad.output.end(), '\n'), 1) << bad.output;
  const auto missing = runGraph("--g2o " + folder.file("none.g2o"));
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.output.find("there is no file "), std::string::npos) << missing.output;
  EXPECT_EQ(runGraph("--world 1 --poses 30 --limit 2 --false-loops 1").exit_code, 1);
}

TEST(GraphProgram, RefusesWrongUseWithCodeTwo) {
  for (const auto* arguments :
       {"", "--world x", "--world 1 --g2o g.g2o", "--world 1 --kind odd", "--world 1 --poses 1",
        "--world 1 --truth t.txt", "--world 1 --sigma-heading 0", "--world 1 --false-loops -1"})
    EXPECT_EQ(runGraph(arguments).exit_code, 2) << arguments;
}

}  // namespace
}  // namespace slam::eval
