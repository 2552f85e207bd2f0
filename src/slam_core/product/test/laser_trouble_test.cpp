// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/test/laser_trouble.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <functional>
#include <memory>
#include <string>

#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam {
namespace {

using test::EndlessDrive;
using test::RoomDrive;

/// Whoever tells from a laser where the robot is.
class LaserUser {
 public:
  virtual ~LaserUser() = default;
  virtual void take(const RoomDrive::Step& step) = 0;
  virtual PoseEstimate pose() const = 0;

  bool has_warned = false;  ///< at the last scan

 protected:
  static Settings settings() { return Settings({}, {}, {"pf.particles=15"}); }
};

class BackendOfALaser final : public LaserUser {
 public:
  BackendOfALaser(const std::string& name, bool has_wheels)
      : backend_(Registry<Backend>::instance().create(name)), has_wheels_(has_wheels) {
    if (auto* chooser = capabilitiesOf(*backend_).find<MapChooser>())
      chooser->useMap(MapKind::kGrid);
    auto all = settings();
    backend_->configure(all);
    inputs_ = std::make_unique<test::ComponentDriver>(*backend_);
  }

  void take(const RoomDrive::Step& step) override {
    if (has_wheels_) inputs_->set(step.motion);
    inputs_->set(step.scan);
    has_warned = !backend_->execute().isOk();
  }
  PoseEstimate pose() const override { return backend_->pose(); }

 private:
  std::unique_ptr<Backend> backend_;
  std::unique_ptr<test::ComponentDriver> inputs_;
  bool has_wheels_;
};

/// The covariance of its pose is what its motions add up to.
class OdometryOfALaser final : public LaserUser {
 public:
  explicit OdometryOfALaser(const std::string& name)
      : odometry_(Registry<OdometrySource>::instance().create(name)) {
    auto all = settings();
    odometry_->configure(all);
    inputs_ = std::make_unique<test::ComponentDriver>(*odometry_);
    pose_.covariance = 1e-8 * Eigen::Matrix3d::Identity();
  }

  void take(const RoomDrive::Step& step) override {
    has_warned = false;
    wheels_ = wheels_ * step.motion.increment;
    OdometrySample wheels;
    wheels.stamp = step.scan.stamp;
    wheels.pose = wheels_;
    inputs_->offer(wheels);
    execute();
    inputs_->set(step.scan);
    execute();
  }
  PoseEstimate pose() const override { return pose_; }

 private:
  void execute() {
    do {
      has_warned |= !odometry_->execute().isOk();
      if (odometry_->motion()) add(*odometry_->motion());
    } while (odometry_->isBusy());
  }
  void add(const Motion& motion) {
    EXPECT_EQ(faultOf(motion), "");
    Eigen::Matrix3d J_pose, J_u;
    pose_.pose = pose_.pose.compose(motion.increment, &J_pose, &J_u);
    pose_.covariance =
        J_pose * pose_.covariance * J_pose.transpose() + J_u * motion.covariance * J_u.transpose();
  }

  std::unique_ptr<OdometrySource> odometry_;
  std::unique_ptr<test::ComponentDriver> inputs_;
  Pose2 wheels_;
  PoseEstimate pose_;
};

struct User {
  std::string name;
  std::function<std::unique_ptr<LaserUser>()> make;
  bool has_wheels;
};

std::string nameOf(const testing::TestParamInfo<User>& user) { return user.param.name; }

/// What happens to lasers and wheels: never a NaN, and no silent wrong pose.
class LaserTrouble : public testing::TestWithParam<User> {
 protected:
  void SetUp() override {
    loadLibraries({});
    user = GetParam().make();
  }

  /// The pose is right, or it is covered by its covariance, or a sentence says that it is not.
  testing::AssertionResult isHonest(const Pose2& truth) const {
    const auto told = user->pose();
    if (!told.pose.isFinite() || !isCovariance(told.covariance))
      return testing::AssertionFailure() << "the pose or its covariance is none";
    const Pose2 error = truth.between(told.pose);
    const Eigen::Vector3d map_error(told.pose.x() - truth.x(), told.pose.y() - truth.y(),
                                    error.theta());
    const bool is_right = error.position().norm() < 0.1 && std::abs(error.theta()) < 0.05;
    constexpr double kMostSigmas = 6.0;
    const double squared = map_error.dot(told.covariance.inverse() * map_error);
    if (is_right || squared < kMostSigmas * kMostSigmas || user->has_warned)
      return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "off by " << error.position().norm() << " m and " << error.theta() << " rad, "
           << std::sqrt(squared) << " times what is told, and no word of it";
  }
  testing::AssertionResult isRight(const Pose2& truth, double within = 0.1) const {
    const double error = (user->pose().pose.position() - truth.position()).norm();
    if (error < within) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "off by " << error << " m";
  }

