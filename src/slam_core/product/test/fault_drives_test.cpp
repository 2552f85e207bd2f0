// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/estimator.hpp"
#include "slam_core/product/test/faulty_link.hpp"

namespace slam {
namespace {

using test::FaultyLink;
using test::LinkFaults;
using test::Message;

/// A drive of a product behind a link with faults, in which services are called at random moments
/// as well. Everything follows from the seed.
class FaultDrive {
 public:
  FaultDrive(std::string backend, bool has_grid, std::uint64_t seed)
      : random_(seed, 2),
        link_(seed, LinkFaults::random(random_)),
        world_(seed),
        room_(seed),
        has_grid_(has_grid) {
    Settings settings({}, {},
                      {"backend=" + backend,
                       std::string("map=") + (has_grid ? "grid" : "landmarks"), "pf.particles=10"});
    estimator_.use(Registry<Backend>::instance().create(backend));
    estimator_.configure(settings);
  }

  /// @return what was broken first; empty where nothing was
  std::string run() {
    try {
      drive();
    } catch (const std::exception& error) {
      broken_ = std::string("an exception: ") + error.what();
    }
    return broken_;
  }

 private:
  void drive() {
    constexpr int kSteps = 300;
    for (int i = 0; i < kSteps && broken_.empty(); ++i) {
      for (auto& message : messages())
        for (auto& arrived : link_.pass(std::move(message))) take(arrived);
      if (random_.uniform() < 0.01) callService();
    }
    if (broken_.empty()) checkMap();
  }

  std::vector<Message> messages() {
    if (has_grid_) {
      auto step = room_.next();
      truth_ = step.truth;
      return {step.motion, step.scan};
    }
    auto step = world_.next();
    truth_ = step.truth;
    return {step.motion, step.observations};
  }

  void take(const Message& message) {
    std::visit([this](const auto& m) { estimator_.set(m); }, message);
    for (estimator_.execute(); estimator_.report() && broken_.empty(); estimator_.execute())
      check(*estimator_.report());
  }

  void check(const StepReport& report) {
    const auto& [pose, P] = report.pose;
    if (!pose.isFinite() || !P.allFinite()) broken_ = "a pose that is not finite";
    if ((P - P.transpose()).norm() > 1e-9 * P.norm()) broken_ = "a covariance without symmetry";
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(P);
    if (eigen.eigenvalues()(0) < -1e-12 * eigen.eigenvalues()(2))
      broken_ = fmt::format("a covariance with the eigenvalue {}", eigen.eigenvalues()(0));
    if (last_ && report.stamp < *last_ && !report.restarted) broken_ = "a step back in time";
    last_ = report.stamp;
    const auto counted = total();
    if (counted < counted_ && !report.restarted) broken_ = "a counter that goes back";
    counted_ = counted;
    for (const auto& [what, count] : estimator_.intake().arrivals().held().all())
      if (count > kMostHeld) broken_ = fmt::format("{} messages of {} are held", count, what);
  }

  std::uint64_t total() const {
    std::uint64_t sum = 0;
    for (const auto& [reason, count] : estimator_.counters().all()) sum += count;
    return sum;
  }

  void checkMap() {
    const auto* keeper = estimator_.capabilities().find<MapKeeper>();
    if (keeper == nullptr) return;
    for (const auto& landmark : keeper->state().landmarks)
      if (!landmark.position.allFinite() || !landmark.covariance.allFinite())
        broken_ = fmt::format("landmark {} is not finite", landmark.id);
  }

  void callService() {
    auto* keeper = estimator_.capabilities().find<MapKeeper>();
    switch (random_.bits() % 5) {
      case 0:
        estimator_.reset();
        break;
      case 1:
        estimator_.pause(random_.uniform() < 0.5);
        break;
      case 2:
        estimator_.set(PoseEstimate{truth_, 0.01 * Eigen::Matrix3d::Identity()});
        break;
      case 3:
        relocaliserOf(estimator_).assume(relocalisation::Belief::kAnywhere);
        break;
      default:
        if (keeper != nullptr) estimator_.set(keeper->state());
    }
    // all of these may begin anew
    last_.reset();
    counted_ = 0;
  }

  static constexpr std::uint64_t kMostHeld = 5000;

  RandomStream random_;
  FaultyLink link_;
  test::SimulatedWorld world_;
  test::RoomDrive room_;
  bool has_grid_;
  Estimator estimator_;
  Pose2 truth_;
  std::optional<Stamp> last_;
  std::uint64_t counted_ = 0;
  std::string broken_;
};

struct Product {
  std::string backend;
  bool has_grid;
  int drives;  ///< those with scans take longer

  friend std::ostream& operator<<(std::ostream& out, const Product& product) {
    return out << product.backend << (product.has_grid ? " with scans" : " with landmarks");
  }
};

std::uint64_t numberIn(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

class FaultDrives : public testing::TestWithParam<Product> {};

INSTANTIATE_TEST_SUITE_P(Products, FaultDrives,
                         testing::Values(Product{"ekf", false, 12}, Product{"pf", false, 12},
                                         Product{"graph", false, 12}, Product{"grid", true, 3},
                                         Product{"pf", true, 2}, Product{"graph", true, 2}),
                         [](const auto& product) {
                           return product.param.backend +
                                  (product.param.has_grid ? "_scans" : "_landmarks");
                         });

/// FAULT_DRIVES=N multiplies the number of drives, as for a night; FAULT_SEED=S begins with another
/// one, as to repeat a drive that has failed.
TEST_P(FaultDrives, BreakNothing) {
  const auto& product = GetParam();
  const auto first = numberIn("FAULT_SEED", 1);
  const auto drives = static_cast<std::uint64_t>(product.drives) * numberIn("FAULT_DRIVES", 1);
  for (auto seed = first; seed < first + drives; ++seed) {
    FaultDrive drive(product.backend, product.has_grid, seed);
    ASSERT_EQ(drive.run(), "") << "FAULT_SEED=" << seed << " repeats it";
  }
}

}  // namespace
}  // namespace slam
