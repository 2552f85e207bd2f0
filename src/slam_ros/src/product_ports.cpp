// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/product_ports.hpp"

#include <algorithm>

#include "slam_core/association/association_policy.hpp"
#include "slam_core/camera/camera_calibration.hpp"
#include "slam_core/camera/view_drawer.hpp"
#include "slam_core/contract/feature_mapper.hpp"
#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/contract/trajectory_capabilities.hpp"
#include "slam_core/imu/imu_reading.hpp"
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
                        input.kind == slam::kindOf<slam::LaserMount>() ||
                        input.kind == slam::kindOf<slam::ImuMount>();
  return is_mount ? "tf_static" : topic;
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
  if (capabilities.find<slam::FeatureMapper>() != nullptr) outputs.push_back(published("features"));
  if (capabilities.find<slam::GridMapper>() != nullptr) outputs.push_back(published("map"));
}

Json outputsOf(const slam::ProductComponents& product, const slam::ProductComponent& part) {
  auto outputs = Json::array();
  const auto ports = portsOf(part);
  for (const auto& output : ports.outputs()) outputs.push_back(describe(output));
  if (part.component == product.estimator.get())
    addCapabilities(product.estimator->capabilities(), outputs);
  const bool is_odometry = part.component == product.odometry.get();
  if (is_odometry && !product.odometry->name().empty())
    outputs.push_back(published(product.odometry->name() + "_odometry/odom"));
  return outputs;
}

/// The components of a product and the gates before them, joined by their ports.
class JoinedPorts {
 public:
  explicit JoinedPorts(const slam::ProductComponents& product)
      : components_(slam::inOrder(product)), wired_(slam::wiredPortsOf(product)) {}

  const std::vector<slam::ProductComponent>& components() const { return components_; }

  Json inputsOf(const slam::Component& component) const {
    auto inputs = Json::array();
    for (const auto& input : portsOf(component).inputs()) {
      const auto* maker = wired_.makerOf(input);
      inputs.push_back(describe(input));
      inputs.back()["made_by"] = keyOf(maker);
      inputs.back()["gate"] =
          maker != nullptr && maker->gate != nullptr ? Json(maker->gate->name()) : Json();
    }
    return inputs;
  }

  Json gates() const {
    auto gates = Json::array();
    for (const auto& gate : wired_.gates()) {
      auto outputs = Json::array();
      for (const auto& output : portsOf(*gate).outputs()) outputs.push_back(describe(output));
      gates.push_back({{"name", gate->name()}, {"inputs", inputsOf(*gate)}, {"outputs", outputs}});
    }
    return gates;
  }

 private:
  const slam::Ports& portsOf(const slam::Component& component) const {
    const auto& parts = wired_.parts();
    return std::find_if(parts.begin(), parts.end(),
                        [&](const auto& part) { return part.component == &component; })
        ->ports;
  }

  /// The product's key of the component that makes the data; null: a gate does, or they come from
  /// outside.
  Json keyOf(const slam::WiredPorts::Part* maker) const {
    for (const auto& component : components_)
      if (maker != nullptr && component.component == maker->component) return component.key;
    return nullptr;
  }

  std::vector<slam::ProductComponent> components_;
  slam::WiredPorts wired_;
};

template <class Role>
std::vector<std::string> namesOf() {
  return slam::Registry<Role>::instance().names();
}

}  // namespace

Json describeComponents() {
  return {{"backend", namesOf<slam::Backend>()},
          {"odometry", namesOf<slam::OdometrySource>()},
          {"detector", namesOf<slam::LandmarkDetector>()},
          {"association", namesOf<slam::association::AssociationPolicy>()},
          {"modules", namesOf<slam::MapModule>()}};
}

Json describePorts(const slam::ProductConfig& product) {
  const auto parts = slam::createComponents(product);
  const JoinedPorts joined(parts);
  auto components = Json::array();
  for (const auto& part : joined.components())
    components.push_back({{"role", part.role},
                          {"key", part.key},
                          {"features", part.features},
                          {"name", part.name},
                          {"inputs", joined.inputsOf(*part.component)},
                          {"outputs", outputsOf(parts, part)}});
  return {{"components", components},
          {"gates", joined.gates()},
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