  /// @param spoil what happens to the steps @return the last one
  template <class Drive>
  RoomDrive::Step run(Drive& driven, int steps,
                      const std::function<void(RoomDrive::Step&)>& spoil = nullptr) {
    RoomDrive::Step step;
    for (int i = 0; i < steps; ++i) {
      step = driven.next();
      if (spoil) spoil(step);
      user->take(step);
      EXPECT_TRUE(isHonest(step.truth)) << "scan " << i;
      if (HasFailure()) break;
    }
    return step;
  }

  void followWalls(const std::vector<double>& walls) {
    EndlessDrive along(walls);
    for (int i = 0; i < 150; ++i) {
      const auto step = along.next();
      user->take(step);
      const auto told = user->pose();
      ASSERT_TRUE(told.pose.isFinite() && isCovariance(told.covariance)) << i;
      ASSERT_NEAR(told.pose.y(), step.truth.y(), 0.1) << i;
      ASSERT_NEAR(told.pose.theta(), 0.0, 0.05) << i;
      ASSERT_TRUE(!GetParam().has_wheels || isRight(step.truth, 0.5)) << i;
    }
  }

  std::unique_ptr<LaserUser> user;
  RoomDrive drive{1};
};

TEST_P(LaserTrouble, ALaserThatNeverSeesAnything) {
  run(drive, 60, [](auto& step) { step.scan.beams.clear(); });
}

TEST_P(LaserTrouble, ALaserThatGoesBlind) {
  run(drive, 40);
  run(drive, 60, [](auto& step) {
    for (auto& beam : step.scan.beams) beam = {beam.bearing, 8.0f, false};
  });
  run(drive, 1);
}

/// Walls that look the same everywhere tell how far away they are and which way they run. How far
/// along them the robot has gone, only the wheels know (docs/scan_matching.md, Limits).
TEST_P(LaserTrouble, OneWall) { followWalls({1.0}); }
TEST_P(LaserTrouble, ACorridorWithoutEnds) { followWalls({1.0, -1.2}); }

TEST_P(LaserTrouble, GlassAndPeople) {
  RandomStream people(5, 0);
  const auto last = run(drive, 60, [&](auto& step) { test::shorten(step.scan, 0.3, people); });
  EXPECT_TRUE(isRight(last.truth, 0.15));
}

TEST_P(LaserTrouble, OneScanTurnedOnItsHead) {
  run(drive, 40);
  run(drive, 1, [](auto& step) { test::mirror(step.scan); });
  const auto last = run(drive, 40);
  EXPECT_TRUE(isRight(last.truth));
}

/// Nobody can tell the world from its mirror image once the map is drawn anew.
TEST_P(LaserTrouble, ScansTurnedOnTheirHeadFromNowOnAreTold) {
  run(drive, 40);
  int warned = 0;
  for (int i = 0; i < 20; ++i) {
    auto step = drive.next();
    test::mirror(step.scan);
    user->take(step);
    warned += user->has_warned;
    EXPECT_TRUE(user->pose().pose.isFinite() && isCovariance(user->pose().covariance)) << i;
  }
  EXPECT_GT(warned, 0);
}

TEST_P(LaserTrouble, OdometryThatStandsStillWhileTheRobotDrives) {
  run(drive, 20);
  const auto last = run(drive, 100, [](auto& step) { step.motion.increment = Pose2(); });
  EXPECT_TRUE(isRight(last.truth));
}

TEST_P(LaserTrouble, OdometryThatDrivesTheOtherWayRound) {
  run(drive, 20);
  const auto last =
      run(drive, 125, [](auto& step) { step.motion.increment = step.motion.increment.inverse(); });
  EXPECT_TRUE(isRight(last.truth, 0.2));
}

TEST_P(LaserTrouble, FiveScansASecond) {
  drive.interval = std::chrono::milliseconds(200);
  drive.way_of_step = 0.2;
  EXPECT_TRUE(isRight(run(drive, 80).truth));
}

TEST_P(LaserTrouble, AHundredScansASecond) {
  drive.interval = std::chrono::milliseconds(10);
  drive.way_of_step = 0.01;
  EXPECT_TRUE(isRight(run(drive, 400).truth));
}

TEST_P(LaserTrouble, ScansOfOneBeam) {
  run(drive, 60, [](auto& step) { step.scan.beams.resize(1); });
}

TEST_P(LaserTrouble, ScansOfTenThousandBeams) {
  drive.beams = 10000;
  EXPECT_TRUE(isRight(run(drive, 8).truth, 0.05));
}

INSTANTIATE_TEST_SUITE_P(
    All, LaserTrouble,
    testing::Values(
        User{"grid", [] { return std::make_unique<BackendOfALaser>("grid", false); }, false},
        User{"grid_wheel", [] { return std::make_unique<BackendOfALaser>("grid", true); }, true},
        User{"pf_wheel", [] { return std::make_unique<BackendOfALaser>("pf", true); }, true},
        User{"laser", [] { return std::make_unique<OdometryOfALaser>("laser"); }, false},
        User{"laser_wheel", [] { return std::make_unique<OdometryOfALaser>("laser_wheel"); },
             true}),
    nameOf);

}  // namespace
}  // namespace slam
