// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/mono_ekf.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <string>

#include "slam_core/common/config_error.hpp"
#include "slam_core/mono_ekf/test/textured_room.hpp"

namespace slam::mono_ekf {
namespace {

Stamp at(double s) { return Stamp(durationFromSeconds(s)); }

/// A robot that drives an arc through a painted room, ten images a second, with exact odometry that
/// claims some noise.
class MonoEkfInARoom : public testing::Test {
 protected:
  MonoEkfInARoom() : room_(1, kHalf), inputs_(portsOf(filter_)) {
    filter_.configure(MonoEkfConfig());
  }

  /// @param sign -1 for odometry whose directions are reversed
  Motion move(double seconds = 0.1, double sign = 1.0) {
    const Pose2 step = Pose2::exp({0.5 * seconds, 0.0, 0.2 * seconds});
    truth_ = truth_ * step;
    Motion motion;
    motion.start = at(time_);
    motion.end = at(time_ += seconds);
    motion.increment = Pose2::exp({sign * 0.5 * seconds, 0.0, sign * 0.2 * seconds});
    motion.covariance = (Eigen::Vector3d(1e-4, 1e-4, 1e-3) * seconds).asDiagonal();
    inputs_.input("motion", kindOf<Motion>())->set(&motion);
    return motion;
  }
  CameraView seen(double turned = 0.0) { return room_.look(truth_, at(time_), turned); }
  Status take(const CameraView& view) {
    inputs_.input("camera", kindOf<CameraView>())->set(&view);
    const auto status = filter_.execute();
    expectSound();
    return status;
  }
  Status step() {
    move();
    return take(seen());
  }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) step();
  }
  void expectSound() const {
    const auto& P = filter_.state().covariance();
    ASSERT_TRUE(filter_.state().mean().allFinite() && P.allFinite());
    ASSERT_LT((P - P.transpose()).norm(), 1e-9 * P.norm());
    const auto I = Eigen::MatrixXd::Identity(P.rows(), P.cols());
    ASSERT_EQ(Eigen::LLT<Eigen::MatrixXd>(P + 1e-9 * I).info(), Eigen::Success);
  }
  double error() const { return (filter_.pose().pose.position() - truth_.position()).norm(); }
  std::optional<Stamp> lostSince() { return as<LostReporter>(filter_).lostSince(); }
  double figure(const std::string& name) const {
    for (const auto& [other, value] : filter_.figures())
      if (other == name) return value;
    return -1.0;
  }

  static constexpr double kHalf = 4.0;  ///< of the room [m]

  test::TexturedRoom room_;
  MonoEkf filter_;
  Ports inputs_;
  Pose2 truth_;
  double time_ = 0.0;
};

TEST_F(MonoEkfInARoom, MapsCornersAndKnowsTheirDepth) {
  drive(60);
  EXPECT_LT(error(), 0.1);
  EXPECT_GT(figure("features"), 20.0);
  EXPECT_GT(figure("features_with_depth"), 3.0);
  EXPECT_GT(figure("features_in_view"), 15.0);
  const auto features = as<FeatureMapper>(filter_).features();
  EXPECT_EQ(static_cast<double>(features.size()), figure("features_with_depth"));
  for (const auto& [id, position, covariance] : features) {
    const double off_wall = kHalf - position.head<2>().cwiseAbs().maxCoeff();
    EXPECT_LT(std::abs(off_wall), 1.0) << "it is on a wall";
    EXPECT_GT(covariance.diagonal().minCoeff(), 0.0);
  }
  EXPECT_GT(filter_.counters()["matched"], 10 * filter_.counters()["rejected"]);
}

TEST_F(MonoEkfInARoom, CorrectsOdometryThatTurnsTooFar) {
  for (int i = 0; i < 30; ++i) {
    move();
    Motion slip;
    slip.increment = Pose2(0.0, 0.0, 0.006);
    slip.covariance = Eigen::Vector3d(1e-9, 1e-9, 4e-5).asDiagonal();
    inputs_.input("motion", kindOf<Motion>())->set(&slip);
    take(seen());
  }
  EXPECT_LT(std::abs(filter_.pose().pose.theta() - truth_.theta()), 0.02) << "of 0.18 rad";
}

TEST_F(MonoEkfInARoom, SaysThatOdometryIsReversedAndThatNothingCorrectsIt) {
  constexpr int kImages = 60, kFirst = 20;  // until features have told
  for (int i = 0; i < kImages; ++i) {
    move(0.1, -1.0);
    const auto said = take(seen()).message;
    if (i < kFirst) continue;
    EXPECT_NE(said.find("as if it were behind the camera"), std::string::npos) << "image " << i;
    EXPECT_EQ(as<CorrectionReporter>(filter_).correctedBy(), std::nullopt) << "image " << i;
  }
  EXPECT_GE(filter_.counters()["behind"], static_cast<std::uint64_t>(kImages - kFirst));
}

