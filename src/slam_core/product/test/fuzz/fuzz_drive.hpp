// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/common/test/fuzz/field_change.hpp"
#include "slam_core/common/test/fuzz/fuzz_target.hpp"
#include "slam_core/product/test/drive_invariants.hpp"
#include "slam_core/product/test/fault_world.hpp"

namespace slam::test {

/// A product, and what drives it.
struct FuzzedProduct {
  std::vector<std::string> settings;
  bool has_scans;
  int steps;  ///< at most
};

/// A drive of a product of which bytes say what happens to each message between sensors and
/// product, and which services are called: messages are lost, come twice or late, any of their
/// fields has any value; maps and initial poses are given likewise; checkpoints are written and
/// resumed.
class FuzzDrive {
 public:
  FuzzDrive(const FuzzedProduct& product, FuzzBytes bytes)
      : product_(product),
        bytes_(bytes),
        is_whole_(product.has_scans || bytes_.below(2) == 0),
        world_(1, product.has_scans, is_whole_),
        running_(made()) {}

  /// Ends the program where an invariant is broken.
  void run() {
    for (auto& input : world_.begin()) input(*running_);
    pass(3);  // the first pose is the map's origin
    while (!bytes_.isEmpty() && steps_ < product_.steps) {
      happen();
      requireThat(invariants_.hold(), invariants_.broken());
    }
    pass(5);
    invariants_.checkEnd(*running_);
    requireThat(invariants_.hold(), invariants_.broken());
  }

 private:
  std::unique_ptr<MetaCoordinator> made() const {
    ProductPart part;
    if (!is_whole_) part.extent = ProductPart::Extent::kBackend;
    Settings settings({}, {}, product_.settings);
    auto product = std::make_unique<MetaCoordinator>();
    product->configure(settings, part);
    return product;
  }

  std::vector<Message> next() {
    ++steps_;
    return world_.next();
  }
  void pass(std::uint64_t count) {
    for (; count > 0; --count)
      for (const auto& message : next()) give(message);
  }

  void happen() {
    switch (bytes_.below(12)) {
      case 0:
        return pass(1 + bytes_.below(12));
      case 1:
        return next().clear();
      case 2:
        return call();
      case 3:
        return resume();
      case 4:
        return release();
      default:
        for (auto& message : next()) disturb(std::move(message));
    }
  }

  void disturb(Message message) {
    switch (bytes_.below(8)) {
      case 0:
        return;
      case 1:
        return late_.push_back(std::move(message));
      case 2:
        give(message);
        return give(message);
      case 3:
        return give(message);
      default:
        for (auto left = 1 + bytes_.below(3); left > 0; --left)
          std::visit([this](auto& value) { FieldChange::in(value, bytes_); }, message);
        give(message);
    }
  }
  void release() {
    for (auto& message : std::exchange(late_, {})) give(message);
  }

  void give(const Message& message) {
    invariants_.count(message);
    std::visit([this](const auto& value) { running_->set(value); }, message);
    takeSteps();
  }
  void takeSteps() {
    do {
      invariants_.check(running_->execute());
      if (const auto& report = running_->estimator().report())
        invariants_.check(*report, world_.truths());
    } while (running_->estimator().report());
    invariants_.check(*running_);
  }

  /// Calls a service with made-up values. The product refuses values that it cannot use with an
  /// error, and goes on.
  void call() {
    invariants_.beginAnew();
    auto& estimator = running_->estimator();
    switch (bytes_.below(6)) {
      case 0:
        return running_->reset();
      case 1:
        return estimator.pause(bytes_.below(2) == 0);
      case 2:
        return put(PoseEstimate{world_.truth(), 0.01 * Eigen::Matrix3d::Identity()}, estimator);
      case 3:
        return relocaliserOf(estimator).assume(relocalisation::Belief::kAnywhere), void();
      case 4:
        return removeLandmark(static_cast<LandmarkId>(bytes_.below(32)), estimator), void();
      default:
        if (auto* keeper = estimator.capabilities().find<MapKeeper>())
          put(keeper->state(), *running_);
    }
  }
  template <class Value, class Target>
  void put(Value value, Target& target) {
    for (auto left = bytes_.below(3); left > 0; --left) FieldChange::in(value, bytes_);
    target.set(value);
  }

  void resume() {
    const auto state = stateOf(*running_);
    auto resumed = made();
    restore(state, *resumed);
    requireThat(stateOf(*resumed) == state, "a resumed run that has another state");
    running_ = std::move(resumed);
  }

  const FuzzedProduct& product_;
  FuzzBytes bytes_;
  bool is_whole_;
  FaultWorld world_;
  std::unique_ptr<MetaCoordinator> running_;
  DriveInvariants invariants_;
  std::deque<Message> late_;
  int steps_ = 0;
};

/// Drives one of the products, which the first byte chooses.
inline void driveOneOf(const std::vector<FuzzedProduct>& products, FuzzBytes bytes) {
  const auto& product = products[bytes.below(products.size())];
  FuzzDrive(product, bytes).run();
}

}  // namespace slam::test
