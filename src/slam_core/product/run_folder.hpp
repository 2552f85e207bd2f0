// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "slam_core/common/folder_lock.hpp"

namespace slam {

/// The folder that takes a run's files, locked against other runs. While the run goes on its files
/// stand in `unfinished_run` in it, and what an earlier run has left stays as it is; complete()
/// lets the one take the place of the other. What a run that was cut off has written stays in
/// `unfinished_run` until the next run into this folder begins, unless that one resumes it.
class RunFolder {
 public:
  enum class Start {
    kAnew,     ///< what a run that was cut off has left is removed
    kResumed,  ///< it stays
  };
  /// In unfinished(): what a run is resumed from. It does not stay in the folder.
  static constexpr const char* kCheckpoint = "checkpoint";
  /// The names of sessions that were not merged begin with this and a number.
  static constexpr const char* kUnmerged = "unmerged_";

  /// Makes the folder. @throw std::runtime_error naming the folder and the cause, as that there is
  /// nothing to resume
  explicit RunFolder(const std::string& path, Start start = Start::kAnew);

  const std::string& path() const { return path_; }
  /// Where files of the run are to be written.
  const std::string& unfinished() const { return unfinished_; }

  /// Moves the run's files into the folder, config.yaml last: where it is, the others are complete.
  /// Results of an earlier run and its evaluation that this run has none of are removed, but not
  /// what somebody has written since the run began. @throw std::runtime_error before anything is
  /// changed, where a folder is in the way
  void complete();
  /// Leaves only these files of a resumed run in unfinished(), beside the checkpoint.
  /// Those that complete() had moved already when the run was cut off are moved back.
  void restrictTo(const std::set<std::string>& files);
  /// Leaves nothing of the run.
  void discard();

 private:
  using FileVersion = std::pair<long long, unsigned long long>;  // when it was written, its inode

  static FileVersion versionOf(const std::string& path);
  void clear();
  void requirePlace(const std::string& name) const;
  void removeFormer();

  std::string path_, unfinished_;
  FolderLock lock_;
  std::map<std::string, FileVersion> former_;  ///< results of an earlier run, by name
};

}  // namespace slam
