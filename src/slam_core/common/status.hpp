// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>

namespace slam {

/// The answer of a component's execute(). Bad data is reported here, never thrown.
struct Status {
  enum class Level { kOk, kWarning, kError };

  static Status ok() { return {}; }
  static Status warning(std::string message) { return {Level::kWarning, std::move(message)}; }
  /// A warning that must not go under in others: what comes out may be useless.
  static Status alarm(std::string message) { return {Level::kWarning, std::move(message), true}; }
  static Status error(std::string message) { return {Level::kError, std::move(message)}; }

  bool isOk() const { return level == Level::kOk; }
  bool isUrgent() const { return is_alarm || level == Level::kError; }

  Level level = Level::kOk;
  std::string message;    ///< one sentence: what, where, what to do; empty when all is well
  bool is_alarm = false;  ///< see alarm()

  template <class Archive>
  void persist(Archive& archive) {
    archive(level, message, is_alarm);
  }
};

/// The one of two that must be reported, where only one can be; the second one where both must.
inline Status moreUrgent(Status first, Status second) {
  const auto urgency = [](const Status& status) {
    if (status.isOk()) return 0;
    return status.level == Status::Level::kError ? 3 : status.is_alarm ? 2 : 1;
  };
  return urgency(second) >= urgency(first) && !second.isOk() ? second : first;
}

/// Both sentences of two, at the level of the one that is more urgent.
inline Status together(const Status& first, const Status& second) {
  auto both = moreUrgent(first, second);
  if (!first.isOk() && !second.isOk()) both.message = first.message + "; " + second.message;
  return both;
}

}  // namespace slam
