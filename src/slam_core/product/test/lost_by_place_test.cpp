// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <tuple>

#include "slam_core/common/random.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

using relocalisation::Belief;

/// A robot that drives in a circle among landmarks that nobody can tell apart but by their places.
class Grove {
 public:
  explicit Grove(std::uint64_t seed) : random_(seed, 0) {
    constexpr int kTrees = 60;
    constexpr double kEdge = 30.0;  // [m]
    for (int i = 0; i < kTrees; ++i)
      trees_.emplace_back(kEdge * random_.uniform(), kEdge * random_.uniform());
  }

  Motion drive() {
    Motion motion;
    motion.sequence = count_;
    motion.start = stamp();
    ++count_;
    motion.end = stamp();
    motion.increment = Pose2::exp({0.2, 0.0, 0.025});  // a circle of 8 m radius
    motion.covariance = Eigen::Vector3d(4e-5, 1e-5, 2e-5).asDiagonal();
    motion.odometry_start = odometry_;
    odometry_ = motion.odometry_end = odometry_ * motion.increment;
    truth = truth * motion.increment;
    return motion;
  }
  LandmarkObservationArray look() {
    LandmarkObservationArray array;
    array.sequence = count_;
    array.stamp = stamp();
    for (const auto& tree : trees_) {
      const auto place = truth.inverse().transform(tree);
      constexpr double kReach = 7.0, kSigma = 0.03, kSigmaBearing = 0.01;  // [m], [m], [rad]
      if (place.norm() > kReach || place.norm() < 0.5 || random_.uniform() < 0.05) continue;
      LandmarkObservation z;
      z.range = place.norm() + kSigma * random_.gaussian();
      z.bearing = std::atan2(place.y(), place.x()) + kSigmaBearing * random_.gaussian();
      z.covariance << kSigma * kSigma, 0.0, 0.0, kSigmaBearing * kSigmaBearing;
      array.observations.push_back(z);
    }
    return array;
  }

  Pose2 truth{15.0, 7.0, 0.0};

 private:
  Stamp stamp() const {
    return stampFromNanoseconds(1000000000000) + count_ * std::chrono::milliseconds(100);
  }

  RandomStream random_;
  std::vector<Eigen::Vector2d> trees_;
  Pose2 odometry_;
  std::uint64_t count_ = 0;
};

class LostByPlace : public testing::TestWithParam<std::tuple<std::string, std::string>> {
 protected:
  void SetUp() override {
    const auto& [backend, policy] = GetParam();
    Settings settings({}, {}, {"association=" + policy});
    estimator.use(Registry<Backend>::instance().create(backend));
    estimator.configure(settings);
  }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) {
      estimator.set(grove.drive());
      estimator.set(grove.look());
      while (true) {
        estimator.execute();
        if (!estimator.report()) break;
        report = *estimator.report();
      }
      on_step();
    }
  }
  /// Lifts the robot, and puts it down elsewhere on its way.
  void carry(int steps) { grove.truth = grove.truth * Pose2::exp(steps * kStep); }
  bool isSure() { return relocaliserOf(estimator).belief() == Belief::kSure; }
  double error() const {
    const Pose2 in_map = kStart.inverse() * grove.truth;
    return (report.pose.pose.position() - in_map.position()).norm();
  }

  const Eigen::Vector3d kStep{0.2, 0.0, 0.025};
  const Pose2 kStart{15.0, 7.0, 0.0};
  static constexpr int kLap = 252;  // steps
  Grove grove{1};
  Estimator estimator;
  StepReport report;
  std::function<void()> on_step = [] {};
};

TEST_P(LostByPlace, NoticesThatItWasCarriedAwayAndFindsItselfAgain) {
  drive(kLap + 40);
  ASSERT_TRUE(isSure());
  ASSERT_LT(error(), 0.3);
  carry(100);
  int since = 0, lost = 0, wrong = 0;
  on_step = [&] {
    constexpr int kNoticed = 30;  // steps, 6 m
    lost += !isSure();
    wrong += ++since > kNoticed && isSure() && error() > 0.5;
  };
  drive(80);
  EXPECT_GT(lost, 0);
  EXPECT_EQ(wrong, 0);
  EXPECT_TRUE(isSure());
  EXPECT_LT(error(), 0.5);
}

TEST_P(LostByPlace, IsNotLostOnLapsThatNothingDisturbs) {
  int lost = 0;
  on_step = [&] { lost += !isSure(); };
  drive(3 * kLap);
  EXPECT_EQ(lost, 0);
}

INSTANTIATE_TEST_SUITE_P(Policies, LostByPlace,
                         testing::Combine(testing::Values("ekf", "graph"),
                                          testing::Values("nearest", "jcbb")));

}  // namespace
}  // namespace slam
