// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <opencv2/core.hpp>
#include <string>

#include "slam_core/contract/place_reporter.hpp"
#include "slam_core/mono_ekf/test/textured_room.hpp"
#include "slam_core/product/meta_coordinator.hpp"

namespace slam {
namespace {

/// RatSLAM on circles through a painted room, with odometry that turns 1 % too far. The three
/// components are those of the product, joined by their ports.
class RatInTrouble : public testing::Test {
 protected:
  RatInTrouble() : room_(1) {
    room_.setSize({160, 120});
    configure(product_);
  }

  static void configure(MetaCoordinator& product) {
    Settings settings({}, {}, {"backend=rat", "detector=none", "odometry=wheel"});
    product.configure(settings);
  }

  static constexpr double kSpeed = 0.5, kRate = 0.2;  // [m/s, rad/s]
  static constexpr double kLap = 2.0 * M_PI / kRate;  // [s]

  /// The robot drives on; its wheels tell so ten times a second.
  void move(double seconds) {
    for (double left = seconds; left > 1e-9; left -= 0.1) {
      const double dt = std::min(left, 0.1);
      truth_ = truth_ * Pose2::exp({kSpeed * dt, 0.0, kRate * dt});
      give(Pose2::exp({kSpeed * dt, 0.0, 1.01 * kRate * dt}), dt);
    }
  }
  void give(const Pose2& increment, double dt) {
    Motion motion;
    motion.sequence = motions_++;
    motion.start = now();
    motion.end = Stamp(durationFromSeconds(time_ += dt));
    motion.increment = increment;
    motion.odometry_start = odometry_;
    motion.odometry_end = odometry_ = odometry_ * increment;
    motion.covariance = (Eigen::Vector3d(1e-4, 1e-4, 1e-3) * dt).asDiagonal();
    motion.odometry_frame = "odom";
    motion.base_frame = "base_link";
    product_.put("motion", motion);
    if (beside_ != nullptr) beside_->put("motion", motion);
  }
  Stamp now() const { return Stamp(durationFromSeconds(time_)); }
  CameraView seen(double turned = 0.0) { return room_.look(truth_, now(), turned); }
  /// Takes the image and all steps that are due. @return the last warning
  Status take(const CameraView& view) {
    if (beside_ != nullptr) beside_->put("camera", view);
    while (beside_ != nullptr && (beside_->execute(), beside_->estimator().report())) continue;
    product_.put("camera", view);
    Status last;
    while (true) {
      const auto status = product_.execute();
      if (!status.isOk()) last = status;
      const auto& report = product_.estimator().report();
      if (!report) return last;
      EXPECT_TRUE(report->pose.pose.isFinite());
      EXPECT_EQ(report->trust, Trust::kUnknown);
      EXPECT_EQ(report->pose.covariance.norm(), 0.0);
      truths_[report->stamp] = truth_;
      pose_ = report->pose.pose;
    }
  }
  void drive(double seconds, double interval = 0.1, double turned = 0.0) {
    for (double left = seconds; left > 1e-9; left -= interval) {
      move(interval);
      take(seen(turned));
    }
  }
  void driveBlind(double seconds, double gray) {
    for (double left = seconds; left > 1e-9; left -= 0.1) {
      move(0.1);
      auto view = seen();
      cv::RNG(static_cast<std::uint64_t>(time_ * 100))
          .fill(view.image.gray, cv::RNG::NORMAL, gray, 2.0);
      const auto status = take(view);
      EXPECT_NE(status.message.find("dark room"), std::string::npos) << status.message;
    }
  }

  /// Steps since a stamp at which the robot took itself to be where it was more than 10 s before.
  struct Recognised {
    int rightly = 0, wrongly = 0;
  };
  Recognised since(Stamp begin) const {
    Recognised recognised;
    const auto& places = *product_.estimator().capabilities().find<PlaceReporter>();
    for (const auto& [stamp, first] : places.visits()) {
      if (stamp <= begin || !first || stamp - *first < std::chrono::seconds(10)) continue;
      const Eigen::Vector2d off = truths_.at(stamp).position() - truths_.at(*first).position();
      ++(off.norm() < 1.0 ? recognised.rightly : recognised.wrongly);
    }
    return recognised;
  }
  double figure(const std::string& name) const {
    for (const auto& [other, value] : product_.wiring().figures())
      if (other == name) return value;
    return -1.0;
  }
  std::uint64_t count(const std::string& name) const { return product_.counters()[name]; }
  double error() const { return (pose_.position() - truth_.position()).norm(); }

