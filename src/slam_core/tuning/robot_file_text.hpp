// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "slam_core/tuning/noise_tuner.hpp"

namespace slam::tuning {

/// What a tuned robot file says of itself.
/// @param bags their names
std::string tuningRemark(const std::string& product, const std::string& bags);

/// What a calibrated robot file says of itself.
/// @param told a line each
std::string calibrationRemark(const std::vector<std::string>& told);

/// The text of a robot file with the values that were tuned, everything else as it was, its
/// comments and indentation included. What the file does not have is added to its section, or with
/// its section at the end. `remark` becomes a comment above the first key, instead of an earlier
/// one of its kind. The result was read back: it says what `text` says but for the
/// tuned values.
/// @throw ConfigError where the layout does not allow that
std::string withTunedValues(const std::string& text, const std::vector<TunedParameter>& parameters,
                            const std::string& remark);

}  // namespace slam::tuning
