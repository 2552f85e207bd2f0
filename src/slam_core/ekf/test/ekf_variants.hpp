// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "slam_core/ekf/ekf_config.hpp"
#include "slam_core/ekf/gaussian_transform.hpp"
#include "slam_core/ekf/linearization.hpp"

namespace slam::test {

/// A filter and a linearisation, by their names.
using EkfVariant = std::tuple<std::string, std::string>;

inline auto allVariants() {
  return testing::Combine(testing::ValuesIn(ekf::transformNames()),
                          testing::ValuesIn(ekf::linearizationNames()));
}

inline std::string nameOf(const EkfVariant& variant) {
  return std::get<0>(variant) + "_" + std::get<1>(variant);
}

inline ekf::EkfConfig configOf(const EkfVariant& variant) {
  ekf::EkfConfig config;
  std::tie(config.filter, config.linearization) = variant;
  return config;
}

}  // namespace slam::test
