// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace slam {

/// Keeps other runs from writing into a folder. The system gives the lock back when the process
/// ends, however it does, and nothing is left in the folder. A file system without locks has none.
class FolderLock {
 public:
  /// @throw std::runtime_error, one sentence: the folder is locked already, by whomever, or cannot
  /// be opened
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// For who adds a file of his own to the run of another component of this process.
  /// @throw std::runtime_error when another process has locked the folder
  static void requireNoOtherProcess(const std::string& folder);

 private:
  int descriptor_;
};

}  // namespace slam
