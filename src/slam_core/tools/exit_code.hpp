// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <exception>

namespace slam {

/// Calls what a program does; a fault becomes one sentence and exit code 1.
template <class Body>
int exitCodeOf(const Body& body) {
  try {
    body();
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}

}  // namespace slam
