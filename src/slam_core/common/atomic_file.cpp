// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace slam {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  struct stat target {};
  const bool is_file = ::stat(path.c_str(), &target) == 0 && S_ISREG(target.st_mode);
  throw std::runtime_error("cannot write " + path + ": " + std::strerror(error) +
                           (is_file ? "; the file is as it was before" : ""));
}

bool writeToDisk(int descriptor, const std::string& content) {
  std::size_t written = 0;
  while (written < content.size()) {
    const auto n = ::write(descriptor, content.data() + written, content.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    written += static_cast<std::size_t>(n);
  }
  return ::fsync(descriptor) == 0;
}

/// The name of a file outlives a power cut once its folder is on the disk. A file system that
/// cannot do so does what it can.
void flushFolderOf(const std::string& path) {
  const auto end = path.rfind('/');
  const auto folder = end == std::string::npos ? "." : path.substr(0, end + 1);
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

void requireReplaceable(const std::string& path) {
  // Renaming would replace a device like /dev/null, and root may do that.
  struct stat target {};
  const bool exists = ::stat(path.c_str(), &target) == 0;
  if (exists && S_ISDIR(target.st_mode)) fail(path, EISDIR);
  if (exists && !S_ISREG(target.st_mode))
    throw std::runtime_error("cannot write " + path + ": it is no ordinary file");
}

/// A file that is removed again unless it takes its place.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path) : path_(path) {
    requireReplaceable(path);
    for (int i = 0; i < kNames && descriptor_ < 0; ++i) {
      name_ = path + ".part" + std::to_string(::getpid()) + (i > 0 ? "." + std::to_string(i) : "");
      descriptor_ =
          ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
      if (descriptor_ < 0 && errno != EEXIST) break;
    }
    if (descriptor_ < 0) fail(path_, errno);
  }
  ~TemporaryFile() {
    close();
    if (!name_.empty()) ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(const std::string& content) const {
    if (!writeToDisk(descriptor_, content)) fail(path_, errno);
  }
  void takePlace() {
    if (!close() || std::rename(name_.c_str(), path_.c_str()) != 0) fail(path_, errno);
    name_.clear();
    flushFolderOf(path_);
  }
  std::string release() { return std::exchange(name_, ""); }

 private:
  static constexpr int kNames = 100;  // taken by what was killed here, or by somebody else's links

  bool close() { return descriptor_ < 0 || ::close(std::exchange(descriptor_, -1)) == 0; }

  std::string path_, name_;
  int descriptor_ = -1;
};

}  // namespace

void writeFileAtomically(const std::string& path, const std::string& content) {
  TemporaryFile file(path);
  file.write(content);
  file.takePlace();
}

void flushToDisk(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_flushed = descriptor >= 0 && ::fsync(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!is_flushed) throw std::runtime_error("cannot write " + path + ": " + std::strerror(error));
}

std::string makeTemporaryBeside(const std::string& path) { return TemporaryFile(path).release(); }

void requireWritable(const std::string& path) { TemporaryFile{path}; }

}  // namespace slam
