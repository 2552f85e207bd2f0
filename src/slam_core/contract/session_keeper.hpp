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

/// The capability of a back-end that can save all it knows, including the path and what was seen
/// along it, and go on from there.
class SessionKeeper {
 public:
  virtual ~SessionKeeper() = default;
  /// @throw std::runtime_error with a sentence if it has none to save
  virtual SavedSession session() const = 0;
  /// The next execute() replaces map, path and pose. A back-end that keeps its map fixed localises
  /// in that of the session.
  /// @throw std::runtime_error with what is wrong with the session and what to do, as a clause to
  /// follow the session's name ("it is cut: ..."); then nothing changes
  virtual void set(const SavedSession& session) = 0;
};

}  // namespace slam
