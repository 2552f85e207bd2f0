// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>

#include "slam_core/common/folder_lock.hpp"

namespace slam {

/// A folder with the last two checkpoints of a product that runs without an end, locked against
/// other products. Whenever the power is cut, at least one complete checkpoint is there:
/// `checkpoint` or `checkpoint.previous`. A file that cannot be used is renamed and never written
/// over: `checkpoint.unused`, `checkpoint.unused.2` and so on.
class CheckpointFolder {
 public:
  /// Makes the folder. @throw std::runtime_error naming the folder and the cause, as that another
  /// product writes into it
  explicit CheckpointFolder(const std::string& path);

  /// Why nothing can be written, as a sentence; empty where it can.
  std::string fault() const;

  /// Takes the file's content. @throw std::runtime_error with a clause on what is wrong with it
  using Use = std::function<void(const std::string& bytes)>;
  struct Resumption {
    std::string file;     ///< that was used; empty where there was none
    std::string warning;  ///< a sentence on files that could not be used, or empty
  };
  /// Has the newest checkpoint used that can be.
  Resumption resume(const Use& use);
  /// The checkpoints of an earlier product become `checkpoint.before`; an older one is removed.
  void beginAnew();

  /// Writes a checkpoint to the disk; that before it stays as the previous one.
  /// @throw std::runtime_error naming the file and the cause; both are as they were then
  void write(const std::string& bytes) const;

 private:
  std::string file(const char* suffix = "") const;
  void removeParts() const;
  void keepPrevious() const;
  void setAside(const std::string& file) const;

  std::string path_;
  FolderLock lock_;
};

}  // namespace slam
