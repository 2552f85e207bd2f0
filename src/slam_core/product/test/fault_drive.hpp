// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/product/checkpoint.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/product/test/drive_invariants.hpp"
#include "slam_core/product/test/fault_world.hpp"
#include "slam_core/product/test/faulty_link.hpp"
#include "slam_core/product/test/report_line.hpp"

namespace slam::test {

/// A product that is driven behind a link with faults.
struct FaultyProduct {
  std::string name;
  std::vector<std::string> settings;
  bool has_scans = false;
  int drives = 1;  ///< in a short run

  friend std::ostream& operator<<(std::ostream& out, const FaultyProduct& product) {
    return out << product.name;
  }
};

/// A drive of a product behind a link with faults, in which services are called, and the process is
/// killed and resumed, at random moments. Everything follows from the seed: half of the drives are
/// of the whole product and half of its back-end alone, one in twenty is long, and half are without
/// services.
class FaultDrive {
 public:
  FaultDrive(const FaultyProduct& product, std::uint64_t seed)
      : product_(product),
        random_(seed, 2),
        faults_(LinkFaults::random(random_)),
        link_(seed, faults_),
        part_(partOf(product, seed)),
        world_(seed, product.has_scans, part_.extent == ProductPart::Extent::kWhole),
        steps_(seed % 20 == 0 ? 3000 : 300),
        has_services_(random_.uniform() < 0.5),
        running_(made()) {
    invariants_.expectHonesty(faults_.areOfArrivalOnly() && !has_services_);
  }

  /// @return what was broken first; empty where nothing was
  std::string run() {
    try {
      drive();
    } catch (const std::exception& error) {
      invariants_.fail(std::string("an exception: ") + error.what());
    }
    return invariants_.broken();
  }

  std::size_t largestCheckpoint() const { return invariants_.largest(); }
  double simulatedHours() const { return steps_ * FaultWorld::kSecondsOfStep / 3600.0; }

 private:
  using Input = ProductInput;
  using Extent = ProductPart::Extent;

  static ProductPart partOf(const FaultyProduct& product, std::uint64_t seed) {
    const auto& all = product.settings;
    const bool has_front_end = std::any_of(all.begin(), all.end(), [](const std::string& setting) {
      return setting.rfind("odometry=", 0) == 0 || setting.rfind("pointmap=", 0) == 0;
    });
    ProductPart part;
    if (!has_front_end && seed % 2 == 0) part.extent = Extent::kBackend;
    return part;
  }

  std::unique_ptr<MetaCoordinator> made() const {
    Settings settings({}, {}, product_.settings);
    auto product = std::make_unique<MetaCoordinator>();
    product->configure(settings, part_);
    return product;
  }

  void drive() {
    for (auto& input : world_.begin()) take(std::move(input));
    save(false);
    for (int i = 0; i < steps_ && invariants_.hold(); ++i) {
      for (auto& message : world_.next()) send(std::move(message), i);
      if (has_services_ && random_.uniform() < 0.01) callService();
      if (random_.uniform() < 0.02 && isSaved(i)) save(i > 20);
      if (random_.uniform() < 0.02) kill(i);
    }
    if (invariants_.hold()) invariants_.checkEnd(*running_);
  }

  /// A checkpoint is written behind steps only, and not before a pause has been judged.
  bool isSaved(int step) const { return step >= saves_from_ && has_stepped_; }

  /// The first messages arrive as they are, since the first pose is the map's origin.
  void send(Message message, int step) {
    if (step < 3) return give(message);
    for (const auto& arrived : link_.pass(std::move(message))) give(arrived);
  }
  void give(const Message& message) {
    invariants_.count(message);
    take([message](MetaCoordinator& product) {
      std::visit([&product](const auto& value) { product.set(value); }, message);
    });
  }

  /// Gives the product an input and takes the steps that are due then.
  void take(Input input) {
    since_saved_.push_back(std::move(input));
    told_ += executed(since_saved_.back(), *running_, &invariants_);
  }

