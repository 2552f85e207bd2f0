// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stdexcept>

namespace slam_ros {

/// A command asks for something that does not exist or is impossible. The message is one sentence.
/// The program ends with the exit code 2; after any other failure it ends with 1.
class WrongUse : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace slam_ros
