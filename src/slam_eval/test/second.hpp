// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace slam::eval {

constexpr std::int64_t kSecond = 1'000'000'000;  ///< [ns]

}  // namespace slam::eval
