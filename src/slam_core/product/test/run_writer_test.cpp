// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/run_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/estimator.hpp"
#include "slam_core/product/graph_file.hpp"
#include "slam_core/product/landmark_file.hpp"

namespace slam {
namespace {

using test::contentOf;
using test::oneSays;
using test::sentenceOf;

const std::vector<std::string> kFiles = {"trajectory.tum", "trajectory_final.tum", "odometry.tum",
                                         "updates.csv",    "events.csv",           "landmarks.yaml",
                                         "config.yaml"};

std::size_t linesOf(const std::string& path) {
  const auto content = contentOf(path);
  return std::size_t(std::count(content.begin(), content.end(), '\n'));
}

class RunWriterTest : public testing::Test {
 protected:
  /// A simulated run of `steps`, played `times` times in a row, written to `name`.
  std::string run(const std::string& name, int steps, int times = 1) {
    Estimator estimator;
    Settings settings;
    estimator.use(Registry<Backend>::instance().create("ekf"));
    estimator.configure(settings);
    RunWriter writer(folder / name);
    for (int time = 0; time < times; ++time) {
      test::SimulatedWorld world(3);
      for (int i = 0; i < steps; ++i) {
        const auto step = world.next();
        estimator.set(step.motion);
        estimator.set(step.observations);
        do {
          estimator.execute();
          if (estimator.report()) writer.write(*estimator.report());
        } while (estimator.report());
      }
    }
    EXPECT_EQ(writer.lines(), std::size_t(steps));
    writer.finish(estimator.capabilities(), "map", settings.inForce());
    return writer.folder();
  }

