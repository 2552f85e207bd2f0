// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/placed_detector.hpp"

namespace slam {

void PlacedDetector::describe(Ports& ports) {
  auto own = portsOf(*detector_);
  for (auto input : own.inputs()) {
    input.name = nameOf(input.name);
    ports.add(std::move(input));
  }
  for (auto output : own.outputs()) {
    output.name = nameOf(output.name);
    ports.add(std::move(output));
  }
}

std::string PlacedDetector::nameOf(const std::string& port) const {
  const auto found = names_.find(port);
  return found == names_.end() ? port : found->second;
}

cv::Mat PlacedDetector::drawing() const {
  const auto* drawer = dynamic_cast<const ViewDrawer*>(detector_.get());
  return drawer == nullptr ? cv::Mat() : drawer->drawing();
}

}  // namespace slam
