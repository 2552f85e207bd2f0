// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace slam::ekf {

/// An index of Eigen's as one of the standard library's; not negative.
inline std::size_t at(Eigen::Index index) { return static_cast<std::size_t>(index); }

}  // namespace slam::ekf