  test::TexturedRoom room_;
  MetaCoordinator product_;
  MetaCoordinator* beside_ = nullptr;  ///< gets the same
  Pose2 truth_, odometry_, pose_;      ///< the last one: of the last step
  double time_ = 0.0;
  std::uint64_t motions_ = 0;
  std::map<Stamp, Pose2> truths_;  ///< at the steps
};

TEST_F(RatInTrouble, GoesOnByOdometryInADarkRoomAndBeforeABlankWall) {
  drive(kLap);
  const double views = figure("views"), experiences = figure("experiences");
  const auto begin = now();
  const Pose2 before = pose_, by_odometry = odometry_;
  driveBlind(3.0, 0.0);
  driveBlind(3.0, 190.0);
  EXPECT_EQ(count("local_view_blank"), 60U);
  EXPECT_EQ(figure("views"), views);
  EXPECT_EQ(figure("experiences"), experiences);
  EXPECT_EQ(since(begin).rightly + since(begin).wrongly, 0) << "no place is recognised";
  const auto driven = by_odometry.between(odometry_), reported = before.between(pose_);
  EXPECT_LT((driven.position() - reported.position()).norm(), 0.05);
  drive(20.0);
  EXPECT_GT(since(begin).rightly, 100) << "it recognises places again";
  EXPECT_EQ(since(begin).wrongly, 0);
}

TEST_F(RatInTrouble, RecognisesPlacesWithTwoImagesASecond) {
  drive(kLap, 0.5);
  const auto begin = now();
  drive(kLap, 0.5);
  EXPECT_GT(since(begin).rightly, 40) << "of 63 images";
  EXPECT_EQ(since(begin).wrongly, 0);
}

TEST_F(RatInTrouble, IsNotMovedByTheSameImageThatComesAgainAndAgain) {
  drive(kLap);
  drive(2.0);
  const auto loops = count("loops");
  EXPECT_GT(loops, 0U);
  auto frozen = seen();
  for (int i = 0; i < 50; ++i) {  // its driver repeats it, and the robot drives on
    move(0.1);
    frozen.stamp = frozen.image.stamp = now();
    take(frozen);
  }
  EXPECT_EQ(count("loops"), loops) << "one view convinces nobody";
  EXPECT_LT(error(), 0.2);
  const auto steps = truths_.size();
  take(frozen);
  EXPECT_EQ(truths_.size(), steps) << "with its stamp once more";
  const auto begin = now();
  drive(10.0);
  EXPECT_GT(since(begin).rightly, 50) << "of 100 images";
  EXPECT_EQ(since(begin).wrongly, 0);
}

TEST_F(RatInTrouble, TakesAnotherResolutionInTheMiddle) {
  drive(kLap);
  const double views = figure("views");
  const auto begin = now();
  room_.setSize({320, 240});
  drive(kLap);
  EXPECT_GT(since(begin).rightly, 200) << "of 314 images";
  EXPECT_EQ(since(begin).wrongly, 0);
  EXPECT_LT(figure("views"), 1.1 * views);
}

TEST_F(RatInTrouble, RecognisesNoPlaceWronglyWhenItsCameraIsTurnedByHand) {
  drive(kLap);
  auto begin = now();
  drive(kLap, 0.1, 0.5);
  EXPECT_EQ(since(begin).wrongly, 0);
  EXPECT_LT(error(), 0.5) << "it goes on by odometry, and learns the way anew";
  begin = now();
  drive(kLap);  // it is turned back
  EXPECT_GT(since(begin).rightly, 200) << "of 314 images";
  EXPECT_EQ(since(begin).wrongly, 0);
  EXPECT_LT(error(), 0.5);
}

TEST_F(RatInTrouble, GoesOnFromItsStateWithTheSameBits) {
  drive(10.0);
  const auto state = stateOf(product_);
  MetaCoordinator second;
  configure(second);
  restore(state, second);
  EXPECT_EQ(stateOf(second), state);
  beside_ = &second;
  drive(5.0);
  EXPECT_NE(stateOf(product_), state);
  EXPECT_EQ(stateOf(second), stateOf(product_));
}

TEST_F(RatInTrouble, RecognisesPlacesAfterAGapOfTenSecondsInItsImages) {
  drive(kLap);
  const auto begin = now();
  move(10.0);
  drive(15.0);
  EXPECT_GT(since(begin).rightly, 80) << "of 150 images";
  EXPECT_EQ(since(begin).wrongly, 0);
}

TEST_F(RatInTrouble, RecognisesPlacesAfterAGapOfTenSecondsInAllThatItGets) {
  drive(kLap);
  const auto begin = now();
  time_ += 10.0;  // it waits
  drive(15.0);
  EXPECT_GT(since(begin).rightly, 80) << "of 150 images";
  EXPECT_EQ(since(begin).wrongly, 0);
}

}  // namespace
}  // namespace slam
