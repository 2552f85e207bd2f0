// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/choice.hpp"

namespace slam {

/// How far a reported pose can be relied on.
enum class Trust {
  kConfident,  ///< nothing speaks against it: the error is as its covariance says
  kDoubtful,   ///< something does; its covariance is widened by what that may amount to
  kLost,       ///< the robot may be anywhere in the map, and so says the covariance
  kUnknown     ///< nothing can be said: the back-end estimates no covariance
};

/// The states have these names in messages and files.
inline const Names<Trust>& namesOfTrust() {
  static const Names<Trust> names = {{"confident", Trust::kConfident},
                                     {"doubtful", Trust::kDoubtful},
                                     {"lost", Trust::kLost},
                                     {"unknown", Trust::kUnknown}};
  return names;
}

}  // namespace slam
