// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace slam::eval {

/// The import failed: a file's content or the disk is at fault. One sentence; exit code 1.
class ImportError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The command names something that is not there. One sentence; exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace slam::eval
