// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/camera/camera_gate.hpp"

namespace slam::test {

/// A camera before a component that looks through it, with its gate between them.
class CameraFeed {
 public:
  CameraFeed() { gate.configure(CameraConfig()); }

  /// An image on its way to the component.
  /// @param look takes the view and executes
  /// @return what the gate says, or where it says nothing what the component does
  template <class Look>
  Status show(const Image& image, const Look& look) {
    gate.set(image);
    const auto of_gate = gate.execute();
    const auto of_component = gate.view() ? look(*gate.view()) : Status::ok();
    return of_gate.isOk() ? of_component : of_gate;
  }

  CameraGate gate;
};

}  // namespace slam::test
