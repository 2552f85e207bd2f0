// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace slam::gyro {

inline double squared(double x) { return x * x; }

}  // namespace slam::gyro
