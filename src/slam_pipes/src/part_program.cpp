// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "part_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace slam_pipes {

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this == &other) return *this;
  close();
  number_ = other.release();
  return *this;
}

void Descriptor::close() {
  if (isOpen()) ::close(release());
}

int Descriptor::release() { return std::exchange(number_, -1); }

Pipe makePipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw std::runtime_error(std::string("cannot make a pipe: ") + std::strerror(errno));
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

StartedProgram::StartedProgram(const std::vector<std::string>& words,
                               const std::vector<int>& descriptors) {
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  // A descriptor that is duplicated onto itself stays open in the program.
  for (const int descriptor : descriptors)
    ::posix_spawn_file_actions_adddup2(&actions, descriptor, descriptor);
  std::vector<char*> arguments;
  for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int fault =
      ::posix_spawn(&id_, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (fault != 0)
    throw std::runtime_error("cannot start " + words.front() + ": " + std::strerror(fault));
}

StartedProgram::StartedProgram(StartedProgram&& other) noexcept
    : id_(other.id_), has_ended_(std::exchange(other.has_ended_, true)), end_(other.end_) {}

StartedProgram::~StartedProgram() {
  kill();
  wait();
}

void StartedProgram::kill() {
  if (!has_ended_) ::kill(id_, SIGKILL);
}

StartedProgram::End StartedProgram::wait() {
  if (has_ended_) return end_;
  int status = 0;
  while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  has_ended_ = true;
  end_ = {WIFEXITED(status) ? WEXITSTATUS(status) : 0, WIFSIGNALED(status) ? WTERMSIG(status) : 0};
  return end_;
}

}  // namespace slam_pipes
