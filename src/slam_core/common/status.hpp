// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>

namespace slam {

/// The answer of a component's execute(). Bad data is told here, never thrown.
struct Status {
  enum class Level { kOk, kWarning, kError };

  static Status ok() { return {}; }
  static Status warning(std::string message) { return {Level::kWarning, std::move(message)}; }
  static Status error(std::string message) { return {Level::kError, std::move(message)}; }

  bool isOk() const { return level == Level::kOk; }

  Level level = Level::kOk;
  std::string message;  ///< one sentence: what, where, what to do; empty when all is well
};

}  // namespace slam
