// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/product_components.hpp"

#include <algorithm>
#include <utility>

#include "slam_core/contract/registry.hpp"
#include "slam_core/product/joined_scan_gate.hpp"
#include "slam_core/product/stage_placing.hpp"

namespace slam {
namespace {

using Extent = ProductPart::Extent;

constexpr const char* kNone = "none";

template <class Role>
std::unique_ptr<Role> create(const std::string& name) {
  if (name == kNone) return nullptr;
  return Registry<Role>::instance().create(name);
}

ProductConfig named(ProductConfig product, const ProductPart& part) {
  if (part.name.empty()) return product;
  if (part.extent == Extent::kOdometry) product.odometry = part.name;
  if (part.extent == Extent::kDetector) product.detector = part.name;
  if (part.extent == Extent::kBackend) product.backend = part.name;
  return product;
}

void createDetectors(const ProductPart& part, ProductComponents& parts, FaultCollector& unknown) {
  std::vector<DetectorPlace> places;
  unknown.attempt([&] { places = detectorPlacesOf(parts.product); });
  for (const auto& place : places) {
    const bool is_one_of_them = part.extent == Extent::kWhole || place.prefix() == part.place;
    if (is_one_of_them)
      unknown.attempt([&] { parts.detectors.push_back({place, createDetector(place)}); });
  }
}

ProductComponents create(const ProductConfig& product, const ProductPart& part,
                         FaultCollector& faults) {
  ProductComponents parts;
  parts.product = product;
  FaultCollector unknown;
  if (part.has(Extent::kOdometry))
    unknown.attempt([&] { parts.odometry = create<OdometrySource>(product.odometry); });
  if (part.has(Extent::kDetector)) createDetectors(part, parts, unknown);
  if (part.has(Extent::kBackend))
    unknown.attempt([&] {
      auto backend = Registry<Backend>::instance().create(product.backend);
      parts.estimator = std::make_unique<Estimator>();
      parts.estimator->use(std::move(backend));
    });
  for (const auto& [name, is_wanted] : product.modules)
    if (part.extent == Extent::kModule ? part.name == name : part.has(Extent::kModule) && is_wanted)
      parts.modules[name] = Registry<MapModule>::instance().create(name);
  faults.attempt([&] { unknown.raise(); });
  parts.is_complete = unknown.isEmpty();
  return parts;
}

/// Once it is known what the other components take in.
void createStages(const ProductPart& part, ProductComponents& parts) {
  if (part.extent == Extent::kWhole) parts.stages = placeStages(inOrder(parts));
  if (part.extent == Extent::kStage)
    parts.stages.push_back({Registry<Stage>::instance().create(part.name), {}});
}

void configureDetectors(ProductComponents& parts, Settings& settings, FaultCollector& faults) {
  DetectorIds ids;
  for (const auto& [place, detector] : parts.detectors)
    faults.attempt([&, &place = place, &detector = detector] {
      detector->configure(settings);
      ids.add(place, *detector);
    });
  faults.attempt([&] { ids.requireUnique(); });
}

void configure(ProductComponents& parts, Settings& settings, std::uint64_t seed,
               FaultCollector& faults) {
  if (parts.odometry)
    faults.attempt([&] {
      parts.odometry->configure(settings);
      parts.odometry->seed(seed);
    });
  configureDetectors(parts, settings, faults);
  for (const auto& [name, module] : parts.modules)
    faults.attempt([&, &part = *module] { part.configure(settings); });
  if (parts.estimator) faults.attempt([&] { parts.estimator->configure(settings); });
}

void configureStages(ProductComponents& parts, Settings& settings, FaultCollector& faults) {
  for (const auto& stage : parts.stages)
    faults.attempt([&, &part = *stage.component] { part.configure(settings); });
}

/// Who makes a map of scans takes in those of both lasers, and needs motion to join them.
void requireJoinableScans(const ProductComponents& parts) {
  const auto& product = parts.product;
  if (!product.rear_laser) return;
  if (product.odometry == kNone)
    throw ConfigError(
        "rear_laser: the scans of two lasers are joined by the motion between their stamps, which "
        "a product with odometry: none does not have; choose an odometry source");
  const auto all = inOrder(parts);
  const bool is_taken = std::any_of(all.begin(), all.end(), [](const auto& part) {
    return portsOf(part).input(JoinedScanGate::kName, kindOf<LaserScan>()) != nullptr;
  });
  if (!is_taken)
    throw ConfigError(
        "rear_laser: no component of the product makes a map of scans; leave the key out, or "
        "choose map: grid or the point map");
}

}  // namespace

Ports portsOf(const ProductComponent& part) {
  auto own = portsOf(*part.component);
  if (!part.takes_joined_scans) return own;
  Ports ports;
  for (auto input : own.inputs()) {
    if (input.kind == kindOf<LaserScan>()) input.name = JoinedScanGate::kName;
    ports.add(std::move(input));
  }
  for (const auto& output : own.outputs()) ports.add(output);
  return ports;
}

void connect(ProductComponents& parts, bool is_whole, Wiring& wiring) {
  for (const auto& part : inOrder(parts)) {
    const bool is_estimator = part.component == parts.estimator.get();
    wiring.add(is_whole && !is_estimator ? part.key + "_" : "", *part.component,
               is_estimator ? Wiring::Turn::kOnRequest : Wiring::Turn::kAtOnce, part.title(),
               portsOf(part));
  }
}

std::vector<ProductComponent> inOrder(const ProductComponents& parts) {
  const auto& names = parts.product;
  std::vector<ProductComponent> all;
  if (parts.odometry)
    all.push_back(
        {OdometrySource::kRole, "odometry", names.odometry, parts.odometry.get(), {"odometry"}});
  for (const auto& [place, detector] : parts.detectors)
    all.push_back(
        {LandmarkDetector::kRole, place.key(), place.name, detector.get(), place.features()});
  for (const auto& [stage, features] : parts.stages)
    all.push_back({Stage::kRole, stage->name(), stage->name(), stage.get(), features});
  if (parts.estimator)
    all.push_back({Backend::kRole,
                   "backend",
                   names.backend,
                   parts.estimator.get(),
                   {"backend"},
                   names.rear_laser});
  for (const auto& [name, module] : parts.modules)
    all.push_back({MapModule::kRole, name, name, module.get(), {name}, names.rear_laser});
  return all;
}

ProductComponents makeComponents(Settings& settings, const ProductPart& part,
                                 FaultCollector& faults) {
  ProductConfig product;
  FramesConfig frames;
  faults.attempt([&] { readProduct(settings, product); });
  faults.attempt([&] {
    settings.read(frames);
    frames.requireDistinctNames();
  });
  auto parts = create(named(product, part), part, faults);
  parts.frames = frames;
  configure(parts, settings, product.seed, faults);
  if (part.extent == Extent::kWhole) faults.attempt([&] { requireJoinableScans(parts); });
  faults.attempt([&] { createStages(part, parts); });
  configureStages(parts, settings, faults);
  return parts;
}

ProductComponents createComponents(const ProductConfig& product, const ProductPart& part) {
  loadLibraries(product.libraries);
  FaultCollector faults;
  auto parts = create(named(product, part), part, faults);
  if (parts.estimator) faults.attempt([&] { parts.estimator->adaptTo(product); });
  if (part.extent == Extent::kWhole) faults.attempt([&] { requireJoinableScans(parts); });
  faults.attempt([&] { createStages(part, parts); });
  faults.raise();
  return parts;
}

WiredPorts wiredPortsOf(const ProductComponents& parts) {
  WiredPorts ports;
  for (const auto& part : inOrder(parts)) ports.add(part.title(), *part.component, portsOf(part));
  ports.placeGates();
  return ports;
}

std::vector<InputPort> inputsOf(const ProductConfig& product, const ProductPart& part) {
  auto parts = createComponents(product, part);
  Wiring wiring;
  connect(parts, true, wiring);
  return wiring.ports().inputs();
}

}  // namespace slam
