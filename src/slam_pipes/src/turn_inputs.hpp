// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "frame.hpp"

namespace slam_pipes {

/// The other end of a pipe is gone although the data have not come to their end: whoever held it
/// knows why.
class PipeClosed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A pipe that frames come from.
class PipeInput {
 public:
  /// @param maker whoever writes into it, for sentences: "the odometry source 'wheel'"
  PipeInput(int descriptor, std::string maker)
      : descriptor_(descriptor), maker_(std::move(maker)) {}

  int descriptor() const { return descriptor_; }
  const std::string& maker() const { return maker_; }
  /// Takes what has come, at least a byte, for which it waits. @return false at the pipe's end
  bool read();
  /// The next frame, or nothing until more is read. @throw std::runtime_error naming the maker
  std::optional<Frame> next();
  /// The next frame, for which it waits.
  /// @throw PipeClosed at the pipe's end; std::runtime_error as above
  Frame waitForNext();
  /// @throw PipeClosed, or std::runtime_error where the pipe ended within a frame
  [[noreturn]] void failAtEnd() const;

 private:
  int descriptor_;
  std::string maker_;
  FrameDecoder decoder_;
};

/// The pipes that a process reads, turn by turn. A turn's data are taken in the order of the pipes,
/// however the processes were scheduled. No more than a turn is held of a pipe, beside what was
/// read with it: what else is written waits in the pipe, and its writer with it.
class TurnInputs {
 public:
  struct Turn {
    std::vector<Frame> data;  ///< those of the first pipe first
    Frame::Type mark = Frame::Type::kTurn;
  };

  /// All pipes before the first turn.
  void add(PipeInput input) { pipes_.push_back({std::move(input), {}, {}}); }
  bool isEmpty() const { return pipes_.empty(); }
  /// @throw PipeClosed, std::runtime_error naming the maker
  Turn next();
  /// @return the frame that a maker writes after the end of its turns @throw as next()
  Frame behindEnd(const std::string& maker);

 private:
  struct Pipe {
    PipeInput input;
    std::vector<Frame> data;          ///< of this turn
    std::optional<Frame::Type> mark;  ///< that has ended this turn
  };

  static void takeTurn(Pipe& pipe);
  void readSome();

  std::vector<Pipe> pipes_;
};

}  // namespace slam_pipes
