// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

namespace slam_ros {

/// Calls a function once the nodelet that makes this in its onInit() is loaded, in the manager's
/// main thread.
///
/// Subscribe in this function. The loader switches a nodelet's queue off until onInit() has
/// returned. If a message comes meanwhile, typically a latched one, its callback call is lost but
/// the message stays in the subscription: it is delivered when the next one comes, and from then on
/// each message is delivered one too late. The manager's own queue, in contrast, only waits until
/// the load is over.
class AfterLoad {
 public:
  /// @param call must not throw: check the names of topics before
  explicit AfterLoad(std::function<void()> call);
  /// From here on the function is not called any more.
  ~AfterLoad();
  AfterLoad(const AfterLoad&) = delete;
  AfterLoad& operator=(const AfterLoad&) = delete;
};

}  // namespace slam_ros
