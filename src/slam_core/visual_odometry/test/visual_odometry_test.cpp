// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/visual_odometry.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <opencv2/core/utility.hpp>

#include "slam_core/camera/test/camera_feed.hpp"
#include "slam_core/camera/test/ceiling_picture.hpp"
#include "slam_core/common/test/faults.hpp"

namespace slam::visual_odometry {
namespace {

namespace ceilings = slam::test::ceilings;

using ceilings::Ceiling;
using ceilings::Exposure;

const Ceiling& ceiling() {
  static const Ceiling kCeiling;
  return kCeiling;
}

class VisualOdometryTest : public testing::TestWithParam<FeatureKind> {
 protected:
  VisualOdometryTest() { configure(); }

  void configure(const CameraMount& mount = ceilings::mountUp()) {
    config_.features = GetParam();
    config_.ceiling_height = 1.7;
    odometry_.configure(config_);
    mount_ = mount;
    camera_.gate.set(ceilings::smallCamera());
    camera_.gate.set(mount);
  }

  Status show(const cv::Mat& gray) {
    stamp_ += std::chrono::milliseconds(100);
    const auto status =
        camera_.show({stamp_, "ceiling_camera", gray, ""}, [&](const CameraView& view) {
          odometry_.set(view);
          return odometry_.execute();
        });
    if (odometry_.motion()) pose_ = odometry_.motion()->odometry_end;
    return status;
  }
  cv::Mat picture(const Pose2& pose, const Exposure& exposure = {}) {
    const auto light = ceiling().seenBy(mount_, pose);
    return ceilings::exposed(light, exposure, ++pictures_);
  }
  Status look(const Pose2& pose, const Exposure& exposure = {}) {
    return show(picture(pose, exposure));
  }
  const Motion& motion() const { return *odometry_.motion(); }
  std::uint64_t count(const std::string& reason) const { return odometry_.counters()[reason]; }

  void expectNear(const Pose2& pose, const Pose2& truth, double way, double angle) const {
    const Pose2 error = truth.between(pose);
    EXPECT_LT(error.position().norm(), way);
    EXPECT_LT(std::abs(error.theta()), angle);
  }