  std::string executed(const Input& input, MetaCoordinator& product, DriveInvariants* invariants) {
    input(product);
    std::string lines;
    while (true) {
      const auto status = product.execute();
      if (invariants != nullptr) invariants->check(status);
      if (!status.isOk()) lines += status.message + "\n";
      const auto& report = product.estimator().report();
      if (!report) break;
      lines += lineOf(*report);
      has_stepped_ = true;
      if (invariants != nullptr) invariants->check(*report, world_.truths());
    }
    if (invariants != nullptr) invariants->check(product);
    return lines;
  }

  void save(bool has_map) {
    has_map_ = has_map;
    checkpoint_ = checkpointOf(identity_, stateOf(*running_));
    invariants_.checkSize(checkpoint_.size(), steps_);
    since_saved_.clear();
    told_.clear();
  }

  /// The process ends; another one goes on from the last checkpoint.
  void kill(int step) {
    if (!isRefused(damaged())) return invariants_.fail("a damaged checkpoint was accepted");
    auto resumed = made();
    restore(stateIn(checkpoint_, identity_), *resumed);
    // a checkpoint without a map begins another one
    if (has_map_ && random_.uniform() < 0.25)
      return goOnWithoutWhatWasMissed(std::move(resumed), step);
    std::string told;
    for (const auto& input : since_saved_) told += executed(input, *resumed, nullptr);
    if (told != told_) return invariants_.fail("a resumed run that reports something else");
    if (stateOf(*resumed) != stateOf(*running_))
      return invariants_.fail("a resumed run that has another state");
    running_ = std::move(resumed);
  }

  /// The messages since the checkpoint are lost, as for a robot that drove on. A checkpoint does
  /// not hold how the process was interrupted: each process that resumes from it is told that anew.
  void goOnWithoutWhatWasMissed(std::unique_ptr<MetaCoordinator> resumed, int step) {
    constexpr int kUntilJudged = 50;
    saves_from_ = step + kUntilJudged;
    running_ = std::move(resumed);
    since_saved_.clear();
    told_.clear();
    has_stepped_ = false;
    invariants_.beginAnew();
    const auto interruption =
        random_.uniform() < 0.5 ? Interruption::kOfThisProcess : Interruption::kOfAll;
    take([interruption](MetaCoordinator& product) { goOnLive(product, interruption); });
  }

  std::string damaged() {
    auto bytes = checkpoint_;
    if (random_.uniform() < 0.5) return bytes.substr(0, random_.bits() % bytes.size());
    bytes[random_.bits() % bytes.size()] ^= static_cast<char>(1 << random_.bits() % 8);
    return bytes;
  }
  bool isRefused(const std::string& checkpoint) const {
    try {
      stateIn(checkpoint, identity_);
    } catch (const std::runtime_error&) {
      return true;
    }
    return false;
  }

  void callService() {
    invariants_.beginAnew();
    auto& estimator = running_->estimator();
    auto* keeper = estimator.capabilities().find<MapKeeper>();
    switch (random_.bits() % 5) {
      case 0:
        return take([](MetaCoordinator& product) { product.reset(); });
      case 1:
        return take([paused = random_.uniform() < 0.5](MetaCoordinator& product) {
          product.estimator().pause(paused);
        });
      case 2:
        return take([truth = world_.truth()](MetaCoordinator& product) {
          product.estimator().set(PoseEstimate{truth, 0.01 * Eigen::Matrix3d::Identity()});
        });
      case 3:
        return take([](MetaCoordinator& product) {
          relocaliserOf(product.estimator()).assume(relocalisation::Belief::kAnywhere);
        });
      default:
        if (keeper == nullptr) return;
        take([map = keeper->state()](MetaCoordinator& product) { product.set(map); });
    }
  }

  FaultyProduct product_;
  RandomStream random_;
  LinkFaults faults_;
  FaultyLink link_;
  ProductPart part_;
  FaultWorld world_;
  int steps_;
  bool has_services_;
  RunIdentity identity_{"product", "robot", "data", "configuration"};
  std::unique_ptr<MetaCoordinator> running_;
  std::string checkpoint_;
  std::vector<Input> since_saved_;  ///< all that the product was given since the checkpoint
  std::string told_;                ///< and what it reported
  bool has_map_ = false;            ///< the checkpoint
  bool has_stepped_ = false;        ///< since the process has gone on
  int saves_from_ = 0;              ///< no checkpoint is written before this step
  DriveInvariants invariants_;
};

}  // namespace slam::test
