// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"
#include "slam_core/product/autosave.hpp"
#include "slam_core/product/run_writer.hpp"

namespace slam {
namespace {

using test::contentOf;
using test::oneSays;
using test::sentenceOf;
namespace fs = std::filesystem;

/// Files by name.
std::map<std::string, std::string> contentsOf(const std::string& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::directory_iterator(folder))
    contents[entry.path().filename()] = contentOf(entry.path());
  return contents;
}

class ResumedWriterTest : public testing::Test {
 protected:
  ResumedWriterTest() {
    RunWriter writer(folder / "whole");
    write(0, kSteps, writer);
    finish(writer);
  }
  /// A step in ten has an event, one observations that are associated by place, one an image; time
  /// begins anew with some.
  static StepReport report(int i) {
    StepReport report;
    report.stamp = stampFromNanoseconds(1000000000 + 100000000LL * (i % 25));
    report.trigger = "observations";
    report.pose.pose = Pose2(0.1 * i, 1.0 / (1 + i), 0.01 * i);
    report.statistics.nis = i / 3.0;
    report.restarted = i > 0 && i % 25 == 0;
    if (i % 10 == 5)
      report.events.push_back({Event::Kind::kJump, 0.1, 0.2, "a test", report.stamp});
    if (i % 10 == 3) report.view = ViewStatistics{9, 8, 7, 1};
    if (i % 10 == 7) report.statistics.associations.push_back({1, 2, TakenFor::kLandmark});
    return report;
  }
  static void write(int from, int to, RunWriter& writer) {
    for (int i = from; i < to; ++i) writer.write(report(i));
  }
  static void finish(RunWriter& writer) { writer.finish({}, "map", "config: 1\n"); }
  static void resume(const std::string& state, RunWriter& writer) {
    ArchiveReader archive(state);
    writer.restoreState(archive);
  }
  /// Writes a checkpoint after `saved` steps and is cut off after `written`. @return the state
  std::string cutOff(const std::string& name, int saved, int written) const {
    auto writer = std::make_unique<RunWriter>(folder / name);
    write(0, saved, *writer);
    ArchiveWriter archive;
    writer->saveState(archive);
    const auto state = archive.take();
    std::ofstream(writer->unfinished() + "/checkpoint") << "of this test";
    std::ofstream(writer->unfinished() + "/checkpoint.part123") << "cut off";
    write(saved, written, *writer);
    return state;
  }

  static constexpr int kSteps = 60;
  const test::TemporaryFolder folder;
};

TEST_F(ResumedWriterTest, LeavesTheSameFilesWhereverItWasSavedAndCutOff) {
  const auto whole = contentsOf(folder / "whole");
  for (const int saved : {1, 5, 6, 8, 24, 25, 26, 51})
    for (const int more : {0, 1, 7}) {
      const auto name = "run" + std::to_string(saved) + "_" + std::to_string(more);
      const auto state = cutOff(name, saved, saved + more);
      RunWriter writer(folder / name, RunWriter::Start::kResumed);
      resume(state, writer);
      write(saved, kSteps, writer);
      finish(writer);
      EXPECT_EQ(contentsOf(folder / name), whole) << name;
    }
}

TEST_F(ResumedWriterTest, TakesBackWhatTheEndHadMovedAlready) {
  const auto state = cutOff("run", 40, 60);
  fs::rename(folder / "run/unfinished_run/trajectory.tum", folder / "run/trajectory.tum");
  RunWriter writer(folder / "run", RunWriter::Start::kResumed);
  resume(state, writer);
  write(40, kSteps, writer);
  finish(writer);
  EXPECT_EQ(contentsOf(folder / "run"), contentsOf(folder / "whole"));
}

TEST_F(ResumedWriterTest, RefusesFilesThatWereShortenedMeanwhile) {
  const auto state = cutOff("run", 40, 45);
  fs::resize_file(folder / "run/unfinished_run/updates.csv", 100);
  RunWriter writer(folder / "run", RunWriter::Start::kResumed);
  EXPECT_TRUE(oneSays({sentenceOf([&] { resume(state, writer); })},
                      {"cannot be resumed", "updates.csv", "shorter", "run anew"}));
}

TEST_F(ResumedWriterTest, OfAFolderWithoutACheckpointIsRefused) {
  for (const auto* name : {"whole", "empty"})
    EXPECT_TRUE(oneSays({sentenceOf([&] { RunWriter(folder / name, RunWriter::Start::kResumed); })},
                        {"there is no checkpoint", name, "run anew"}));
  EXPECT_FALSE(contentsOf(folder / "whole").empty());
}

TEST_F(ResumedWriterTest, ThatGoesNoFurtherLosesNothing) {
  const auto state = cutOff("run", 1, 1);
  { RunWriter(folder / "run", RunWriter::Start::kResumed); }
  RunWriter writer(folder / "run", RunWriter::Start::kResumed);
  resume(state, writer);
  write(1, kSteps, writer);
  finish(writer);
  EXPECT_EQ(contentsOf(folder / "run"), contentsOf(folder / "whole"));
}

Stamp at(double time) { return Stamp(durationFromSeconds(time)); }

TEST(Autosave, IsDueAfterEachIntervalOfStampsAheadOrBack) {
  const test::TemporaryFolder folder;
  Autosave autosave(10.0);
  EXPECT_FALSE(autosave.isDue(at(100.0)));
  EXPECT_FALSE(autosave.isDue(at(109.9)));
  EXPECT_TRUE(autosave.isDue(at(110.0)));
  EXPECT_EQ(autosave.save(at(110.0), folder / "checkpoint", [] { return "x"; }), "");
  EXPECT_FALSE(autosave.isDue(at(119.0)));
  EXPECT_TRUE(autosave.isDue(at(5.0))) << "time began anew";
  EXPECT_FALSE(Autosave().isDue(at(1e9)));
}

TEST(Autosave, SaysOnceThatItCannotWriteAndKeepsTheLastCheckpoint) {
  const test::TemporaryFolder folder;
  Autosave autosave(1.0);
  const auto path = folder / "checkpoint";
  EXPECT_EQ(autosave.save(at(1.0), path, [] { return "good"; }), "");
  const auto fail = []() -> std::string { throw std::runtime_error("the disk is full"); };
  EXPECT_EQ(autosave.save(at(2.0), path, fail),
            "no checkpoint could be written, the last one stays: the disk is full");
  EXPECT_EQ(autosave.save(at(3.0), path, fail), "");
  EXPECT_EQ(contentOf(path), "good");
  EXPECT_EQ(autosave.save(at(4.0), path, [] { return "better"; }), "");
  EXPECT_EQ(contentOf(path), "better");
  EXPECT_NE(autosave.save(at(5.0), folder / "no/such/folder", [] { return "x"; }), "");
}

}  // namespace
}  // namespace slam
