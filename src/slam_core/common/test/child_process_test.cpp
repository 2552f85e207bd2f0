// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/child_process.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <new>
#include <stdexcept>
#include <string>

namespace slam {
namespace {

constexpr ChildLimits kLimits{64u << 20, 2};

ChildEnd endOf(const ChildProcess::Work& work) { return ChildProcess(kLimits, work).wait(); }

TEST(ChildProcess, GivesWhatItWritesAndItsExitCode) {
  const std::string text(3'000'000, 'x');  // more than a pipe holds
  ChildProcess child(
      kLimits, [&](int output) { return writeAll(output, text.data(), text.size()) ? 7 : 8; });
  std::string received(text.size(), ' ');
  ASSERT_TRUE(readAll(child.output(), received.data(), received.size()));
  EXPECT_EQ(received, text);
  char more = 0;
  EXPECT_FALSE(readAll(child.output(), &more, 1)) << "it has ended";
  const auto end = child.wait();
  EXPECT_EQ(end.exit_code, 7);
  EXPECT_EQ(end.crash, "");
}

TEST(ChildProcess, CrashesAlone) {
  EXPECT_EQ(endOf([](int) { return std::raise(SIGSEGV); }).crash, "a segmentation fault");
  EXPECT_EQ(endOf([](int) -> int { std::abort(); }).crash, "an abort");
  const auto thrown = endOf([](int) -> int { throw std::runtime_error("unseen"); });
  EXPECT_EQ(thrown.exit_code, 1);
  EXPECT_EQ(thrown.crash, "");
}

TEST(ChildProcess, GetsNoMoreMemoryThanItsShare) {
  const auto allocate = [](std::size_t bytes) {
    return [bytes](int) {
      const void* const memory =
          ::mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
      return memory == MAP_FAILED ? 3 : 0;
    };
  };
  EXPECT_EQ(endOf(allocate(16u << 20)).exit_code, 0);
  EXPECT_EQ(endOf(allocate(256u << 20)).exit_code, 3);
}

TEST(ChildProcess, ThatNeverEndsIsEnded) {
  volatile bool go_on = true;
  const ChildLimits short_time{64u << 20, 1};
  ChildProcess child(short_time, [&](int) {
    while (go_on) {
    }
    return 0;
  });
  EXPECT_EQ(child.wait().crash, "no end of it");
}

TEST(ChildProcess, EndsWithItsOwner) {
  const auto id = [] {
    ChildProcess child(kLimits, [](int output) {
      const pid_t own = ::getpid();
      writeAll(output, &own, sizeof(own));
      return ::pause();
    });
    pid_t received = 0;
    EXPECT_TRUE(readAll(child.output(), &received, sizeof(received)));
    return received;
  }();
  ASSERT_GT(id, 0);
  EXPECT_NE(::kill(id, 0), 0) << "it is gone";
}

}  // namespace
}  // namespace slam
