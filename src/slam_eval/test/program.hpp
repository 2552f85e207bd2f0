// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace slam::eval {

/// What a run of a program did.
struct ProgramRun {
  int exit_code = -1;
  std::string output;  // standard output and error
};

/// Runs a command line of the shell.
inline ProgramRun runCommand(const std::string& command) {
  ProgramRun run;
  std::FILE* pipe = ::popen(("{ " + command + "; } 2>&1").c_str(), "r");
  if (pipe == nullptr) return run;
  std::array<char, 4096> block;
  std::size_t count = 0;
  while ((count = std::fread(block.data(), 1, block.size(), pipe)) > 0) {
    run.output.append(block.data(), count);
  }
  const int status = ::pclose(pipe);
  if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
  return run;
}

/// Runs the program slam_import of this build. SLAM_IMPORT is its path.
/// @param file_blocks largest file it may write [512 byte]; 0: no limit
inline ProgramRun runSlamImport(const std::string& arguments, int file_blocks = 0) {
  const std::string limit =
      file_blocks > 0 ? "ulimit -f " + std::to_string(file_blocks) + "; " : "";
  return runCommand(limit + "'" SLAM_IMPORT "' " + arguments);
}

}  // namespace slam::eval
