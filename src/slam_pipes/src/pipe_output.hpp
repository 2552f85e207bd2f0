// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>

#include "slam_core/common/child_process.hpp"
#include "turn_inputs.hpp"

namespace slam_pipes {

/// A pipe that frames go into. Who writes waits until the reader has made room.
class PipeOutput {
 public:
  /// @param taker whoever reads it, for sentences: "the back-end 'ekf'"
  PipeOutput(int descriptor, std::string taker)
      : descriptor_(descriptor), taker_(std::move(taker)) {}

  /// @throw PipeClosed where nobody reads it any more
  void put(const Frame& frame) {
    const auto bytes = encoder_.bytesOf(frame);
    if (!slam::writeAll(descriptor_, bytes.data(), bytes.size()))
      throw PipeClosed("the pipe to " + taker_ +
                       " was closed before the end of the data: start the run again");
  }

 private:
  int descriptor_;
  std::string taker_;
  FrameEncoder encoder_;
};

}  // namespace slam_pipes
