// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace slam {

/// The content of a session's file, which only back-ends of the same kind can read.
struct SavedSession {
  std::string bytes;

  template <class Archive>
  void persist(Archive& archive) {
    archive(bytes);
  }
};

/// The capability of a back-end that can save all it knows, the way and what was seen on it
/// included, and go on from there.
class SessionKeeper {
 public:
  virtual ~SessionKeeper() = default;
  /// @throw std::runtime_error with a sentence where it has none to save
  virtual SavedSession session() const = 0;
  /// Map, path and pose are replaced with the next execute(). A back-end that keeps its map fixed
  /// localises in that of the session.
  /// @throw std::runtime_error with what is wrong with the session and what to do, to stand behind
  /// its name ("it is cut: ..."); all stays as it is
  virtual void set(const SavedSession& session) = 0;
};

}  // namespace slam
