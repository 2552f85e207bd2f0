// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <string>

namespace slam {

/// What a child may use up before the system ends it.
struct ChildLimits {
  std::uint64_t memory;       ///< [B] beyond what this process has
  std::uint64_t cpu_seconds;  ///< [s]
  bool is_quiet = true;       ///< nothing of it goes to standard error
};

/// How a child ended.
struct ChildEnd {
  int exit_code;
  std::string crash;  ///< where it did not end by itself: why, as in "a segmentation fault"
};

/// A copy of this process that does what might crash, never end or take all memory, as a library
/// does that reads a damaged file. Nothing that it does is seen here, but for what it writes to
/// its output. It ends when this process does. Its work takes no lock that another thread of this
/// process may hold now: nobody in the copy would release it.
class ChildProcess {
 public:
  /// Takes the descriptor of its output, returns the exit code; what it throws becomes 1.
  using Work = std::function<int(int output)>;

  /// @throw std::runtime_error when the system allows no further process
  ChildProcess(const ChildLimits& limits, const Work& work);
  /// Ends it.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// The descriptor that gives what it writes, until it ends.
  int output() const { return output_; }
  /// Waits for its end.
  ChildEnd wait();

 private:
  pid_t id_ = -1;
  int output_ = -1;
};

/// @return false where the other end is gone, or with an error
bool writeAll(int descriptor, const void* data, std::size_t size);
/// @return false where the input ends before, or with an error
bool readAll(int descriptor, void* data, std::size_t size);

}  // namespace slam
