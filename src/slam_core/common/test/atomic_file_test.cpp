// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam {
namespace {

using test::contentOf;
using test::sentenceOf;
using test::TemporaryFolder;

/// Files may not grow beyond `bytes`: a write stops in the middle, as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

TEST(AtomicFile, ReplacesTheWholeContent) {
  const TemporaryFolder folder;
  const auto path = folder.write("map.yaml", "a long old content");
  writeFileAtomically(path, "new\n");
  EXPECT_EQ(contentOf(path), "new\n");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, KeepsTheOldContentWhenSpaceRunsOut) {
  const TemporaryFolder folder;
  const auto path = folder.write("map.yaml", "old");
  std::string sentence;
  {
    const FileSizeLimit limit(5000);
    sentence = sentenceOf([&] { writeFileAtomically(path, std::string(20000, 'x')); });
  }
  EXPECT_TRUE(test::oneSays({sentence}, {path.c_str(), "File too large", "as it was before"}));
  EXPECT_EQ(contentOf(path), "old");
  EXPECT_EQ(folder.files(), 1u) << "the unfinished file must not stay";
}

TEST(AtomicFile, KeepsTheOldContentWhenTheFolderIsNotWritable) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder folder;
  const auto path = folder.write("map.yaml", "old");
  std::filesystem::permissions(folder / "", std::filesystem::perms(0555));
  EXPECT_TRUE(test::oneSays({sentenceOf([&] { writeFileAtomically(path, "new"); })},
                            {path.c_str(), "Permission denied"}));
  std::filesystem::permissions(folder / "", std::filesystem::perms(0755));
  EXPECT_EQ(contentOf(path), "old");
}

TEST(AtomicFile, SaysThatTheFolderIsMissing) {
  const TemporaryFolder folder;
  const auto path = folder / "nowhere/map.yaml";
  EXPECT_EQ(sentenceOf([&] { writeFileAtomically(path, "new"); }),
            "cannot write " + path + ": No such file or directory");
}

TEST(AtomicFile, DoesNotReplaceAFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "map.yaml");
  EXPECT_EQ(sentenceOf([&] { writeFileAtomically(folder / "map.yaml", "new"); }),
            "cannot write " + (folder / "map.yaml") + ": Is a directory");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, DoesNotReplaceADevice) {
  const TemporaryFolder folder;
  const auto path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  EXPECT_TRUE(test::oneSays({sentenceOf([&] { writeFileAtomically(path, "new"); })},
                            {path.c_str(), "no ordinary file"}));
  EXPECT_TRUE(std::filesystem::is_fifo(path));
  EXPECT_EQ(folder.files(), 1u);
}

/// In a folder like /tmp others may have put links under the names to come.
TEST(AtomicFile, FollowsNoLinkUnderTheNameOfItsTemporaryFile) {
  const TemporaryFolder folder;
  const auto victim = folder.write("victim", "of another person");
  const auto path = folder / "map.yaml";
  const auto first = path + ".part" + std::to_string(getpid());
  std::filesystem::create_symlink(victim, first);
  std::filesystem::create_symlink(victim, first + ".1");
  writeFileAtomically(path, "new");
  requireWritable(path);
  const auto temporary = makeTemporaryBeside(path);
  EXPECT_EQ(std::filesystem::symlink_status(temporary).type(), std::filesystem::file_type::regular);
  EXPECT_EQ(contentOf(path), "new");
  EXPECT_EQ(contentOf(victim), "of another person");
  EXPECT_TRUE(std::filesystem::is_symlink(first)) << "it is not ours to remove";
  for (int i = 2; i < 100; ++i) {
    const auto link = first + "." + std::to_string(i);
    if (link != temporary) std::filesystem::create_symlink(victim, link);
  }
  EXPECT_TRUE(test::oneSays({sentenceOf([&] { writeFileAtomically(path, "newer"); })},
                            {path.c_str(), "File exists", "as it was before"}));
  EXPECT_EQ(contentOf(victim), "of another person");
}

TEST(AtomicFile, TellsBeforehandWhatCannotBeWritten) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "folder");
  const auto sentence = [&](const char* name) {
    return sentenceOf([&] { requireWritable(folder / name); });
  };
  EXPECT_TRUE(test::oneSays({sentence("nowhere/map.yaml")}, {"No such file or directory"}));
  EXPECT_TRUE(test::oneSays({sentence("folder")}, {"Is a directory"}));
  const auto path = folder.write("map.yaml", "old");
  requireWritable(path);
  requireWritable(folder / "new.yaml");
  EXPECT_EQ(contentOf(path), "old");
  EXPECT_EQ(folder.files(), 2u);
}

}  // namespace
}  // namespace slam
