// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "slam_ros/flow_window.hpp"
#include "slam_ros/product_files.hpp"
#include "slam_ros/run_metrics.hpp"

namespace slam_ros {
namespace {

constexpr FlowWindow::Timeout kShort(20), kLong(20000);

slam::Stamp stamp(int ns) { return slam::stampFromNanoseconds(ns); }

TEST(MeanEntropy, IsOfTheKnownCellsOnly) {
  slam::OccupancyGrid grid;
  EXPECT_FALSE(meanEntropy(grid));
  grid.cells = {slam::OccupancyGrid::kUnknown, slam::OccupancyGrid::kUnknown};
  EXPECT_FALSE(meanEntropy(grid));
  grid.cells = {slam::OccupancyGrid::kUnknown, 0, 100};
  EXPECT_DOUBLE_EQ(*meanEntropy(grid), 0.0);
  grid.cells = {50, 0, slam::OccupancyGrid::kUnknown};
  EXPECT_DOUBLE_EQ(*meanEntropy(grid), 0.5);
  grid.cells = {25, 75};
  EXPECT_NEAR(*meanEntropy(grid), 0.811278, 1e-6);
  RunMetrics metrics;
  EXPECT_EQ(metrics.toJson(slam::Duration(1), 0).find("map_entropy_bits"), std::string::npos);
  metrics.setGrid(grid);
  EXPECT_NE(metrics.toJson(slam::Duration(1), 0).find("map_entropy_bits"), std::string::npos);
}

TEST(AlarmTime, CountsAlarmsAndTheTimeThatTheyLast) {
  RunMetrics metrics;
  const auto json = [&] { return nlohmann::json::parse(metrics.toJson(slam::Duration(1), 0)); };
  EXPECT_FALSE(json().contains("lost_alarms")) << "before the first step";
  const auto at = [](int s) { return slam::stampFromNanoseconds(s * 1000000000LL); };
  using slam::Trust;
  metrics.addTrust(at(99), Trust::kUnknown);
  EXPECT_FALSE(json().contains("lost_alarms")) << "of a back-end that cannot tell";
  metrics.addTrust(at(100), Trust::kConfident);
  EXPECT_EQ(json()["lost_alarms"], 0);
  EXPECT_FALSE(json().contains("lost_first_s"));
  EXPECT_EQ(json()["lost_share_of_time"], 0.0);
  for (const int s : {102, 103, 104}) metrics.addTrust(at(s), Trust::kLost);
  metrics.addTrust(at(106), Trust::kDoubtful);
  metrics.addTrust(at(109), Trust::kLost);
  metrics.addTrust(at(110), Trust::kLost);
  EXPECT_EQ(json()["lost_alarms"], 2);
  EXPECT_DOUBLE_EQ(json()["lost_first_s"], 2.0);
  EXPECT_DOUBLE_EQ(json()["lost_share_of_time"], 0.5);
  EXPECT_DOUBLE_EQ(json()["doubtful_share_of_time"], 0.3);
}

TEST(FlowWindow, IsFullForOneInputOnlyUntilAcknowledged) {
  FlowWindow window(2);
  for (int ns : {1, 2}) window.sent("motion", stamp(ns));
  EXPECT_FALSE(window.waitForRoom("motion", kShort));
  EXPECT_TRUE(window.waitForRoom("observations", kShort));
  window.acknowledged("motion", stamp(1));
  EXPECT_TRUE(window.waitForRoom("motion", kShort));
  EXPECT_EQ(window.inFlight(), 1u);
}

TEST(FlowWindow, AnInputOfLargeMessagesHasAWindowOfItsOwn) {
  FlowWindow window(3);
  window.limit("observations", 1);
  window.sent("motion", stamp(1));
  window.sent("observations", stamp(1));
  EXPECT_TRUE(window.waitForRoom("motion", kShort));
  EXPECT_FALSE(window.waitForRoom("observations", kShort));
}

TEST(FlowWindow, AnAcknowledgementCoversEverythingBefore) {
  FlowWindow window(10);
  for (int ns : {1, 2, 3}) window.sent("motion", stamp(ns));
  window.acknowledged("motion", stamp(2));
  EXPECT_EQ(window.inFlight(), 1u);
  EXPECT_FALSE(window.waitUntilEmpty(kShort));
  window.acknowledged("motion", stamp(5));
  EXPECT_TRUE(window.waitUntilEmpty(kShort));
}

TEST(FlowWindow, WaitsAsLongAsAnythingIsAcknowledged) {
  FlowWindow window(10);
  for (int ns = 1; ns <= 5; ++ns) window.sent("motion", stamp(ns));
  std::thread other([&] {
    for (int ns = 1; ns <= 5; ++ns) {
      std::this_thread::sleep_for(std::chrono::milliseconds(60));
      window.acknowledged("motion", stamp(ns));
    }
  });
  EXPECT_TRUE(window.waitUntilEmpty(FlowWindow::Timeout(200)));
  other.join();
}

TEST(FlowWindow, WaitsForTheSlowestInput) {
  FlowWindow window(10);
  window.sent("observations", stamp(5));
  window.sent("scans", stamp(8));
  EXPECT_TRUE(window.waitForAllBefore(stamp(5), kShort));
  EXPECT_FALSE(window.waitForAllBefore(stamp(6), kShort));
  window.acknowledged("observations", stamp(5));
  EXPECT_TRUE(window.waitForAllBefore(stamp(8), kShort));
}

TEST(FlowWindow, StopEndsTheWait) {
  FlowWindow window(1);
  window.sent("motion", stamp(1));
  std::thread other([&] { window.stop(); });
  EXPECT_FALSE(window.waitForRoom("motion", kLong));
  other.join();
}

TEST(Percentile, LiesBetweenNeighboursInAnyOrder) {
  EXPECT_DOUBLE_EQ(percentile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(percentile({4, 1, 3, 2}, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(percentile({4, 1, 3, 2}, 1.0), 4.0);
  EXPECT_DOUBLE_EQ(percentile({7}, 0.99), 7.0);
  EXPECT_NEAR(percentile({0, 10}, 0.99), 9.9, 1e-12);
  EXPECT_THROW(percentile({}, 0.5), std::invalid_argument);
}

TEST(RunMetrics, LeavesUpdateTimesOutWhenThereWasNone) {
  const RunMetrics metrics;
  const auto json = nlohmann::json::parse(metrics.toJson(std::chrono::seconds(10), 3));
  EXPECT_EQ(json["updates"], 0);
  EXPECT_EQ(json["dropped_messages"], 3);
  EXPECT_FALSE(json.contains("update_ms_p50"));
}

TEST(RunMetrics, CountsEventsAndKeepsTheLargestJump) {
  RunMetrics metrics;
  slam::StepReport report;
  metrics.addEvents(report);
  auto json = nlohmann::json::parse(metrics.toJson(slam::Duration(1), 0));
  EXPECT_EQ(json["events"], 0);
  EXPECT_FALSE(json.contains("largest_jump_m")) << "no step has a motion to compare with";
  report.correction = {0.5, 0.1};
  report.events.resize(2);
  metrics.addEvents(report);
  report.correction = {0.2, 0.3};
  report.events.clear();
  metrics.addEvents(report);
  json = nlohmann::json::parse(metrics.toJson(slam::Duration(1), 0));
  EXPECT_EQ(json["events"], 2);
  EXPECT_EQ(json["largest_jump_m"], 0.5);
}

TEST(RunMetrics, GivesUpdateTimesInMilliseconds) {
  RunMetrics metrics;
  for (int us : {1000, 2000, 3000}) metrics.addUpdate(std::chrono::microseconds(us));
  const auto json = nlohmann::json::parse(metrics.toJson(std::chrono::seconds(10), 0));
  EXPECT_DOUBLE_EQ(json["update_ms_p50"].get<double>(), 2.0);
  EXPECT_NEAR(json["update_ms_p99"].get<double>(), 2.98, 1e-9);
}

TEST(RunMetrics, TheLatencyOfAStepIsThatOfItsInputsAndItsOwn) {
  using std::chrono::milliseconds;
  RunMetrics metrics;
  EXPECT_EQ(metrics.toJson(slam::Duration(1), 0).find("latency"), std::string::npos);
  metrics.addFrontEnd(stamp(1), milliseconds(7));  // no step came of it
  metrics.addFrontEnd(stamp(2), milliseconds(10));
  metrics.addFrontEnd(stamp(2), milliseconds(20));
  metrics.addFrontEnd(stamp(3), milliseconds(40));
  metrics.addLatency(stamp(2), milliseconds(5));
  metrics.addLatency(stamp(2), milliseconds(5));  // as a scan of the same stamp
  const auto json = nlohmann::json::parse(metrics.toJson(std::chrono::seconds(10), 0));
  EXPECT_DOUBLE_EQ(json["latency_ms_p50"].get<double>(), 20.0);
  EXPECT_NEAR(json["latency_ms_p99"].get<double>(), 34.7, 1e-9);
}

TEST(ConfigFile, AnUnknownNameIsAnsweredWithTheKnownOnes) {
  EXPECT_EQ(findConfigFile("/nowhere", "robot", "my/robot.yaml"), "my/robot.yaml");
  try {
    findConfigFile("/nowhere", "robot", "mine");
    FAIL();
  } catch (const UnknownName& error) {
    EXPECT_NE(std::string(error.what()).find("there is no robot 'mine'"), std::string::npos);
  }
}

TEST(ConfigFile, TheFirstFolderThatHasTheNameCounts) {
  const std::string root = testing::TempDir() + "slam_ros_config_file/";
  std::filesystem::remove_all(root);
  for (const std::string folder : {"shipped", "own"})
    std::filesystem::create_directories(root + folder);
  for (const std::string file : {"shipped/a.yaml", "own/a.yaml", "own/b.yaml"})
    std::ofstream(root + file) << "version: 1\n";
  const std::vector<std::string> folders = {root + "shipped", "/nowhere", root + "own"};
  EXPECT_EQ(findConfigFile(folders, "product", "a"), root + "shipped/a.yaml");
  EXPECT_EQ(findConfigFile(folders, "product", "b"), root + "own/b.yaml");
  try {
    findConfigFile(folders, "product", "c");
    FAIL();
  } catch (const UnknownName& error) {
    EXPECT_NE(std::string(error.what()).find("there are: a, b"), std::string::npos);
  }
}

}  // namespace
}  // namespace slam_ros
