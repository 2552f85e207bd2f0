// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "slam_core/common/input_file.hpp"
#include "slam_ros/wrong_use.hpp"

namespace slam::eval {

/// The import failed: a file's content or the disk is at fault. One sentence; exit code 1.
class ImportError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The command names something that is not there. One sentence; exit code 2.
class UsageError : public slam_ros::WrongUse {
 public:
  using WrongUse::WrongUse;
};

/// @throw UsageError where a path that the command names is no regular file
inline void requireFile(const std::string& path) {
  if (!std::filesystem::exists(path)) throw UsageError("there is no file " + path);
  if (const auto fault = inputFileFault(path); !fault.empty())
    throw UsageError("cannot read " + path + ": " + fault);
}

}  // namespace slam::eval
