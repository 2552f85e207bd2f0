// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace slam_pipes {

/// A descriptor that is closed at the end, and that no program gets which is started meanwhile.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;

  int number() const { return number_; }
  bool isOpen() const { return number_ >= 0; }
  void close();

 private:
  int release();

  int number_;
};

/// @throw std::runtime_error where the system has no more descriptors
struct Pipe {
  Descriptor read_end, write_end;
};
Pipe makePipe();

/// A program that was started, which ends with this object at the latest and leaves no zombie.
class StartedProgram {
 public:
  struct End {
    int exit_code = 0;
    int signal = 0;  ///< that ended it; 0: it ended by itself
  };

  /// @param words the program's path and its arguments
  /// @param descriptors that it gets, under the same numbers
  /// @throw std::runtime_error naming the program and the cause
  StartedProgram(const std::vector<std::string>& words, const std::vector<int>& descriptors);
  ~StartedProgram();
  StartedProgram(StartedProgram&& other) noexcept;
  StartedProgram& operator=(StartedProgram&&) = delete;

  pid_t id() const { return id_; }
  /// Ends it now.
  void kill();
  /// Waits for its end; the same answer each time.
  End wait();

 private:
  pid_t id_;
  bool has_ended_ = false;
  End end_;
};

}  // namespace slam_pipes
