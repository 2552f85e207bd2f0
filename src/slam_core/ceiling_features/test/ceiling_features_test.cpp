// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ceiling_features/ceiling_features.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "slam_core/camera/test/camera_feed.hpp"
#include "slam_core/camera/test/ceiling_picture.hpp"
#include "slam_core/common/config_error.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::ceiling_features {
namespace {

namespace ceilings = slam::test::ceilings;
using Observations = std::vector<LandmarkObservation>;

const ceilings::Ceiling& ceiling() {
  static const ceilings::Ceiling kCeiling;
  return kCeiling;
}

/// Where an observation has its landmark, by the robot's true pose.
Eigen::Vector2d placeOf(const LandmarkObservation& z, const Pose2& T_world_base,
                        const Pose2& T_base_sensor) {
  const Eigen::Vector2d at = z.range * Eigen::Vector2d(std::cos(z.bearing), std::sin(z.bearing));
  return (T_world_base * T_base_sensor).transform(at);
}

struct Seen {
  Eigen::Vector2d place;
  LandmarkObservation observation;
};

class CeilingFeaturesTest : public testing::Test {
 protected:
  CeilingFeaturesTest() {
    config_.relative_sigma = 0.0;
    configure();
  }

  void configure(const CameraMount& mount = ceilings::mountUp()) {
    detector_.configure(config_, 1.7);
    mount_ = mount;
    camera_.gate.set(ceilings::smallCamera());
    camera_.gate.set(mount);
  }
  Status show(const cv::Mat& gray) {
    stamp_ += std::chrono::milliseconds(100);
    return camera_.show({stamp_, "ceiling_camera", gray, ""}, [&](const CameraView& view) {
      detector_.set(view);
      return detector_.execute();
    });
  }
  std::vector<Seen> look(const Pose2& pose, const ceilings::Exposure& exposure = {}) {
    show(ceilings::exposed(ceiling().seenBy(mount_, pose), exposure, ++pictures_));
    std::vector<Seen> all;
    const auto& array = *detector_.observations();
    for (const auto& z : array.observations)
      all.push_back({placeOf(z, pose, array.sensor_pose), z});
    return all;
  }
  const Observations& observations() const { return detector_.observations()->observations; }
  std::uint64_t count(const std::string& reason) const { return detector_.counters()[reason]; }

