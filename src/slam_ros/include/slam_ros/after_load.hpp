// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

namespace slam_ros {

/// Calls a function once the nodelet that makes this in its onInit() is loaded, in the manager's
/// main thread.
///
/// Subscriptions belong in here. A loader switches a nodelet's queue off until onInit() has
/// returned; of a message that comes meanwhile, a latched one above all, only the call is lost: the
/// message stays in its subscription until another one comes, and from then on each is handed over
/// one too late. The manager's own queue goes on after the load, in which it was busy.
class AfterLoad {
 public:
  /// @param call must not throw: check names before
  explicit AfterLoad(std::function<void()> call);
  /// From here on it is not called.
  ~AfterLoad();
  AfterLoad(const AfterLoad&) = delete;
  AfterLoad& operator=(const AfterLoad&) = delete;
};

}  // namespace slam_ros
