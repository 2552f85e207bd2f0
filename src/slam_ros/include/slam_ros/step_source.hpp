// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "slam_core/product/estimator.hpp"
#include "slam_core/product/meta_coordinator.hpp"

namespace slam_ros {

/// What an EstimatorNode drives: a back-end alone, or the whole product in one process.
class StepSource {
 public:
  virtual ~StepSource() = default;
  /// @throw slam::ConfigError listing the faults of the whole product
  virtual void configure(slam::Settings& settings) = 0;
  virtual slam::Estimator& estimator() = 0;
  virtual void set(const slam::Motion& motion) = 0;
  /// In force at once, as slam::Estimator::set().
  virtual slam::Status set(const slam::MapState& map) = 0;
  /// Of the laser; nothing comes of these two unless usesScans().
  virtual void set(const slam::LaserSweep& sweep) = 0;
  virtual void set(const slam::LaserMount& mount) = 0;
  virtual bool usesScans() const = 0;
  virtual slam::Status execute() = 0;
  virtual slam::Counters counters() const = 0;
  virtual std::uint64_t dropped() const = 0;
  virtual void reset() = 0;
};

/// Composition pubsub: motion and observations come as messages, scans from the sensor.
class BackendAlone final : public StepSource {
 public:
  explicit BackendAlone(std::unique_ptr<slam::Backend> backend) : backend_(std::move(backend)) {}

  void configure(slam::Settings& settings) override {
    slam::validateProduct(settings);
    laser_.configure(settings.read<slam::LaserConfig>());
    estimator_.configure(settings, std::move(backend_));
  }
  slam::Estimator& estimator() override { return estimator_; }
  void set(const slam::Motion& motion) override { estimator_.set(motion); }
  slam::Status set(const slam::MapState& map) override { return estimator_.set(map); }
  void set(const slam::LaserSweep& sweep) override { takeScans(sweep); }
  void set(const slam::LaserMount& mount) override { takeScans(mount); }
  bool usesScans() const override { return estimator_.usesScans(); }
  slam::Status execute() override;
  slam::Counters counters() const override;
  std::uint64_t dropped() const override { return estimator_.dropped(); }
  void reset() override;

 private:
  template <class Input>
  void takeScans(const Input& input);

  slam::ScanGate laser_;
  slam::Status laser_status_;
  std::unique_ptr<slam::Backend> backend_;
  slam::Estimator estimator_;
};

/// Composition inprocess: raw inputs pass through the front-end here.
class WholeProduct final : public StepSource {
 public:
  void configure(slam::Settings& settings) override { coordinator_.configure(settings); }
  slam::Estimator& estimator() override { return coordinator_.estimator(); }
  void set(const slam::Motion& motion) override { coordinator_.set(motion); }
  slam::Status set(const slam::MapState& map) override { return coordinator_.set(map); }
  void set(const slam::LaserSweep& sweep) override { coordinator_.set(sweep); }
  void set(const slam::LaserMount& mount) override { coordinator_.set(mount); }
  bool usesScans() const override { return coordinator_.usesScans(); }
  slam::Status execute() override { return coordinator_.execute(); }
  slam::Counters counters() const override { return coordinator_.counters(); }
  std::uint64_t dropped() const override { return coordinator_.dropped(); }
  void reset() override { coordinator_.reset(); }
  slam::MetaCoordinator& coordinator() { return coordinator_; }

 private:
  slam::MetaCoordinator coordinator_;
};

}  // namespace slam_ros