  CeilingFeaturesConfig config_;
  slam::test::CameraFeed camera_;
  CeilingFeatures detector_;
  CameraMount mount_;
  Stamp stamp_{};
  std::uint64_t pictures_ = 0;
};

/// The pairs of an observation before and one now that are of the same place.
std::vector<std::pair<Seen, Seen>> sameOnes(const std::vector<Seen>& before,
                                            const std::vector<Seen>& now) {
  std::vector<std::pair<Seen, Seen>> pairs;
  for (const auto& b : now)
    for (const auto& a : before)
      if ((a.place - b.place).norm() < 0.05) pairs.emplace_back(a, b);
  return pairs;
}

double descriptorDistance(const Descriptor& a, const Descriptor& b) {
  const auto variance = a.sigmas.array().square() + b.sigmas.array().square();
  return ((a.values - b.values).array().square() / variance).sum();
}

TEST_F(CeilingFeaturesTest, FindsTheSameSpotsFromEverywhereTheyAreInSight) {
  const Pose2 here(0.2, -0.1, 0.4);
  const auto before = look(here);
  ASSERT_GE(before.size(), 4u);
  std::size_t seen = 0, found = 0;
  for (const auto& there :
       {Pose2(0.25, -0.05, 0.4), Pose2(0.2, -0.1, 1.7), Pose2(0.1, 0.05, -2.4)}) {
    const auto now = look(there);
    found += sameOnes(before, now).size();
    seen += now.size();
  }
  EXPECT_GT(static_cast<double>(found), 0.5 * static_cast<double>(seen))
      << "the rest was out of sight before";
}

TEST_F(CeilingFeaturesTest, PlacesSpotsAsExactlyAsItSays) {
  double squares = 0.0;
  int count = 0;
  const auto before = look(Pose2(), {1.0, 0.0, 0.0});
  for (int i = 0; i < 30; ++i) {
    const Pose2 pose(0.01 * i, 0.02 * (i % 7), 0.2 * i);
    for (const auto& [a, b] : sameOnes(before, look(pose))) {
      squares += (b.place - a.place).squaredNorm();
      ++count;
    }
  }
  ASSERT_GT(count, 60);
  const double metres_per_pixel = 1.7 / 280.0;
  const double sigma = std::sqrt(squares / count / 2.0 / 2.0) / metres_per_pixel;
  EXPECT_LT(sigma, config_.pixel_sigma) << "two places, two directions [px]";
  EXPECT_GT(sigma, 0.05 * config_.pixel_sigma);
}

TEST_F(CeilingFeaturesTest, DescribesASpotTheSameFromEverywhereAndInAnyLight) {
  const auto before = look(Pose2());
  double same = 0.0, other = 0.0;
  int sames = 0, others = 0;
  for (const double brightness : {0.5, 1.0, 1.3}) {
    const auto now = look(Pose2(0.1, 0.05, 2.0), {brightness, 0.0, 2.0});
    for (const auto& [a, b] : sameOnes(before, now)) {
      same += descriptorDistance(a.observation.descriptor, b.observation.descriptor);
      ++sames;
    }
    for (const auto& a : before)
      for (const auto& b : now) {
        if ((a.place - b.place).norm() < 0.05) continue;
        other += descriptorDistance(a.observation.descriptor, b.observation.descriptor);
        ++others;
      }
  }
  ASSERT_GT(sames, 5);
  EXPECT_LT(same / sames, 2.0 * Descriptor::kMostElements);
  EXPECT_GT(other / others, 5.0 * same / sames);
}

TEST_F(CeilingFeaturesTest, TakesACameraThatIsOffCentreTurnedAndTilted) {
  const auto before = look(Pose2());
  configure(ceilings::mountUp(-0.2, 2.0, 0.15));
  const auto now = look(Pose2(0.15, 0.0, 0.3));
  EXPECT_NEAR(detector_.observations()->sensor_pose.x(), -0.2, 1e-12);
  const auto pairs = sameOnes(before, now);
  ASSERT_GE(pairs.size(), 2u);
  for (const auto& [a, b] : pairs) EXPECT_LT((a.place - b.place).norm(), 0.012);
}

TEST_F(CeilingFeaturesTest, LeavesOutWhatCannotBeChosenAgain) {
  look(Pose2());
  EXPECT_GT(count("not_distinct"), 0u);
  EXPECT_GT(count("cut_off"), 0u);
  config_.min_range = 5.0;
  configure();
  EXPECT_TRUE(look(Pose2()).empty());
  EXPECT_GT(count("too_near"), 0u);
  config_ = {};
  config_.max_features = 1;
  configure();
  EXPECT_EQ(look(Pose2()).size(), 1u);
  EXPECT_GT(count("too_many"), 0u);
}

TEST_F(CeilingFeaturesTest, TellsNoIdsAndValidObservations) {
  for (const auto& seen : look(Pose2(1.0, 0.5, -0.7))) {
    EXPECT_EQ(seen.observation.id, kUnknownId);
    EXPECT_EQ(faultOf(seen.observation), "");
    EXPECT_EQ(faultOf(seen.observation.descriptor), "");
    EXPECT_EQ(seen.observation.descriptor.size(), Descriptor::kMostElements);
  }
}

TEST_F(CeilingFeaturesTest, ImagesThatShowNothingMoveTimeOn) {
  const cv::Mat black(240, 320, CV_8U, cv::Scalar(0)), white(240, 320, CV_8U, cv::Scalar(255));
  for (const auto& image : {black, white}) {
    EXPECT_EQ(show(image).message, "the ceiling shows no spots: it is dark, blurred or bare");
    EXPECT_TRUE(observations().empty());
  }
  EXPECT_EQ(detector_.observations()->sequence, 1u);
  show(cv::Mat());
  EXPECT_TRUE(observations().empty());
  EXPECT_EQ(detector_.observations()->sequence, 2u);
  detector_.execute();
  EXPECT_FALSE(detector_.isBusy()) << "no image, no array";
}

TEST_F(CeilingFeaturesTest, ATinyImageIsNotAFault) {
  auto calibration = ceilings::smallCamera();
  calibration.width = calibration.height = 2;
  camera_.gate.set(calibration);
  show(cv::Mat(2, 2, CV_8U, cv::Scalar(9)));
  EXPECT_TRUE(observations().empty());
}

TEST_F(CeilingFeaturesTest, SpotsNearlyAsLargeAsTheImageAreNotAFault) {
  config_.size = 0.19;
  configure();
  look(Pose2());
  EXPECT_LE(observations().size(), 1u);
}

TEST_F(CeilingFeaturesTest, SaysThatTheCameraDoesNotLookUp) {
  configure(ceilings::mountUp(0.0, 0.0, 0.5));
  EXPECT_NE(show(cv::Mat(240, 320, CV_8U, cv::Scalar(9))).message.find("tilted by 29 deg"),
            std::string::npos);
  configure(ceilings::mountUp(0.0, 0.0, 1.5));
  look(Pose2());
  EXPECT_TRUE(observations().empty());
}

TEST_F(CeilingFeaturesTest, DrawsWhatItFound) {
  EXPECT_TRUE(detector_.drawing().empty());
  look(Pose2());
  EXPECT_EQ(detector_.drawing().size(), cv::Size(320, 240));
  EXPECT_EQ(detector_.drawing().type(), CV_8UC3);
}

TEST_F(CeilingFeaturesTest, SaysThatTheCalibrationIsImplausibleWhereASpotWouldFillTheImage) {
  for (const double focal_length : {1e5, 3e5}) {  // beyond these no calibration is used
    auto calibration = ceilings::smallCamera();
    calibration.fx = calibration.fy = focal_length;
    camera_ = slam::test::CameraFeed();  // it refuses a focal length that changes
    camera_.gate.set(calibration);
    camera_.gate.set(mount_);
    const auto said = show(ceilings::exposed(ceiling().seenBy(mount_, Pose2()), {}, 1)).message;
    EXPECT_NE(said.find("a spot of the ceiling would fill the image"), said.npos) << said;
    EXPECT_TRUE(observations().empty());
  }
}

TEST(CeilingFeaturesConfiguration, NeedsTheCeilingsHeight) {
  const auto fault = [](const std::vector<std::string>& overrides) {
    const auto detector = Registry<LandmarkDetector>::instance().create("ceiling_features");
    Settings settings({}, {}, overrides);
    return slam::test::sentenceOf([&] { detector->configure(settings); });
  };
  EXPECT_NE(fault({}).find("ceiling_camera.ceiling_height is 0"), std::string::npos);
  EXPECT_EQ(fault({"ceiling_camera.ceiling_height=2"}), "");
  EXPECT_NE(
      fault({"ceiling_camera.ceiling_height=2", "ceiling_features.spacing=0"}).find("spacing"),
      std::string::npos);
}

}  // namespace
}  // namespace slam::ceiling_features