  const test::TemporaryFolder folder;
};

TEST(TumLine, HasNineDecimalsAndAHalfAngleQuaternion) {
  EXPECT_EQ(tumLine(stampFromNanoseconds(1288971842000000345), Pose2(1.5, -2, M_PI / 2)),
            "1288971842.000000345 1.500000000 -2.000000000 0.000000000 0.000000000 0.000000000 "
            "0.707106781 0.707106781\n");
  EXPECT_EQ(tumLine(stampFromNanoseconds(5), Pose2(-0.0, -0.0, -0.0)),
            "0.000000005 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 "
            "1.000000000\n");
}

TEST_F(RunWriterTest, WritesTheSameBytesForTheSameRun) {
  const auto first = run("first", 70), second = run("second", 70);
  for (const auto& file : kFiles) {
    EXPECT_FALSE(contentOf(first + "/" + file).empty()) << file;
    EXPECT_EQ(contentOf(first + "/" + file), contentOf(second + "/" + file)) << file;
  }
}

TEST_F(RunWriterTest, WritesOneLineForEachStampOfObservations) {
  const auto path = run("run", 70);
  EXPECT_EQ(linesOf(path + "/trajectory.tum"), 70u);
  EXPECT_EQ(linesOf(path + "/odometry.tum"), 70u);
  EXPECT_EQ(linesOf(path + "/updates.csv"), 71u) << "and the header";
  EXPECT_EQ(contentOf(path + "/trajectory_final.tum"), contentOf(path + "/trajectory.tum"));
  const auto loaded = loadLandmarks(path + "/landmarks.yaml", "map");
  EXPECT_EQ(nanoseconds(loaded.stamp), 1007000000000);
  EXPECT_NE(contentOf(path + "/config.yaml").find("gate_probability"), std::string::npos);
}

TEST_F(RunWriterTest, WritesEveryColumnOfAnUpdate) {
  RunWriter writer(folder / "run");
  StepReport report;
  report.stamp = stampFromNanoseconds(1500000000);
  report.pose.covariance << 1, 0.2, 0.3, 0.2, 4, 0.5, 0.3, 0.5, 6;
  auto& statistics = report.statistics;
  statistics.nis = 7.5;
  statistics.nis_dof = 4;
  statistics.used = 2;
  statistics.gated = 3;
  statistics.added = 5;
  statistics.unknown = 6;
  statistics.landmarks = 9;
  report.trigger = "observations";
  writer.write(report);
  report.trigger = "";  // a carry of motion
  writer.write(report);
  Settings settings;
  const auto backend = Registry<Backend>::instance().create("ekf");
  backend->configure(settings);
  writer.finish(capabilitiesOf(*backend), "map", "");
  EXPECT_EQ(contentOf(folder / "run/updates.csv"),
            "stamp,cov_xx,cov_xy,cov_xt,cov_yy,cov_yt,cov_tt,nis,nis_dof,used,gated,added,unknown,"
            "landmarks\n1.500000000,1,0.2,0.3,4,0.5,6,7.5,4,2,3,5,6,9\n");
}

TEST_F(RunWriterTest, WritesWhatBecameOfTheFeaturesOfEachImage) {
  RunWriter writer(folder / "run");
  StepReport report;
  report.stamp = stampFromNanoseconds(1500000000);
  report.trigger = "camera";
  writer.write(report);
  EXPECT_FALSE(std::filesystem::exists(writer.unfinished() + "/views.csv")) << "nothing was seen";
  report.stamp = stampFromNanoseconds(2500000000);
  report.view = ViewStatistics{300, 40, 35, 2};
  writer.write(report);
  const auto backend = Registry<Backend>::instance().create("ekf");
  writer.finish(capabilitiesOf(*backend), "map", "");
  EXPECT_EQ(contentOf(folder / "run/views.csv"),
            "stamp,features,expected,matched,rejected\n2.500000000,300,40,35,2\n");
}

TEST_F(RunWriterTest, KeepsTheImagesBeforeARestart) {
  RunWriter writer(folder / "run");
  StepReport report;
  report.trigger = "camera";
  report.view = ViewStatistics{300, 40, 35, 2};
  writer.write(report);
  report.restarted = true;
  report.view->matched = 12;
  writer.write(report);
  const auto backend = Registry<Backend>::instance().create("ekf");
  writer.finish(capabilitiesOf(*backend), "map", "");
  const std::string header = "stamp,features,expected,matched,rejected\n";
  EXPECT_EQ(contentOf(folder / "run/views.before_restart_1.csv"),
            header + "0.000000000,300,40,35,2\n");
  EXPECT_EQ(contentOf(folder / "run/views.csv"), header + "0.000000000,300,40,12,2\n");
}

TEST_F(RunWriterTest, WritesTheEventsOfAllStepsAlsoOfThoseOfOneStamp) {
  RunWriter writer(folder / "run");
  StepReport report;
  report.stamp = stampFromNanoseconds(1500000000);
  report.trigger = "observations";
  report.events = {
      {Event::Kind::kLost, 0.0, 0.0, "what is seen contradicts the map", report.stamp}};
  writer.write(report);
  report.trigger = "scan";
  report.events = {{Event::Kind::kJump, 0.25, 0.5, "the robot was put there", report.stamp}};
  writer.write(report);
  const auto backend = Registry<Backend>::instance().create("graph");
  Settings settings;
  backend->configure(settings);
  writer.finish(capabilitiesOf(*backend), "map", "");
  EXPECT_EQ(contentOf(folder / "run/events.csv"),
            "stamp,kind,distance,turn,reason\n"
            "1.500000000,lost,0.000000,0.000000,\"what is seen contradicts the map\"\n"
            "1.500000000,jump,0.250000,0.500000,\"the robot was put there\"\n");
  EXPECT_EQ(contentOf(folder / "run/graph.csv"), "kind,x0,y0,x1,y1,weight\n") << "empty so far";
}

TEST(GraphTable, HasALineForEachPlaceAndEdge) {
  GraphView graph;
  graph.nodes = {Pose2(-0.0, 1.5, 0.3)};
  graph.submaps = {Pose2(1, 2, 0)};
  graph.edges = {{GraphEdge::Kind::kWaitingLoop, {1, 2}, {3, 4.25}, 0.0},
                 {GraphEdge::Kind::kLoop, {1, 2}, {3, 4}, 0.5}};
  EXPECT_EQ(graphTable(graph),
            "kind,x0,y0,x1,y1,weight\n"
            "node,0.0000,1.5000,0.0000,1.5000,1.0000\n"
            "submap,1.0000,2.0000,1.0000,2.0000,1.0000\n"
            "waiting_loop,1.0000,2.0000,3.0000,4.2500,0.0000\n"
            "loop,1.0000,2.0000,3.0000,4.0000,0.5000\n");
}

TEST_F(RunWriterTest, WritesOneLineForObservationsAndAScanOfTheSameStamp) {
  RunWriter writer(folder / "run");
  StepReport report;
  const auto write = [&](int second, const std::string& trigger, double x) {
    report.stamp = stampFromNanoseconds(1000000000LL * second);
    report.trigger = trigger;
    report.pose.pose = {x, 0, 0};
    report.statistics.nis_dof = trigger == "observations" ? 2 : 0;
    writer.write(report);
  };
  write(1, "observations", 1.0);
  write(1, "scan", 1.5);
  write(2, "scan", 2.0);
  write(3, "", 3.0);
  EXPECT_EQ(writer.lines(), 2u);
  Settings settings;
  const auto backend = Registry<Backend>::instance().create("ekf");
  backend->configure(settings);
  writer.finish(capabilitiesOf(*backend), "map", "");
  EXPECT_EQ(contentOf(folder / "run/trajectory.tum"),
            tumLine(stampFromNanoseconds(1000000000), {1.5, 0, 0}) +
                tumLine(stampFromNanoseconds(2000000000), {2, 0, 0}));
  const auto updates = contentOf(folder / "run/updates.csv");
  EXPECT_NE(updates.find("1.000000000,0,0,0,0,0,0,0,2,"), std::string::npos)
      << "the observations' statistics are kept: " << updates;
}

TEST_F(RunWriterTest, BeginsAnewWithARestart) {
  const auto once = run("once", 70), twice = run("twice", 70, 2);
  for (const auto& file : kFiles)
    EXPECT_EQ(contentOf(once + "/" + file), contentOf(twice + "/" + file)) << file;
}

TEST_F(RunWriterTest, NothingOfALongRunIsLeftAfterARestart) {
  StepReport report;
  report.trigger = "observations";
  RunWriter writer(folder / "run");
  for (int i = 0; i < 1000; ++i) {
    report.stamp = stampFromNanoseconds(1000000000LL * (i + 100));
    writer.write(report);
  }
  report.stamp = stampFromNanoseconds(1);
  report.restarted = true;
  writer.write(report);
  Estimator estimator;
  Settings settings;
  estimator.use(Registry<Backend>::instance().create("ekf"));
  estimator.configure(settings);
  writer.finish(estimator.capabilities(), "map", "");
  for (const auto* name : {"trajectory.tum", "odometry.tum", "trajectory_final.tum"})
    EXPECT_EQ(contentOf(folder / (std::string("run/") + name)), tumLine(report.stamp, Pose2()));
  EXPECT_EQ(linesOf(folder / "run/updates.csv"), 2u) << "its header and a line";
}

TEST_F(RunWriterTest, KeepsWhatWasWrittenBeforeARestart) {
  const auto once = run("once", 70), thrice = run("thrice", 70, 3);
  for (const std::string name : {"trajectory", "odometry", "updates", "events"})
    for (const std::string number : {"1", "2"}) {
      const auto ending = name == "updates" || name == "events" ? ".csv" : ".tum";
      EXPECT_EQ(contentOf(thrice + "/" + name + ".before_restart_" + number + ending),
                contentOf(once + "/" + name + ending));
    }
  EXPECT_FALSE(std::filesystem::exists(thrice + "/trajectory.before_restart_3.tum"));
  run("thrice", 70);
  EXPECT_FALSE(std::filesystem::exists(thrice + "/trajectory.before_restart_1.tum"))
      << "it is of an earlier run";
}

TEST_F(RunWriterTest, KeepsTheLastHundredRestarts) {
  RunWriter writer(folder / "run");
  StepReport report;
  report.trigger = "observations";
  for (int i = 0; i < 120; ++i) {
    writer.write(report);
    writer.restart();
    writer.restart();  // with nothing to keep
  }
  const auto kept = [&](int number) {
    return std::filesystem::exists(writer.unfinished() + "/trajectory.before_restart_" +
                                   std::to_string(number) + ".tum");
  };
  EXPECT_FALSE(kept(20));
  EXPECT_TRUE(kept(21));
  EXPECT_TRUE(kept(120));
  EXPECT_FALSE(kept(121));
}

TEST_F(RunWriterTest, ReplacesAnEarlierRunOnceItIsComplete) {
  run("run", 5);
  const auto results = {"metrics.json",
                        "map.png",
                        "trajectory.png",
                        "odometry.png",
                        "consistency.png",
                        "landmark_errors.png",
                        "map.pgm",
                        "map.yaml",
                        "points.pcd",
                        "ground_truth.tum",
                        "ground_truth_landmarks.yaml",
                        "report.html"};
  for (const auto* name : results) folder.write(std::string("run/") + name, "{}");
  const auto own = folder.write("run/notes.txt", "of the user");
  {
    const RunWriter writer(folder / "run");
    for (const auto* name : results)
      EXPECT_EQ(contentOf(folder / (std::string("run/") + name)), "{}") << name;
  }
  EXPECT_EQ(linesOf(folder / "run/trajectory.tum"), 5u);
  EXPECT_TRUE(std::filesystem::exists(folder / "run/landmarks.yaml"));
  run("run", 7);
  for (const auto* name : results)
    EXPECT_FALSE(std::filesystem::exists(folder / (std::string("run/") + name))) << name;
  EXPECT_TRUE(std::filesystem::exists(own));
  EXPECT_EQ(linesOf(folder / "run/trajectory.tum"), 7u);
  EXPECT_FALSE(std::filesystem::exists(folder / "run/unfinished_run"));
}

TEST_F(RunWriterTest, WithoutItsEndLeavesTheFilesOfAnEarlierRunAsTheyWere) {
  run("run", 5);
  const auto content = [&](const char* name) {
    return contentOf(folder / (std::string("run/") + name));
  };
  std::map<std::string, std::string> before;
  for (const auto& name : kFiles) before[name] = content(name.c_str());
  {
    StepReport report;
    report.trigger = "observations";
    RunWriter writer(folder / "run");
    for (int i = 0; i < 100; ++i) {
      report.stamp = stampFromNanoseconds(1000000000LL * (i + 100));
      writer.write(report);
    }
    std::ofstream(writer.unfinished() + "/points.pcd") << "of a run that did not end well";
  }
  for (const auto& name : kFiles) EXPECT_EQ(content(name.c_str()), before[name]) << name;
  EXPECT_FALSE(std::filesystem::exists(folder / "run/points.pcd"));
  EXPECT_GT(linesOf(folder / "run/unfinished_run/trajectory.tum"), 50u) << "it may be of use";
  run("run", 3);
  EXPECT_EQ(linesOf(folder / "run/trajectory.tum"), 3u);
  EXPECT_FALSE(std::filesystem::exists(folder / "run/unfinished_run"));
}

TEST_F(RunWriterTest, RefusesAFolderThatAnotherRunIsWritingInto) {
  {
    const RunWriter first(folder / "run");
    EXPECT_TRUE(oneSays({sentenceOf([&] { RunWriter second(folder / "run"); })},
                        {(folder / "run").c_str(), "another run is writing"}));
    EXPECT_TRUE(std::filesystem::exists(first.unfinished() + "/trajectory.tum"));
    const RunWriter elsewhere(folder / "run2");
  }
  const RunWriter after(folder / "run");
}

TEST_F(RunWriterTest, SaysWhyItCannotWrite) {
  folder.write("a_file", "");
  const auto below_a_file = folder / "a_file/run";
  EXPECT_TRUE(oneSays({sentenceOf([&] { RunWriter{below_a_file}; })},
                      {below_a_file.c_str(), "Not a directory"}));
  std::filesystem::create_directories(folder / "run/odometry.tum");  // in the way of a file
  EXPECT_TRUE(oneSays({sentenceOf([&] { RunWriter{folder / "run"}; })},
                      {"odometry.tum", "Is a directory"}));
}

TEST_F(RunWriterTest, SaysThatTheDiskIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  RunWriter writer(folder / "run");
  std::filesystem::remove(writer.unfinished() + "/trajectory.tum");
  std::filesystem::create_symlink("/dev/full", writer.unfinished() + "/trajectory.tum");
  StepReport report;
  report.restarted = true;  // its files are opened anew
  report.trigger = "observations";
  writer.write(report);
  report.restarted = false;
  EXPECT_TRUE(oneSays({sentenceOf([&] {
                        for (int i = 0; i < 1000; ++i) {
                          report.stamp += std::chrono::seconds(1);
                          writer.write(report);
                        }
                      })},
                      {(folder / "run").c_str(), "disk full"}));
}

}  // namespace
}  // namespace slam
