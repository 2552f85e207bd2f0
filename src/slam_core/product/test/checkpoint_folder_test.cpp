// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/checkpoint_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam {
namespace {

using test::contentOf;
using test::sentenceOf;

class CheckpointFolderTest : public testing::Test {
 protected:
  std::string file(const std::string& suffix = "") const {
    return folder / ("live/checkpoint" + suffix);
  }
  /// Resumes; contents that begin with "bad" cannot be used.
  CheckpointFolder::Resumption resume() {
    used.clear();
    return CheckpointFolder(folder / "live").resume([&](const std::string& bytes) {
      if (bytes.rfind("bad", 0) == 0) throw std::runtime_error("it is bad");
      used = bytes;
    });
  }

  const test::TemporaryFolder folder;
  std::string used;
};

TEST_F(CheckpointFolderTest, IsMadeAndHasNothingToResume) {
  const auto resumption = resume();
  EXPECT_EQ(resumption.file, "");
  EXPECT_EQ(resumption.warning, "");
}

TEST_F(CheckpointFolderTest, KeepsTheLastTwo) {
  for (const auto* content : {"1", "2", "3"}) CheckpointFolder(folder / "live").write(content);
  EXPECT_EQ(contentOf(file()), "3");
  EXPECT_EQ(contentOf(file(".previous")), "2");
  EXPECT_EQ(resume().file, file());
  EXPECT_EQ(used, "3");
}

TEST_F(CheckpointFolderTest, FallsBackToThePreviousOneAndKeepsWhatIsBad) {
  for (const auto* content : {"good", "bad 1"}) CheckpointFolder(folder / "live").write(content);
  const auto resumption = resume();
  EXPECT_EQ(used, "good");
  EXPECT_EQ(resumption.file, file(".previous"));
  EXPECT_EQ(resumption.warning, file() + ": it is bad");
  EXPECT_EQ(contentOf(file(".unused")), "bad 1");
  // the good one is not written over by what follows
  CheckpointFolder(folder / "live").write("bad 2");
  EXPECT_EQ(resume().file, file(".previous"));
  EXPECT_EQ(used, "good");
  EXPECT_EQ(contentOf(file(".unused.2")), "bad 2");
}

TEST_F(CheckpointFolderTest, NamesAllThatCannotBeUsedAndWritesOverNone) {
  for (const auto* content : {"bad 1", "bad 2"}) CheckpointFolder(folder / "live").write(content);
  const auto resumption = resume();
  EXPECT_EQ(resumption.file, "");
  EXPECT_EQ(resumption.warning, file() + ": it is bad; " + file(".previous") + ": it is bad");
  EXPECT_EQ(contentOf(file(".unused")), "bad 2");
  EXPECT_EQ(contentOf(file(".unused.2")), "bad 1");
  EXPECT_FALSE(std::filesystem::exists(file()));
}

/// A process may be killed after any of these steps.
TEST_F(CheckpointFolderTest, UsesWhatAKilledProcessHasLeft) {
  CheckpointFolder(folder / "live").write("1");
  std::filesystem::rename(file(), file(".previous"));
  std::ofstream(file(".new")) << "2";
  std::ofstream(file(".new.part17")) << "2";
  EXPECT_EQ(resume().file, file(".previous"));
  EXPECT_FALSE(std::filesystem::exists(file(".new")));
  EXPECT_FALSE(std::filesystem::exists(file(".new.part17")));
}

TEST_F(CheckpointFolderTest, KeepsTheLastOneOfAnEarlierProduct) {
  for (const auto* content : {"1", "2"}) CheckpointFolder(folder / "live").write(content);
  CheckpointFolder(folder / "live").beginAnew();
  EXPECT_EQ(contentOf(file(".before")), "2");
  EXPECT_EQ(resume().file, "");
  CheckpointFolder(folder / "live").beginAnew();
  EXPECT_EQ(contentOf(file(".before")), "2") << "nothing took its place";
}

TEST_F(CheckpointFolderTest, IsOfOneProductAtATime) {
  const CheckpointFolder first(folder / "live");
  EXPECT_TRUE(test::oneSays({sentenceOf([&] { CheckpointFolder(folder / "live"); })},
                            {"another run is writing into the folder", "live"}));
}

TEST_F(CheckpointFolderTest, SaysWhyItCannotBeMade) {
  const auto path = folder.write("file", "") + "/live";
  EXPECT_TRUE(test::oneSays({sentenceOf([&] { CheckpointFolder{path}; })},
                            {"cannot make the folder ", path.c_str()}));
}

TEST_F(CheckpointFolderTest, SaysWhyNothingCanBeWrittenAndKeepsWhatThereIs) {
  const CheckpointFolder live(folder / "live");
  EXPECT_EQ(live.fault(), "");
  std::filesystem::create_directory(file());
  EXPECT_NE(live.fault().find("cannot write " + file()), std::string::npos) << live.fault();
  EXPECT_NE(sentenceOf([&] { live.write("1"); }), "");
  std::filesystem::remove(file());
  live.write("1");
  std::filesystem::create_directory(file(".new"));
  EXPECT_NE(sentenceOf([&] { live.write("2"); }), "");
  EXPECT_EQ(contentOf(file()), "1");
}

}  // namespace
}  // namespace slam
