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

namespace slam {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& temporary, int error) {
  ::unlink(temporary.c_str());
  struct stat target {};
  const bool is_file = ::stat(path.c_str(), &target) == 0 && S_ISREG(target.st_mode);
  throw std::runtime_error("cannot write " + path + ": " + std::strerror(error) +
                           (is_file ? "; the file is as it was before" : ""));
}

bool writeAll(int descriptor, const std::string& content) {
  std::size_t written = 0;
  while (written < content.size()) {
    const auto n = ::write(descriptor, content.data() + written, content.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    written += static_cast<std::size_t>(n);
  }
  return ::fsync(descriptor) == 0;
}

std::string temporaryOf(const std::string& path) {
  return path + ".part" + std::to_string(::getpid());
}

/// The temporary file beside it.
int openBeside(const std::string& path) {
  // Renaming would replace a device like /dev/null, and root may do that.
  struct stat target {};
  const bool exists = ::stat(path.c_str(), &target) == 0;
  if (exists && S_ISDIR(target.st_mode)) fail(path, temporaryOf(path), EISDIR);
  if (exists && !S_ISREG(target.st_mode))
    throw std::runtime_error("cannot write " + path + ": it is no ordinary file");
  const auto temporary = temporaryOf(path);
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) fail(path, temporary, errno);
  return descriptor;
}

}  // namespace

void writeFileAtomically(const std::string& path, const std::string& content) {
  const int descriptor = openBeside(path);
  const auto temporary = temporaryOf(path);
  const bool complete = writeAll(descriptor, content);
  const int write_error = errno;
  const bool closed = ::close(descriptor) == 0;
  if (!complete || !closed) fail(path, temporary, complete ? errno : write_error);
  if (std::rename(temporary.c_str(), path.c_str()) != 0) fail(path, temporary, errno);
}

void requireWritable(const std::string& path) {
  ::close(openBeside(path));
  ::unlink(temporaryOf(path).c_str());
}

}  // namespace slam
