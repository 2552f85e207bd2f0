// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace slam {

/// Quantiles of the chi-square distribution at 0.95, with one and with two degrees of freedom.
constexpr double kGateOfOne = 3.841, kGateOfTwo = 5.991;

}  // namespace slam