TEST_F(MonoEkfInARoom, IsCorrectedByWhatItHasSeenBefore) {
  drive(60);
  EXPECT_EQ(filter_.counters()["behind"], 0U);
  ASSERT_NE(as<CorrectionReporter>(filter_).correctedBy(), std::nullopt);
  EXPECT_LT(*as<CorrectionReporter>(filter_).correctedBy(), at(time_));
}

TEST_F(MonoEkfInARoom, ShowsWhatItDoes) {
  EXPECT_TRUE(as<ViewDrawer>(filter_).drawing().empty()) << "no image yet";
  drive(6);
  const auto drawing = as<ViewDrawer>(filter_).drawing();
  ASSERT_EQ(drawing.type(), CV_8UC3);
  EXPECT_EQ(drawing.size(), cv::Size(320, 240));
}

TEST_F(MonoEkfInARoom, GoesOnByOdometryInADarkRoomBeforeABlankWallAndBehindACap) {
  drive(10);
  const auto features = figure("features");
  const double sigma = filter_.pose().covariance(0, 0);
  for (const double gray : {0.0, 4.0, 190.0}) {
    for (int i = 0; i < 3; ++i) {
      move();
      auto view = seen();
      view.image.gray = cv::Mat(240, 320, CV_8U, cv::Scalar(0));  // a cap may hide all noise
      if (gray > 0.0)
        cv::RNG(static_cast<std::uint64_t>(time_ * 100))
            .fill(view.image.gray, cv::RNG::NORMAL, gray, 2.0);
      const auto status = take(view);
      EXPECT_NE(status.message.find("dark room"), std::string::npos) << status.message;
    }
  }
  EXPECT_EQ(filter_.counters()["blank"], 9U);
  EXPECT_LT(error(), 0.05);
  EXPECT_GT(filter_.pose().covariance(0, 0), sigma);
  EXPECT_GT(figure("features"), 0.5 * features) << "what is not seen in the dark is not gone";
  EXPECT_FALSE(lostSince());
  drive(3);
  EXPECT_GT(figure("features_in_view"), 8.0) << "it finds the features again";
}

TEST_F(MonoEkfInARoom, TakesAnotherResolutionInTheMiddle) {
  drive(12);
  room_.setSize({480, 360});
  drive(4);
  EXPECT_GT(figure("features_in_view"), 8.0);
  EXPECT_LT(error(), 0.06);
  EXPECT_FALSE(lostSince());
}

TEST_F(MonoEkfInARoom, WorksWithTwoImagesASecond) {
  for (int i = 0; i < 8; ++i) {
    move(0.5);
    take(seen());
  }
  EXPECT_GT(figure("features_in_view"), 5.0);
  EXPECT_LT(error(), 0.15);
}

TEST_F(MonoEkfInARoom, FindsItsFeaturesAfterAGapOfTenSeconds) {
  drive(20);
  Motion motion;  // it waits; odometry only becomes less certain
  motion.covariance = Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal();
  inputs_.input("motion", kindOf<Motion>())->set(&motion);
  time_ += 10.0;
  take(seen());
  EXPECT_GT(figure("features_in_view"), 10.0);
  EXPECT_FALSE(lostSince());
}

TEST_F(MonoEkfInARoom, FindsItsFeaturesAfterAGapOfTenSecondsOfDriving) {
  drive(60);
  for (int i = 0; i < 100; ++i) move();
  for (int i = 0; i < 10; ++i) step();
  EXPECT_GT(figure("features_in_view"), 8.0);
  EXPECT_LT(error(), 0.15);
  EXPECT_FALSE(lostSince());
}

TEST_F(MonoEkfInARoom, GoesOnByOdometryWhereTheSameImageComesAgain) {
  drive(30);
  const auto before = filter_.state().features().size();
  auto stuck = seen();
  stuck.is_repeated = true;  // as the camera's gate says
  for (int i = 0; i < 10; ++i) {
    move();
    stuck.stamp = at(time_);
    EXPECT_TRUE(take(stuck).isOk()) << "the gate has said why";
  }
  EXPECT_EQ(filter_.counters()["unusable"], 10U);
  EXPECT_EQ(filter_.state().features().size(), before);
  drive(10);
  EXPECT_LT(error(), 0.1);
  EXPECT_FALSE(lostSince());
}

