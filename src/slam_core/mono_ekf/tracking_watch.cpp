// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/tracking_watch.hpp"

namespace slam::mono_ekf {

bool TrackingWatch::judge(Stamp stamp, std::size_t searched, std::size_t agreed, bool has_texture) {
  constexpr std::size_t kEnough = 8, kShare = 5;  // a fifth of those that were searched
  if (!has_texture || searched < kEnough) return false;
  if (agreed * kShare >= searched) {
    contradicted_since_.reset();
    return false;
  }
  if (!contradicted_since_) contradicted_since_ = stamp;
  if (lost_since_ || seconds(stamp - *contradicted_since_) < patience_) return false;
  lost_since_ = stamp;
  contradicted_since_.reset();
  return true;
}

}  // namespace slam::mono_ekf
