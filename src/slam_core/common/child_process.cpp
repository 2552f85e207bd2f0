// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/child_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace slam {
namespace {

constexpr int kPipeSize = 1 << 20;  // [B]

[[noreturn]] void failToStart() {
  throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno));
}

/// [B] of addresses in use; 0 where it is not to be had.
std::uint64_t ownMemory() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void limit(__rlimit_resource_t resource, std::uint64_t most) {
  rlimit limits{};
  ::getrlimit(resource, &limits);
  limits.rlim_cur = std::min<rlim_t>(limits.rlim_max, most);
  ::setrlimit(resource, &limits);
}

void applyInChild(const ChildLimits& limits, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(EXIT_FAILURE);
  for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGPIPE})
    std::signal(fault, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.cpu_seconds);
  if (const auto own = ownMemory(); own > 0) limit(RLIMIT_AS, own + limits.memory);
  if (!limits.is_quiet) return;
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
}

std::string nameOf(int signal) {
  switch (signal) {
    case SIGSEGV:
    case SIGBUS:
      return "a segmentation fault";
    case SIGXCPU:
      return "no end of it";
    case SIGABRT:
      return "an abort";
    default:
      return std::string("the signal ") + ::strsignal(signal);
  }
}

}  // namespace

ChildProcess::ChildProcess(const ChildLimits& limits, const Work& work) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) failToStart();
  ::fcntl(ends[1], F_SETPIPE_SZ, kPipeSize);
  const auto parent = ::getpid();
  id_ = ::fork();
  if (id_ == 0) {
    ::close(ends[0]);
    applyInChild(limits, parent);
    int code = EXIT_FAILURE;
    try {
      code = work(ends[1]);
    } catch (...) {
      // its exit code tells
    }
    ::_exit(code);  // without the parent's destructors and buffers
  }
  ::close(ends[1]);
  output_ = ends[0];
  if (id_ > 0) return;
  ::close(output_);
  failToStart();
}

ChildProcess::~ChildProcess() {
  ::close(output_);
  if (id_ < 0) return;
  ::kill(id_, SIGKILL);
  wait();
}

ChildEnd ChildProcess::wait() {
  int status = 0;
  while (id_ > 0 && ::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = -1;
  if (WIFSIGNALED(status)) return {EXIT_FAILURE, nameOf(WTERMSIG(status))};
  return {WEXITSTATUS(status), ""};
}

bool writeAll(int descriptor, const void* data, std::size_t size) {
  const auto* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const auto count = ::write(descriptor, bytes, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

bool readAll(int descriptor, void* data, std::size_t size) {
  auto* bytes = static_cast<char*>(data);
  while (size > 0) {
    const auto count = ::read(descriptor, bytes, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace slam
