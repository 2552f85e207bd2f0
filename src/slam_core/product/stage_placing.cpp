// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/stage_placing.hpp"

#include <string>
#include <utility>

namespace slam {
namespace {

class StagePlacing {
 public:
  explicit StagePlacing(const std::vector<ProductComponent>& components) {
    std::vector<const Ports*> ports;
    for (const auto& each : components)
      ports.push_back(&wired_.add(each.title(), *each.component, portsOf(each)));
    for (std::size_t i = 0; i < components.size(); ++i)
      placeBefore(*ports[i], components[i].features);
  }
  std::vector<ProductStage> take() { return std::move(stages_); }

 private:
  /// A stage follows those that it needs itself. It is known before these are looked for: what
  /// would come back to it is refused with the circle that it is.
  void placeBefore(const Ports& ports, const std::vector<std::string>& features) {
    for (const auto& input : ports.inputs()) {
      if (wired_.makerOf(input) != nullptr) continue;
      auto stage = createMakerOf<Stage>(input);
      if (!stage) continue;
      placeBefore(wired_.add(Stage::kRole + (" '" + stage->name() + "'"), *stage), features);
      stages_.push_back({std::move(stage), features});
    }
  }

  WiredPorts wired_;
  std::vector<ProductStage> stages_;
};

}  // namespace

std::vector<ProductStage> placeStages(const std::vector<ProductComponent>& components) {
  return StagePlacing(components).take();
}

}  // namespace slam
