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
  virtual slam::Status execute() = 0;
  virtual slam::Counters counters() const = 0;
  virtual std::uint64_t dropped() const = 0;
  virtual void reset() = 0;
};

/// Composition pubsub: motion and observations come as messages.
class BackendAlone final : public StepSource {
 public:
  explicit BackendAlone(std::unique_ptr<slam::Backend> backend) : backend_(std::move(backend)) {}

  void configure(slam::Settings& settings) override {
    slam::validateProduct(settings);
    estimator_.configure(settings, std::move(backend_));
  }
  slam::Estimator& estimator() override { return estimator_; }
  slam::Status execute() override { return estimator_.execute(); }
  slam::Counters counters() const override { return estimator_.counters(); }
  std::uint64_t dropped() const override { return estimator_.dropped(); }
  void reset() override { estimator_.reset(); }

 private:
  std::unique_ptr<slam::Backend> backend_;
  slam::Estimator estimator_;
};

/// Composition inprocess: raw inputs pass through the front-end here.
class WholeProduct final : public StepSource {
 public:
  void configure(slam::Settings& settings) override { coordinator_.configure(settings); }
  slam::Estimator& estimator() override { return coordinator_.estimator(); }
  slam::Status execute() override { return coordinator_.execute(); }
  slam::Counters counters() const override { return coordinator_.counters(); }
  std::uint64_t dropped() const override { return coordinator_.dropped(); }
  void reset() override { coordinator_.reset(); }
  slam::MetaCoordinator& coordinator() { return coordinator_; }

 private:
  slam::MetaCoordinator coordinator_;
};

}  // namespace slam_ros
