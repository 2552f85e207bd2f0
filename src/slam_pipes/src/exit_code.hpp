// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace slam_pipes {

/// The exit codes of the process of a component.
enum ExitCode {
  kDone = 0,
  kFailed = 1,      ///< it has reported why
  kWrongUse = 2,    ///< standard error has the sentence
  kPipeClosed = 3,  ///< another process has ended before, which is the cause
};

}  // namespace slam_pipes
