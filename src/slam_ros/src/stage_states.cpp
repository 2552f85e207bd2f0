// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/stage_states.hpp"

#include <stdexcept>

#include "slam_core/product/meta_coordinator.hpp"
#include "slam_ros/settings_from_ros.hpp"

namespace slam_ros {

StageStates::StageStates(const ros::NodeHandle& product, const slam::ProductComponents& part)
    : product_(product) {
  if (!part.stages.empty()) return;
  const auto whole = slam::createComponents(part.product);
  for (const auto& stage : whole.stages) {
    const auto name = stage.component->name();
    stages_.emplace_back(name, StageState::of(product_.getNamespace(), name));
  }
}

std::string StageStates::missing() const {
  for (const auto& [name, state] : stages_)
    if (!state->isHere()) return name;
  return "";
}

StageStates::Saved StageStates::copy() const {
  Saved saved;
  for (auto stage = stages_.rbegin(); stage != stages_.rend(); ++stage)
    saved[stage->first] = stage->second->copy();
  return saved;
}

void StageStates::require(const Saved& saved) const {
  for (const auto& [name, state] : stages_) {
    const auto found = saved.find(name);
    if (found == saved.end())
      throw std::runtime_error("it holds no state of the stage '" + name + "'");
    slam::MetaCoordinator trial;
    auto settings = settingsFromRos(product_);
    trial.configure(settings, {slam::ProductPart::Extent::kStage, name});
    slam::restore(found->second, trial);
  }
}

void StageStates::goOnFrom(const Saved& saved) const {
  for (const auto& [name, state] : stages_) {
    const auto found = saved.find(name);
    state->goOnFrom(found == saved.end() ? "" : found->second);
  }
}

}  // namespace slam_ros
