// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/run_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam {
namespace {

using test::contentOf;
using test::oneSays;
using test::sentenceOf;

class RunFolderTest : public testing::Test {
 protected:
  std::string old(const std::string& name) {
    std::filesystem::create_directories(folder / "run");
    return folder.write("run/" + name, "old");
  }
  static void add(const RunFolder& run, const std::string& name) {
    std::ofstream(run.unfinished() + "/" + name) << "new";
  }

  const test::TemporaryFolder folder;
};

/// What the process of another run says of a folder; it ends at once.
template <class Action>
bool refusedInAnotherProcess(Action&& action) {
  const auto child = ::fork();
  if (child == 0) ::_exit(sentenceOf(action).empty() ? 0 : 1);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 1;
}

TEST_F(RunFolderTest, TakesThePlaceOfAnEarlierRun) {
  const auto trajectory = old("trajectory.tum"), grid = old("map.yaml");
  const auto session = old("unmerged_2.session"), associations = old("associations.csv");
  const auto own = old("notes.txt"), renamed = old("unmerged_hall.session");
  RunFolder run(folder / "run");
  add(run, "trajectory.tum");
  add(run, "config.yaml");
  EXPECT_EQ(contentOf(trajectory), "old");
  EXPECT_EQ(contentOf(grid), "old");
  run.complete();
  EXPECT_EQ(contentOf(trajectory), "new");
  EXPECT_EQ(contentOf(folder / "run/config.yaml"), "new");
  for (const auto& former : {grid, session, associations})
    EXPECT_FALSE(std::filesystem::exists(former)) << former;
  for (const auto& kept : {own, renamed}) EXPECT_EQ(contentOf(kept), "old");
  EXPECT_FALSE(std::filesystem::exists(run.unfinished()));
}

/// The point map's nodelet writes its file when it ends, before or after the back-end's.
TEST_F(RunFolderTest, KeepsWhatAnotherPartOfTheRunHasWritten) {
  old("points.pcd");
  old("trajectory.tum");
  RunFolder run(folder / "run");
  add(run, "trajectory.tum");
  folder.write("run/points.tmp", "of the point map");
  std::filesystem::rename(folder / "run/points.tmp", folder / "run/points.pcd");
  run.complete();
  EXPECT_EQ(contentOf(folder / "run/points.pcd"), "of the point map");
}

TEST_F(RunFolderTest, ChangesNothingWhereAFolderIsInTheWay) {
  const auto trajectory = old("trajectory.tum");
  RunFolder run(folder / "run");
  add(run, "trajectory.tum");
  add(run, "map.pgm");
  std::filesystem::create_directory(folder / "run/map.pgm");
  EXPECT_TRUE(oneSays({sentenceOf([&] { run.complete(); })}, {"map.pgm", "Is a directory"}));
  EXPECT_EQ(contentOf(trajectory), "old");
}

TEST_F(RunFolderTest, FollowsNoLinkToAnUnfinishedRun) {
  std::filesystem::create_directories(folder / "run");
  std::filesystem::create_directories(folder / "victim");
  folder.write("victim/a", "of another person");
  std::filesystem::create_symlink(folder / "victim", folder / "run/unfinished_run");
  RunFolder run(folder / "run");
  add(run, "trajectory.tum");
  run.complete();
  EXPECT_EQ(contentOf(folder / "victim/a"), "of another person");
  EXPECT_EQ(contentOf(folder / "run/trajectory.tum"), "new");
}

TEST_F(RunFolderTest, IsLockedAgainstOtherProcessesAsLongAsItLives) {
  const auto path = folder / "run";
  const auto take = [&] { RunFolder other(path); };
  const auto join = [&] { FolderLock::requireNoOtherProcess(path); };
  {
    RunFolder run(path);
    EXPECT_TRUE(refusedInAnotherProcess(take));
    EXPECT_EQ(sentenceOf(join), "") << "the point map of this process adds a file";
    EXPECT_TRUE(std::filesystem::exists(run.unfinished())) << "as before";
  }
  EXPECT_FALSE(refusedInAnotherProcess(take));
  EXPECT_EQ(sentenceOf(join), "");
}

}  // namespace
}  // namespace slam
