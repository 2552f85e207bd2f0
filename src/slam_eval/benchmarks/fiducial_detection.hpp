// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <nlohmann/json.hpp>

namespace slam::eval {

/// How often a detector sees a rendered marker of 0.16 m and how well, against distance and
/// obliqueness: an array of {detector, distance_m, obliqueness_deg, trials, detected, range_bias
/// (mean error over the range), range_sigma (its standard deviation), bearing_bias_rad}, the last
/// three null where nothing was detected.
/// @param progress called after each of `cells` cells
nlohmann::json detectionTable(
    int trials, const std::function<void(std::size_t cell, std::size_t cells)>& progress);

}  // namespace slam::eval
