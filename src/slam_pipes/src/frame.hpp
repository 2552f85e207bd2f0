// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "slam_core/common/archive.hpp"

namespace slam_pipes {

/// A frame crosses a pipe. It carries a value for a port, or is a mark between turns. A turn is all
/// that one value from the bag leads to. Each component passes the mark on when it has done its
/// part of the turn, so that a reader of several pipes takes their data in the same order in every
/// run.
struct Frame {
  enum class Type : std::uint8_t {
    kDatum,  ///< a value for a port
    kTurn,   ///< no more data of this turn
    kStep,   ///< the same, and the estimator takes all steps that are due
    kEnd,    ///< the same, and no further turn
  };

  Type type = Type::kDatum;
  std::string port, kind;  ///< of a datum: the port's name and the kind's, as slam::nameOf() has it
  std::string value;       ///< of a datum, as slam::ArchiveWriter writes it

  bool isMark() const { return type != Type::kDatum; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(type, port, kind, value);
  }
};

/// Numbers frames of one pipe and makes bytes of them: eight letters, a version, the size, the
/// content, and a checksum of all of it (slam::sealed).
class FrameEncoder {
 public:
  std::string bytesOf(const Frame& frame);

 private:
  std::uint64_t number_ = 0;
};

/// Finds the frames in what comes out of a pipe, piece by piece.
class FrameDecoder {
 public:
  static constexpr std::uint64_t kLargest = std::uint64_t{1} << 30U;  ///< content of a frame [B]

  void append(const char* bytes, std::size_t size);
  /// The next frame; nothing until all of it has come.
  /// @throw std::runtime_error with what is wrong, to stand behind the pipe's name: no frames,
  /// another version, damaged, or frames are missing
  std::optional<Frame> next();
  /// Whether a frame has begun that has not come to its end.
  bool isWithinFrame() const { return begin_ < bytes_.size(); }

 private:
  std::string bytes_;
  std::size_t begin_ = 0;  ///< of what has not been handed out
  std::uint64_t number_ = 0;
};

/// The bytes of a value with persist(), and back. @throw std::runtime_error where they are of none
template <class T>
std::string bytesOf(const T& value) {
  slam::ArchiveWriter archive;
  archive(value);
  return archive.take();
}
template <class T>
T valueOf(const std::string& bytes) {
  slam::ArchiveReader archive(bytes);
  T value;
  archive(value);
  return value;
}

}  // namespace slam_pipes
