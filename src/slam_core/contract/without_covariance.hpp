// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace slam {

/// The capability, in fact the lack of one, of a back-end that does not estimate how wrong its pose
/// is. What it reports as covariance is that of the odometry since the start, so that others can
/// compute with it; it goes out as unknown: the first element of a message's covariance is -1.
class WithoutCovariance {
 public:
  virtual ~WithoutCovariance() = default;
};

}  // namespace slam