  VisualOdometryConfig config_;
  slam::test::CameraFeed camera_;
  VisualOdometry odometry_;
  CameraMount mount_;
  Stamp stamp_{};
  std::uint64_t pictures_ = 0;
  Pose2 pose_;
};

/// What is shown for each kind of features; the rest for the two that are fast.
class FeaturesTest : public VisualOdometryTest {};

TEST_P(FeaturesTest, FollowsWaysAndTurns) {
  const Pose2 step(0.08, 0.03, 0.1);
  Pose2 truth(0.3, -0.2, 0.5);
  const Pose2 start = truth;
  EXPECT_TRUE(look(truth).isOk());
  EXPECT_FALSE(odometry_.motion()) << "one image tells no motion";
  for (int i = 0; i < 15; ++i) {
    truth = truth * step;
    EXPECT_TRUE(look(truth).isOk()) << i;
    ASSERT_TRUE(odometry_.motion());
    expectNear(motion().increment, step, 0.006, 0.006);
    EXPECT_EQ(faultOf(motion()), "");
    EXPECT_EQ(motion().sequence, static_cast<std::uint64_t>(i));
  }
  expectNear(pose_, start.between(truth), 0.013, 0.015);
  EXPECT_GT(count("keyframes"), 1u) << "the first keyframe is out of sight";
}

TEST_P(VisualOdometryTest, TakesACameraThatIsOffCentreTurnedAndTilted) {
  configure(ceilings::mountUp(-0.3, 2.0, 0.15));
  const Pose2 step(0.05, 0.0, 0.12);
  Pose2 truth;
  look(truth);
  for (int i = 0; i < 8; ++i) look(truth = truth * step);
  expectNear(pose_, truth, 0.01, 0.01);
}

TEST_P(VisualOdometryTest, DoesNotDriftWhileTheRobotStands) {
  for (int i = 0; i < 60; ++i) EXPECT_TRUE(look(Pose2()).isOk());
  expectNear(pose_, Pose2(), 0.001, 0.001);
  EXPECT_EQ(count("keyframes"), 1u);
}

TEST_P(VisualOdometryTest, TakesTheSameImageTwiceForStanding) {
  const auto image = picture(Pose2());
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(show(image).isOk());
  expectNear(motion().increment, Pose2(), 1e-6, 1e-6);
  EXPECT_EQ(faultOf(motion()), "");
}

TEST_P(VisualOdometryTest, StandsBlurAndOtherLight) {
  const Pose2 step(0.06, 0.0, 0.05);
  for (const Exposure& exposure : {Exposure{1.0, 1.2, 2.0}, Exposure{0.4, 0.0, 2.0}}) {
    configure();
    look(Pose2());
    EXPECT_TRUE(look(step, exposure).isOk()) << exposure.brightness;
    expectNear(motion().increment, step, 0.01, 0.01);
  }
}

TEST_P(VisualOdometryTest, CoastsWhileLampsAreOffAndComesBackWhereItIs) {
  const Pose2 step(0.05, 0.0, 0.0);
  Pose2 truth;
  look(truth);
  for (int i = 0; i < 3; ++i) look(truth = truth * step);
  const Exposure dark{0.0, 0.0, 1.0};
  for (int i = 1; i <= 4; ++i) {
    const auto status = look(truth, dark);  // it has stopped
    EXPECT_NE(status.message.find("the last velocity is used meanwhile"), std::string::npos)
        << status.message;
    expectNear(motion().increment, step, 0.003, 0.003);
    EXPECT_EQ(faultOf(motion()), "");
    const double sigma = std::sqrt(motion().covariance(0, 0));
    EXPECT_NEAR(sigma, 0.1 * config_.max_speed * std::sqrt(2.0 * i - 1.0), 1e-9);
  }
  EXPECT_TRUE(odometry_.isLost());
  EXPECT_TRUE(look(truth).isOk());
  EXPECT_FALSE(odometry_.isLost());
  expectNear(pose_, truth, 0.004, 0.004);
  EXPECT_GT(motion().covariance(0, 0), 0.01) << "what the gap has cost is undone with its doubt";
  look(truth);
  EXPECT_LT(motion().covariance(0, 0), 1e-4);
}

TEST_P(VisualOdometryTest, SaysWhatIsMissingWhereItStartsInTheDark) {
  const cv::Mat bare(240, 320, CV_8UC1, cv::Scalar(90));
  for (std::uint64_t i = 1; i <= 3; ++i) {
    const auto status = show(bare);
    EXPECT_NE(status.message.find("the ceiling shows only 0 features"), std::string::npos)
        << status.message;
    EXPECT_EQ(count("few_features"), i);
  }
  EXPECT_EQ(count("keyframes"), 0u);
  EXPECT_TRUE(odometry_.isLost());
  EXPECT_TRUE(look(Pose2()).isOk());
  EXPECT_TRUE(look(Pose2(0.03, 0.0, 0.0)).isOk());
  expectNear(motion().increment, Pose2(0.03, 0.0, 0.0), 0.004, 0.004);
  EXPECT_EQ(count("few_features"), 3u);
}

TEST_P(VisualOdometryTest, TellsHowManyFeaturesThereAre) {
  const auto features = [&] {
    for (const auto& [name, value] : odometry_.figures())
      if (name == "features") return value;
    return -1.0;
  };
  for (int i = 0; i < 3; ++i) {
    look(Pose2(0.02 * i, 0.0, 0.0));
    EXPECT_GE(features(), config_.min_inliers) << i;
    EXPECT_LE(features(), config_.max_features) << i;
  }
}

TEST_P(VisualOdometryTest, GoesOnWithWhatItSeesWhenTheKeyframeIsGone) {
  Pose2 truth;
  look(truth);
  truth = truth * Pose2(1.8, 0.0, 1.0);  // carried away
  for (int i = 0; i < 13; ++i) look(truth);
  const Pose2 before = pose_;
  const Pose2 step(0.05, 0.0, 0.1);
  EXPECT_TRUE(look(truth * step).isOk());
  expectNear(before.between(pose_), step, 0.004, 0.004);
}

TEST_P(VisualOdometryTest, IsNotMovedByAHandOrAHeadThatPasses) {
  look(Pose2());
  for (int i = 0; i < 12; ++i) {
    auto image = picture(Pose2());
    cv::circle(image, {30 * i, 120}, 70, 40.0, cv::FILLED);
    cv::circle(image, {30 * i - 20, 110}, 12, 90.0, cv::FILLED);
    cv::circle(image, {30 * i + 15, 130}, 9, 10.0, cv::FILLED);
    show(image);
    expectNear(pose_, Pose2(), 0.003, 0.003);
  }
  const cv::Mat hand(240, 320, CV_8UC1, cv::Scalar(25));
  EXPECT_FALSE(show(hand).isOk());
  EXPECT_TRUE(look(Pose2()).isOk());
  expectNear(pose_, Pose2(), 0.003, 0.003);
}

TEST_P(VisualOdometryTest, RefusesImagesOfAnotherSize) {
  look(Pose2());
  EXPECT_FALSE(show(cv::Mat::zeros(480, 640, CV_8UC1)).isOk());
  ASSERT_TRUE(odometry_.motion()) << "time goes on";
  EXPECT_EQ(faultOf(motion()), "");
  EXPECT_TRUE(look(Pose2()).isOk());
}

TEST_P(VisualOdometryTest, SaysWhenAnotherSurfaceIsSeen) {
  look(Pose2());
  const Ceiling lower(2.3);
  const auto light = lower.seenBy(mount_, Pose2());
  const auto status = show(ceilings::exposed(light, {}, 99));
  EXPECT_NE(status.message.find("another surface is seen"), std::string::npos) << status.message;
  EXPECT_EQ(count("scale"), 1u);
}

TEST_P(VisualOdometryTest, WarnsOfACameraThatDoesNotLookUp) {
  configure(ceilings::mountUp(0.0, 0.0, 0.5));
  EXPECT_NE(look(Pose2()).message.find("tilted by 29 deg"), std::string::npos);
  configure(ceilings::mountUp(0.0, 0.0, 1.5));
  look(Pose2());
  EXPECT_NE(look(Pose2()).message.find("tilted by 86 deg"), std::string::npos);
  EXPECT_EQ(count("camera_direction"), 2u);
}

TEST_P(FeaturesTest, GivesTheSameTwiceAfterAResetAndForAnyNumberOfThreads) {
  std::vector<cv::Mat> images;
  for (int i = 0; i < 4; ++i) images.push_back(picture(Pose2(0.06 * i, 0.0, 0.08 * i)));
  const int threads = cv::getNumThreads();
  std::vector<Motion> motions;
  for (const int number : {1, 4}) {
    cv::setNumThreads(number);
    odometry_.reset();
    camera_.gate.reset();
    for (const auto& image : images) show(image);
    motions.push_back(motion());
  }
  cv::setNumThreads(threads);
  EXPECT_EQ(motions[0].increment.vector(), motions[1].increment.vector());
  EXPECT_EQ(motions[0].covariance, motions[1].covariance);
  EXPECT_EQ(motions[1].sequence, 2u);
}

TEST_P(VisualOdometryTest, BeginsAnewWhenTimeGoesBack) {
  stamp_ = Stamp(std::chrono::seconds(100));
  look(Pose2());
  look(Pose2(0.05, 0.0, 0.0));
  stamp_ = Stamp{};
  look(Pose2());
  EXPECT_FALSE(odometry_.motion());
  look(Pose2(0.05, 0.0, 0.0));
  expectNear(motion().increment, Pose2(0.05, 0.0, 0.0), 0.004, 0.004);
}

/// Over many pairs of noisy images at other places: what the covariance says of single steps is
/// neither too small nor far too large.
TEST_P(FeaturesTest, CovarianceCoversTheErrors) {
  config_.alpha_translation = config_.alpha_rotation = 0.0;
  config_.floor_position = config_.floor_heading = 1e-6;
  const Pose2 step(0.05, 0.02, 0.06);
  double sum = 0.0;
  constexpr int kPlaces = 8, kSteps = 3;
  for (int place = 0; place < kPlaces; ++place) {
    configure();
    Pose2 truth(0.15 * place - 0.9, 0.1 * place - 0.5, 0.5 * place);
    look(truth);
    for (int i = 0; i < kSteps; ++i) {
      look(truth = truth * step);
      const Eigen::Vector3d error = motion().increment.vector() - step.vector();
      sum += error.dot(motion().covariance.inverse() * error) / 3.0;
    }
  }
  const double normalised = sum / (kPlaces * kSteps);
  RecordProperty("normalised_error", std::to_string(normalised));
  EXPECT_GT(normalised, 0.1);
  EXPECT_LT(normalised, 2.0);
}

std::string nameOf(const testing::TestParamInfo<FeatureKind>& kind) {
  return slam::nameOf(kind.param, featureNames());
}
INSTANTIATE_TEST_SUITE_P(Fast, VisualOdometryTest,
                         testing::Values(FeatureKind::kOrb, FeatureKind::kKlt), nameOf);
INSTANTIATE_TEST_SUITE_P(All, FeaturesTest,
                         testing::Values(FeatureKind::kOrb, FeatureKind::kKlt, FeatureKind::kAkaze,
                                         FeatureKind::kSift),
                         nameOf);

std::string faultsOf(const VisualOdometryConfig& config) {
  VisualOdometry odometry;
  return slam::test::sentenceOf([&] { odometry.configure(config); });
}

TEST(VisualOdometryConfig, NeedsTheCeilingsHeight) {
  EXPECT_NE(faultsOf({}).find("ceiling_height is 0"), std::string::npos);
  for (const double height : {-1.7, std::nan("")}) {
    VisualOdometryConfig config;
    config.ceiling_height = height;
    EXPECT_NE(faultsOf(config).find("ceiling_height"), std::string::npos) << height;
  }
}

TEST(VisualOdometryConfig, NamesTheNearestFeatures) {
  Settings settings({}, {}, {"visual_odometry.features=akase"});
  const auto fault = slam::test::sentenceOf([&] { settings.read<VisualOdometryConfig>(); });
  EXPECT_NE(fault.find("did you mean 'akaze'?"), std::string::npos) << fault;
}

TEST(VisualOdometryConfig, NamesTheNearestWhereSurfIsMissing) {
  VisualOdometryConfig config;
  config.ceiling_height = 1.7;
  config.features = FeatureKind::kSurf;
  const auto faults = faultsOf(config);
  if (faults.empty()) GTEST_SKIP() << "this OpenCV has SURF";
  EXPECT_NE(faults.find("the nearest is sift"), std::string::npos) << faults;
}

}  // namespace
}  // namespace slam::visual_odometry
