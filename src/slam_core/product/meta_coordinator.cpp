// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/meta_coordinator.hpp"

#include <utility>

#include "slam_core/contract/registry.hpp"

namespace slam {

void MetaCoordinator::configure(Settings& settings) {
  ProductConfig product;
  FaultCollector faults;
  faults.attempt([&] { settings.read(product); });
  faults.attempt([&] { loadLibraries(product.libraries); });
  faults.attempt([&] {
    frames_ = settings.read<FramesConfig>();
    frames_.requireDistinctNames();
  });
  odometry_ = nullptr;
  std::unique_ptr<Backend> backend;
  faults.attempt(
      [&] { odometry_ = Registry<OdometrySource>::instance().create(product.odometry); });
  faults.attempt([&] { backend = Registry<Backend>::instance().create(product.backend); });
  const bool complete = odometry_ && backend;  // else nobody knows which sections are left over
  if (odometry_) faults.attempt([&] { odometry_->configure(settings); });
  if (backend) faults.attempt([&] { estimator_.configure(settings, std::move(backend)); });
  if (complete) faults.attempt([&] { settings.requireAllRead(); });
  faults.raise();
  front_end_status_ = Status::ok();
}

void MetaCoordinator::set(OdometrySample sample) {
  frames_.complete(sample.odometry_frame, sample.base_frame);
  odometry_->set(sample);
  const auto status = odometry_->execute();
  if (!status.isOk()) front_end_status_ = status;
  if (odometry_->motion()) estimator_.set(*odometry_->motion());
}

Status MetaCoordinator::execute() {
  const auto status = estimator_.execute();
  const auto front_end_status = std::exchange(front_end_status_, Status::ok());
  return front_end_status.isOk() ? status : front_end_status;
}

Counters MetaCoordinator::counters() const {
  Counters all = estimator_.counters();
  for (const auto& [reason, count] : odometry_->counters().all())
    all.add("odometry_" + reason, count);
  return all;
}

std::uint64_t MetaCoordinator::dropped() const {
  const auto& odometry = odometry_->counters();
  return estimator_.dropped() + odometry["late"] + odometry["invalid"];
}

void MetaCoordinator::reset() {
  odometry_->reset();
  estimator_.reset();
  front_end_status_ = Status::ok();
}

}  // namespace slam
