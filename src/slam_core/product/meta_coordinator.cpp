// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/meta_coordinator.hpp"

#include <stdexcept>
#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/models/odometry_sample.hpp"

namespace slam {

void MetaCoordinator::configure(Settings& settings, const ProductPart& part) {
  using Extent = ProductPart::Extent;
  // In `pubsub` only the back-end's nodelet checks the configuration of the whole product: a
  // temporary coordinator reads all of it and throws what is wrong.
  if (part.extent == Extent::kBackend) MetaCoordinator().configure(settings);
  FaultCollector faults;
  parts_ = makeComponents(settings, part, faults);
  const auto frames = parts_.frames;
  const auto fill_in = [frames](auto& data) {
    frames.complete(data.odometry_frame, data.base_frame);
  };
  wiring_ = Wiring(Completions().add<OdometrySample>(fill_in).add<Motion>(fill_in));
  const bool is_whole = part.extent == Extent::kWhole;
  connect(parts_, is_whole, wiring_);
  faults.attempt([&] { wiring_.connect(settings); });
  if (is_whole && parts_.is_complete) {
    // else nobody knows which sections are left over
    faults.attempt([&] { KnownSections::instance().checkUnused(settings); });
    faults.attempt([&] { settings.requireAllRead(); });
  }
  faults.raise();
}

/// The one name of all inputs that take data of this kind; empty where nobody takes them.
std::string MetaCoordinator::portOf(Kind kind) const {
  std::string name;
  for (const auto& input : wiring_.ports().inputs()) {
    if (input.kind != kind || input.name == name) continue;
    if (!name.empty())
      throw std::logic_error("data of kind " + nameOf(kind) + " are taken in at '" + name +
                             "' and at '" + input.name + "'; say which is meant");
    name = input.name;
  }
  return name;
}

Status MetaCoordinator::set(const MapState& map) {
  return beginningModules(parts_.estimator->set(map));
}

Status MetaCoordinator::set(const SavedSession& session) {
  return beginningModules(parts_.estimator->set(session));
}

/// The modules follow where the back-end could use what it was given.
Status MetaCoordinator::beginningModules(Status status) {
  if (status.level != Status::Level::kError)
    for (const auto& [name, module] : parts_.modules) module->reset();
  return status;
}

std::uint64_t MetaCoordinator::dropped() const {
  std::uint64_t sum = 0;
  if (parts_.odometry) sum += parts_.odometry->dropped();
  for (const auto& detector : parts_.detectors) sum += detector.component->dropped();
  for (const auto& stage : parts_.stages) sum += stage.component->dropped();
  if (parts_.estimator) sum += parts_.estimator->dropped();
  for (const auto& gate : wiring_.gates()) sum += gate->dropped();
  return sum;
}

std::string stateOf(const MetaCoordinator& product) {
  ArchiveWriter archive;
  archive(product);
  return archive.take();
}

void restore(const std::string& state, MetaCoordinator& product) {
  ArchiveReader archive(state);
  archive(product);
  if (archive.left() > 0)
    throw std::runtime_error("it goes on behind its last record: save it again");
}

void goOnLive(MetaCoordinator& product, Interruption interruption) {
  const auto& parts = product.components();
  if (parts.odometry) parts.odometry->goOnLive();
  if (parts.estimator) goOnLive(*parts.estimator, interruption);
}

}  // namespace slam
