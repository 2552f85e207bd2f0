// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/tuning/noise_tuner.hpp"

namespace slam::tuning {

/// The text of a robot file with the values that were tuned, everything else as it was, its
/// comments included. What the file does not have is added to its section, or with its section at
/// the end. `remark` becomes a comment above the first key.
std::string withTunedValues(const std::string& text, const std::vector<TunedParameter>& parameters,
                            const std::string& remark);

}  // namespace slam::tuning
