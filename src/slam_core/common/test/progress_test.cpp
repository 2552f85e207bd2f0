// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/progress.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace slam {
namespace {

TEST(Progress, DrawsABarOnATerminal) {
  std::ostringstream terminal;
  Progress progress(terminal, true);
  progress.begin("reading", 4);
  progress.update(2);
  EXPECT_NE(terminal.str().find("reading [####################                    ]  50 %"),
            std::string::npos);
}

TEST(Progress, LeavesNoLineOfQuickWorkInALog) {
  std::ostringstream log;
  Progress progress(log, false);
  progress.begin("reading", 4);
  progress.update(2);
  progress.end();
  EXPECT_EQ(log.str(), "");
}

TEST(Progress, DrawsTheBarAnewAfterALineThatWasPrinted) {
  std::ostringstream terminal;
  Progress progress(terminal, true);
  progress.begin("reading", 4);
  progress.update(2);
  progress.clear();
  terminal.str("");
  progress.update(2);
  EXPECT_NE(terminal.str().find("50 %"), std::string::npos);
}

}  // namespace
}  // namespace slam