TEST_F(MonoEkfInARoom, CountsWhatBecameOfTheFeaturesOfAnImage) {
  EXPECT_FALSE(as<ViewReporter>(filter_).viewStatistics()) << "no image yet";
  drive(30);
  auto before = filter_.counters();
  step();
  auto after = filter_.counters();
  const auto counted = [&](const char* name) { return after[name] - before[name]; };
  const auto view = as<ViewReporter>(filter_).viewStatistics();
  ASSERT_TRUE(view);
  EXPECT_GT(view->matched, 10U);
  EXPECT_EQ(view->matched, counted("matched"));
  EXPECT_EQ(view->rejected, counted("rejected"));
  EXPECT_EQ(view->expected, view->matched + view->rejected + counted("not_found"));
  EXPECT_EQ(view->features, view->matched + view->rejected + counted("added"));
  move();
  filter_.execute();
  EXPECT_FALSE(as<ViewReporter>(filter_).viewStatistics()) << "no image came";
  step();
  move();
  auto unusable = seen();
  unusable.camera = nullptr;
  take(unusable);
  EXPECT_FALSE(as<ViewReporter>(filter_).viewStatistics()) << "not of an earlier image";
}

TEST_F(MonoEkfInARoom, MovesTimeOnWithoutACalibration) {
  drive(3);
  move();
  CameraView view;
  view.stamp = at(time_);
  const auto status = take(view);
  EXPECT_TRUE(status.isOk()) << "the gate of the camera has said why: " << status.message;
  EXPECT_EQ(filter_.counters()["unusable"], 1U);
  EXPECT_LT(error(), 0.05);
}

TEST_F(MonoEkfInARoom, IsLostWhenItsCameraIsTurnedByHand) {
  drive(40);
  EXPECT_FALSE(lostSince());
  Status status;
  for (int i = 0; i < 16 && !lostSince(); ++i) {
    move();
    status = take(seen(0.35));
  }
  EXPECT_TRUE(lostSince().has_value());
  EXPECT_NE(status.message.find("the robot is lost"), std::string::npos) << status.message;
  EXPECT_GT(std::sqrt(filter_.pose().covariance(2, 2)), 0.3);
  filter_.set(PoseEstimate{Pose2(1.0, 2.0, 0.3), 1e-4 * Eigen::Matrix3d::Identity()});
  filter_.execute();
  EXPECT_FALSE(lostSince()) << "it was told where it is";
  EXPECT_EQ(filter_.pose().pose.vector(), Eigen::Vector3d(1.0, 2.0, 0.3));
}

TEST_F(MonoEkfInARoom, FindsItselfWhereItHasBeenAfterItWasCarried) {
  drive(20);
  const Pose2 known = truth_;
  drive(40);
  const double features = figure("features_with_depth");
  truth_ = known * Pose2(0.1, 0.1, 0.05);  // odometry notices nothing
  int lost = -1, found = -1;
  for (int i = 0; i < 40; ++i) {
    step();
    if (lost < 0 && lostSince()) lost = i;
    if (lost >= 0 && found < 0 && !lostSince()) found = i;
    if (lostSince()) {
      EXPECT_GE(filter_.pose().covariance(0, 0), 1.0) << "it may be anywhere in the map";
      EXPECT_EQ(figure("features_with_depth"), features) << "a lost robot maps nothing";
    }
  }
  EXPECT_GE(lost, 0);
  EXPECT_LT(lost, 10) << "images";
  EXPECT_GE(found, 0);
  EXPECT_LT(error(), 0.1);
}

TEST_F(MonoEkfInARoom, GoesOnFromItsStateWithTheSameBits) {
  drive(10);
  ArchiveWriter writer;
  filter_.saveState(writer);
  const auto bytes = writer.take();
  MonoEkf second;
  second.configure(MonoEkfConfig());
  ArchiveReader reader(bytes);
  second.restoreState(reader);
  for (int i = 0; i < 5; ++i) {
    const auto motion = move();
    const auto view = seen();
    take(view);
    give(motion, second);
    give(view, second);
    second.execute();
    ASSERT_EQ(filter_.pose().pose.vector(), second.pose().pose.vector()) << i;
    ASSERT_EQ(filter_.pose().covariance, second.pose().covariance) << i;
  }
}

TEST_F(MonoEkfInARoom, KeepsNoMoreFeaturesThanItMay) {
  MonoEkfConfig config;
  config.features_in_view = 12;
  config.most_features = 14;
  filter_.configure(config);
  for (int i = 0; i < 40; ++i) {
    step();
    ASSERT_LE(figure("features"), 40.0);
  }
  EXPECT_LT(error(), 0.3);
}

TEST(MonoEkfConfiguration, IsRefusedWithASentence) {
  const auto messageOf = [](const std::vector<std::string>& changes) -> std::string {
    Settings settings({}, {}, changes);
    try {
      MonoEkf().configure(settings);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(messageOf({}), "");
  EXPECT_NE(messageOf({"mono_ekf.mode=localization"}).find("set mode to slam"), std::string::npos);
  EXPECT_NE(messageOf({"mono_ekf.most_features=10"}).find("features_in_view"), std::string::npos);
  EXPECT_NE(messageOf({"mono_ekf.nearest=5"}).find("typical_distance"), std::string::npos);
  EXPECT_NE(messageOf({"mono_ekf.pixel_sigma=0"}).find("pixel_sigma"), std::string::npos);
}

}  // namespace
}  // namespace slam::mono_ekf
