// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/time.hpp"

namespace slam {

/// @param what has come, with its article, as "an image"
/// @param stamp that is not newer than the one before it
/// @return why it is left out
inline std::string lateSentence(const std::string& what, Stamp stamp) {
  if (nanoseconds(stamp) == 0)
    return what + " has the stamp 0, since its driver sets none; it is left out";
  return what + " is not newer than the one before it; it is left out";
}

}  // namespace slam
