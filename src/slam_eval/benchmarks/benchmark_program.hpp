// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

namespace slam::eval {

/// Reads the command line of a benchmark and calls `run`; what it throws goes to standard error.
/// @return the exit code: 0, 1 where it failed, 2 for wrong use
template <class Run>
int runProgram(CLI::App& app, int argc, char** argv, Run run) {
  try {
    app.parse(argc, argv);
    run();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace slam::eval
