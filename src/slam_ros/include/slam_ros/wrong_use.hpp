// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stdexcept>

namespace slam_ros {

/// A command asks for what is not there or cannot be: one sentence, with which a program ends with
/// the exit code 2 where any other failure gives 1.
class WrongUse : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace slam_ros
