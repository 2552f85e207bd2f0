// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "slam_core/common/settings.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam {
namespace {

using test::sentenceOf;
using test::TemporaryFolder;

std::string pipeIn(const TemporaryFolder& folder) {
  const auto path = folder / "pipe";
  EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
  return path;
}

TEST(InputFile, IsReadWholeAndThroughALink) {
  const TemporaryFolder folder;
  const std::string content(200'000, 'x');
  const auto path = folder.write("a.txt", content);
  EXPECT_EQ(readInputFile(path), content);
  EXPECT_EQ(readInputFile(folder.write("empty", "")), "");
  std::filesystem::create_symlink(path, folder / "link");
  EXPECT_EQ(readInputFile(folder / "link"), content);
  EXPECT_EQ(inputFileFault(folder / "link"), "");
}

TEST(InputFile, APipeThatNobodyWritesToIsRefusedAtOnce) {
  const TemporaryFolder folder;
  const auto path = pipeIn(folder);
  EXPECT_EQ(sentenceOf([&] { requireInputFile(path, "the bag"); }),
            "cannot read the bag " + path + ": it is a named pipe, not a regular file");
  EXPECT_EQ(sentenceOf([&] { readInputFile(path); }),
            "cannot read the file " + path + ": it is a named pipe, not a regular file");
  EXPECT_TRUE(
      test::oneSays(test::faultsOf([&] { loadConfigFile(path); }), {path.c_str(), "named pipe"}));
}

TEST(InputFile, SaysWhatElseCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_EQ(sentenceOf([&] { requireInputFile(""); }),
            "cannot read the file '': its name is empty");
  EXPECT_EQ(inputFileFault(folder / ""), "it is a folder, not a file");
  EXPECT_EQ(inputFileFault("/dev/zero"), "it is a device, not a regular file");
  EXPECT_EQ(sentenceOf([&] { requireInputFile(folder / "none", "the log"); }),
            "cannot read the log " + (folder / "none") + "; does it exist?");
  std::filesystem::create_symlink(folder / "none", folder / "dangling");
  EXPECT_NE(inputFileFault(folder / "dangling"), "");
  EXPECT_EQ(inputFileFault(folder.write("a", "") + "/b"), "Not a directory");
}

TEST(InputFile, OfMoreThanItMayHoldIsNotReadToItsEnd) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.txt", std::string(1000, 'x'));
  EXPECT_EQ(readInputFile(path, "the file", 1000).size(), 1000u);
  EXPECT_TRUE(test::oneSays({sentenceOf([&] { readInputFile(path, "the file", 999); })},
                            {path.c_str(), "more than 999 bytes"}));
}

}  // namespace
}  // namespace slam
