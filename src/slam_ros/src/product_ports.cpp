// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/product_ports.hpp"

#include <algorithm>

#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/camera/view_drawer.hpp"
#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/trajectory_capabilities.hpp"
#include "slam_core/laser/laser_sweep.hpp"
#include "slam_core/product/product_components.hpp"
#include "slam_ros/camera_topics.hpp"
#include "slam_ros/known_inputs.hpp"
#include "slam_ros/topics_config.hpp"

namespace slam_ros {
namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(slam::TimeRole time) {
  if (time == slam::TimeRole::kTrigger) return "trigger";
  return time == slam::TimeRole::kCarrier ? "carrier" : "latched";
}

/// Where ROS brings the data from: a mount is a transform, a calibration stands beside the images.
std::string topicOf(const slam::InputPort& input) {
  const auto topic = TopicsConfig().of(input.name);
  if (input.kind == slam::kindOf<slam::CameraCalibration>()) return cameraTopics(topic).info;
  const bool is_mount = input.kind == slam::kindOf<slam::CameraMount>() ||
                        input.kind == slam::kindOf<slam::LaserMount>();
  return is_mount ? "tf_static" : topic;
}

/// The component that makes the input's data; null: they come from outside.
Json makerOf(const slam::InputPort& input, const std::vector<slam::ProductComponent>& parts) {
  for (const auto& part : parts)
    if (slam::portsOf(*part.component).output(input.name, input.kind) != nullptr) return part.key;
  return nullptr;
}

Json describe(const slam::InputPort& input) {
  return {{"name", input.name},         {"topic", topicOf(input)},
          {"sentence", input.sentence}, {"is_mandatory", input.is_mandatory},
          {"time", nameOf(input.time)}, {"kind", slam::nameOf(input.kind)}};
}

Json describe(const slam::OutputPort& output) {
  return {{"name", output.name},
          {"topic", TopicsConfig().of(output.name)},
          {"kind", slam::nameOf(output.kind)}};
}

/// What is published without a port: nothing in a product takes it in.
Json published(const std::string& topic) {
  return {{"name", topic}, {"topic", topic}, {"kind", nullptr}};
}

/// Besides the pose, which is an output of the estimator. The path is made of poses, so that every
/// back-end has one; all else is what the back-end says that it can do.
void addCapabilities(const slam::Capabilities& capabilities, Json& outputs) {
  outputs.push_back(published("path"));
  if (capabilities.find<slam::LandmarkMapper>() != nullptr)
    outputs.push_back(published("landmarks"));
  if (capabilities.find<slam::PoseSampler>() != nullptr)
    outputs.push_back(published("particlecloud"));
  if (capabilities.find<slam::GridMapper>() != nullptr) outputs.push_back(published("map"));
}

Json outputsOf(const slam::ProductComponents& product, const slam::ProductComponent& part) {
  auto outputs = Json::array();
  const auto ports = slam::portsOf(*part.component);
  for (const auto& output : ports.outputs()) outputs.push_back(describe(output));
  if (part.component == product.estimator.get())
    addCapabilities(product.estimator->capabilities(), outputs);
  const bool looks = dynamic_cast<const slam::ViewDrawer*>(part.component) != nullptr;
  if (part.component == product.odometry.get() && looks)
    outputs.push_back(published("visual_odometry/odom"));
  return outputs;
}

Json describeInputs(const slam::Ports& ports, const std::vector<slam::ProductComponent>& parts) {
  auto inputs = Json::array();
  for (const auto& input : ports.inputs()) {
    inputs.push_back(describe(input));
    inputs.back()["made_by"] = makerOf(input, parts);
    const auto gate = inputs.back()["made_by"].is_null() ? slam::gateFor(input) : nullptr;
    inputs.back()["gate"] = gate ? Json(gate->name()) : Json();
  }
  return inputs;
}

/// Those that the inputs name, once each.
Json describeGates(const slam::ProductComponents& product) {
  auto gates = Json::array();
  std::vector<std::string> names;
  for (const auto& part : slam::inOrder(product)) {
    const auto of_part = slam::portsOf(*part.component);
    for (const auto& input : of_part.inputs()) {
      const auto gate = slam::gateFor(input);
      if (!gate || std::count(names.begin(), names.end(), gate->name()) > 0) continue;
      names.push_back(gate->name());
      const auto ports = slam::portsOf(*gate);
      auto outputs = Json::array();
      for (const auto& output : ports.outputs()) outputs.push_back(describe(output));
      gates.push_back(
          {{"name", gate->name()}, {"inputs", describeInputs(ports, {})}, {"outputs", outputs}});
    }
  }
  return gates;
}

}  // namespace

Json describePorts(const slam::ProductConfig& product) {
  const auto parts = slam::createComponents(product);
  const auto all = slam::inOrder(parts);
  auto components = Json::array();
  for (const auto& part : all)
    components.push_back({{"role", part.role},
                          {"key", part.key},
                          {"name", part.name},
                          {"inputs", describeInputs(slam::portsOf(*part.component), all)},
                          {"outputs", outputsOf(parts, part)}});
  return {{"components", components},
          {"gates", describeGates(parts)},
          {"owns_odometry_edge", parts.odometry && slam::ownsOdometryEdge(*parts.odometry)}};
}

void checkPorts(const slam::ProductConfig& product) {
  auto parts = slam::createComponents(product);
  slam::Wiring wiring;
  slam::connect(parts, true, wiring);
  slam::Settings defaults;
  slam::FaultCollector faults;
  faults.attempt([&] { wiring.connect(defaults); });
  faults.attempt([&] { requireKnownInputs(wiring); });
  faults.raise();
}

}  // namespace slam_ros
