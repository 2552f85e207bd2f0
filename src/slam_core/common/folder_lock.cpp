// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>

namespace slam {
namespace {

using FolderId = std::pair<dev_t, ino_t>;

/// Folders that this process has locked; the system tells that one is locked, not by whom.
class LockedFolders {
 public:
  void insert(int descriptor) {
    change([&](auto& all) { all.insert(idOf(descriptor)); });
  }
  void erase(int descriptor) {
    change([&](auto& all) { all.erase(idOf(descriptor)); });
  }
  bool holds(int descriptor) {
    bool found = false;
    change([&](const auto& all) { found = all.count(idOf(descriptor)) > 0; });
    return found;
  }

 private:
  static FolderId idOf(int descriptor) {
    struct stat status {};
    ::fstat(descriptor, &status);
    return {status.st_dev, status.st_ino};
  }
  template <class Action>
  void change(Action&& action) {
    const std::lock_guard<std::mutex> lock(mutex_);
    action(folders_);
  }

  std::mutex mutex_;
  std::set<FolderId> folders_;
};

LockedFolders& lockedFolders() {
  static LockedFolders folders;
  return folders;
}

int openFolder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    throw std::runtime_error("cannot write into " + folder + ": " + std::strerror(errno));
  return descriptor;
}

bool tryLock(int descriptor) {
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

[[noreturn]] void refuseFolder(const std::string& folder) {
  throw std::runtime_error("another run is writing into the folder " + folder +
                           "; wait for its end, or name another folder");
}

}  // namespace

FolderLock::FolderLock(const std::string& folder) : descriptor_(openFolder(folder)) {
  if (!tryLock(descriptor_)) {
    ::close(descriptor_);
    refuseFolder(folder);
  }
  lockedFolders().insert(descriptor_);
}

FolderLock::~FolderLock() {
  lockedFolders().erase(descriptor_);
  ::close(descriptor_);
}

void FolderLock::requireNoOtherProcess(const std::string& folder) {
  const int descriptor = openFolder(folder);
  const bool is_free = tryLock(descriptor) || lockedFolders().holds(descriptor);
  ::close(descriptor);
  if (!is_free) refuseFolder(folder);
}

}  // namespace slam
