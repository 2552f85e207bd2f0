// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/fiducial_detector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "slam_core/camera/test/camera_feed.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/fiducial/test/marker_picture.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::fiducial {
namespace {

using test::facing;
using test::MarkerPicture;
using test::printedMarker;

const CameraModel kVgaCamera(test::vgaCalibration());

/// Ahead, from 0.2 m before and 0.5 m above the robot's middle.
CameraMount mountAhead() {
  CameraMount mount;
  mount.camera_frame = "camera";
  mount.T_base_camera = Eigen::Translation3d(0.2, 0.0, 0.5) *
                        Eigen::AngleAxisd(-M_PI / 2, Eigen::Vector3d::UnitZ()) *
                        Eigen::AngleAxisd(-M_PI / 2, Eigen::Vector3d::UnitX());
  return mount;
}

class FiducialDetectorTest : public testing::TestWithParam<const char*> {
 protected:
  void configure(const std::vector<std::string>& overrides = {}) {
    detector_ = Registry<LandmarkDetector>::instance().create(GetParam());
    Settings settings({}, {}, overrides);
    detector_->configure(settings);
    settings.requireAllRead();
    inputs_.emplace(*detector_);
    camera_.gate.set(kVgaCamera.calibration());
    camera_.gate.set(mountAhead());
  }

  /// The image may be the one before it.
  Status look(const cv::Mat& image) {
    camera_.gate.reset();
    return lookAfterwards(image);
  }
  Status lookAfterwards(const cv::Mat& image) {
    stamp_ += std::chrono::milliseconds(100);
    return camera_.show({stamp_, "camera", image, ""}, [&](const CameraView& view) {
      inputs_->set(view);
      return detector_->execute();
    });
  }
  Status look(const MarkerPicture& picture) { return look(picture.exposed(2.0)); }

  const std::vector<LandmarkObservation>& observations() const {
    return detector_->observations()->observations;
  }
  std::uint64_t count(const std::string& reason) const { return detector_->counters()[reason]; }

  std::unique_ptr<LandmarkDetector> detector_;
  std::optional<slam::test::ComponentDriver> inputs_;
  slam::test::CameraFeed camera_;
  Stamp stamp_{};
};

TEST_P(FiducialDetectorTest, TellsRangeAndBearingOfMarkersSortedById) {
  configure();
  const std::map<int, Eigen::Vector3d> places = {
      {31, {0.5, -0.2, 2.0}}, {4, {-0.4, 0.1, 1.5}}, {7, {0.1, -0.1, 3.0}}};
  MarkerPicture picture(kVgaCamera);
  for (const auto& [id, place] : places) picture.add(printedMarker(id), facing(place, 0.4, id));
  EXPECT_TRUE(look(picture).isOk());
  ASSERT_TRUE(detector_->observations());
  const auto& array = *detector_->observations();
  EXPECT_EQ(array.stamp, stamp_);
  EXPECT_EQ(array.sensor_frame, "camera");
  EXPECT_TRUE(array.sensor_pose.vector().isApprox(Eigen::Vector3d(0.2, 0.0, 0.0)));
  ASSERT_EQ(array.observations.size(), places.size());
  auto expected = places.begin();
  for (const auto& z : array.observations) {
    EXPECT_EQ(z.id, expected->first);
    const auto& place = expected++->second;
    EXPECT_NEAR(z.range, std::hypot(place.x(), place.z()), 0.01 * place.z());
    EXPECT_NEAR(z.bearing, -std::atan2(place.x(), place.z()), 0.002);
    EXPECT_EQ(faultOf(z), "");
  }
  EXPECT_TRUE(detector_->counters().all().empty());
}

TEST_P(FiducialDetectorTest, GivesAnArrayForEveryImage) {
  configure();
  EXPECT_TRUE(detector_->execute().isOk());
  EXPECT_FALSE(detector_->observations()) << "no image was due";
  const MarkerPicture nothing(kVgaCamera);
  for (std::uint64_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(look(nothing).isOk());
    ASSERT_TRUE(detector_->observations());
    EXPECT_EQ(detector_->observations()->sequence, i);
    EXPECT_TRUE(observations().empty());
  }
  EXPECT_FALSE(look(cv::Mat::zeros(240, 320, CV_8UC1)).isOk()) << "another resolution";
  ASSERT_TRUE(detector_->observations());
  EXPECT_TRUE(observations().empty());
}

TEST_P(FiducialDetectorTest, ObservesNothingNewInAnImageThatTheCameraRepeats) {
  configure();
  MarkerPicture picture(kVgaCamera);
  picture.add(printedMarker(3), facing({0.0, 0.0, 1.5}));
  const auto image = picture.exposed(2.0);
  EXPECT_TRUE(look(image).isOk());
  EXPECT_EQ(observations().size(), 1U);
  lookAfterwards(image.clone());
  EXPECT_TRUE(observations().empty());
  EXPECT_FALSE(dynamic_cast<const ViewDrawer&>(*detector_).drawing().empty());
}

TEST_P(FiducialDetectorTest, UsesTheSizesOfMarkersById) {
  configure({"fiducial.marker_size=0.1", "fiducial.marker_sizes={12: 0.2}"});
  MarkerPicture picture(kVgaCamera);
  picture.add(printedMarker(3, 0.1), facing({-0.2, 0.0, 1.0}, 0.3));
  picture.add(printedMarker(12, 0.2), facing({0.2, 0.0, 1.0}, 0.3));
  look(picture);
  ASSERT_EQ(observations().size(), 2u);
  for (const auto& z : observations()) EXPECT_NEAR(z.range, std::hypot(0.2, 1.0), 0.01);
}

TEST_P(FiducialDetectorTest, GivesTheSameTwiceAndAfterAReset) {
  configure();
  MarkerPicture picture(kVgaCamera);
  for (int id = 0; id < 6; ++id)
    picture.add(printedMarker(id), facing({0.3 * id - 0.75, 0.0, 1.8}, 0.3, id));
  std::vector<LandmarkObservationArray> arrays;
  for (int run = 0; run < 3; ++run) {
    look(picture);
    arrays.push_back(*detector_->observations());
    if (run == 1) detector_->reset();
  }
  EXPECT_EQ(arrays[2].sequence, 0u);
  for (const auto& array : arrays) {
    ASSERT_EQ(array.observations.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_EQ(array.observations[i].vector(), arrays[0].observations[i].vector());
      EXPECT_EQ(array.observations[i].covariance, arrays[0].observations[i].covariance);
    }
  }
}

TEST_P(FiducialDetectorTest, RejectsAllMarkersOfAnIdThatIsThereTwice) {
  configure();
  MarkerPicture picture(kVgaCamera);
  picture.add(printedMarker(5), facing({-0.3, 0.0, 1.5}, 0.3));
  picture.add(printedMarker(6), facing({0.0, 0.0, 1.5}, 0.3));
  picture.add(printedMarker(5), facing({0.3, 0.0, 1.5}, 0.3));
  const auto status = look(picture);
  EXPECT_NE(status.message.find("marker 5 is in one image more than once"), std::string::npos)
      << status.message;
  ASSERT_EQ(observations().size(), 1u);
  EXPECT_EQ(observations()[0].id, 6);
  EXPECT_EQ(count("duplicate_id"), 2u);
}

TEST_P(FiducialDetectorTest, RejectsWhatIsNotListed) {
  configure({"fiducial.ids=[1, 2]"});
  MarkerPicture picture(kVgaCamera);
  picture.add(printedMarker(2), facing({-0.3, 0.0, 1.5}, 0.3));
  picture.add(printedMarker(3), facing({0.3, 0.0, 1.5}, 0.3));
  EXPECT_NE(look(picture).message.find("marker 3 is not listed"), std::string::npos);
  ASSERT_EQ(observations().size(), 1u);
  EXPECT_EQ(observations()[0].id, 2);
  EXPECT_EQ(count("unlisted_id"), 1u);
}

TEST_P(FiducialDetectorTest, RejectsByTheLimitsOfTheConfiguration) {
  MarkerPicture picture(kVgaCamera);
  picture.add(printedMarker(1), facing({0.0, 0.0, 1.5}, 0.8));
  const auto reasonWith = [&](const std::string& override) {
    configure({override});
    EXPECT_TRUE(look(picture).isOk());
    EXPECT_TRUE(observations().empty());
    const auto counts = detector_->counters().all();
    return counts.size() == 1 ? counts.begin()->first : "none or several";
  };
  EXPECT_EQ(reasonWith("fiducial.min_side=60"), "too_small");
  EXPECT_EQ(reasonWith("fiducial.max_obliqueness=0.7"), "too_oblique");
  EXPECT_EQ(reasonWith("fiducial.border=230"), "image_border");
  EXPECT_EQ(reasonWith("fiducial.max_reprojection_error=1e-4"), "reprojection_error");
  EXPECT_EQ(reasonWith("fiducial.max_relative_sigma=1e-4"), "ill_conditioned");
  configure({"fiducial.min_side=40", "fiducial.max_obliqueness=0.9", "fiducial.border=150"});
  look(picture);
  EXPECT_EQ(observations().size(), 1u);
}

TEST_P(FiducialDetectorTest, TakesNoMarkerForWholeThatTheBorderCuts) {
  configure();
  constexpr double kSide = 105.0, kRightmost = 639.0;  // [px]
  int whole = 0;
  for (double beyond = -0.12 * kSide; beyond < 0.13 * kSide; beyond += 0.01 * kSide) {
    const double middle = kRightmost + beyond - 0.5 * kSide;
    const Eigen::Vector2d on_plane = *kVgaCamera.unproject(Eigen::Vector2d(middle, 200.0));
    auto T = facing({0, 0, 1}, 0.15, 1.0);
    T.translation() = 0.8 * on_plane.homogeneous();
    MarkerPicture picture(kVgaCamera);
    picture.add(printedMarker(7), T);
    look(picture);
    if (beyond > 0.02 * kSide) {
      EXPECT_TRUE(observations().empty()) << beyond << " px are cut off";
    }
    whole += observations().empty() ? 0 : 1;
  }
  EXPECT_GT(whole, 1);
  EXPECT_GT(count("image_border"), 1u);
}

TEST_P(FiducialDetectorTest, RejectsMarkersRightAboveACameraThatLooksUp) {
  configure({"fiducial.corner_sigma=0.3"});
  CameraMount up;
  up.camera_frame = "camera";
  up.T_base_camera.translation().z() = 0.5;
  camera_.gate.set(up);
  MarkerPicture picture(kVgaCamera);
  picture.add(printedMarker(1), facing({0.002, 0.0, 1.8}, 0.3));
  picture.add(printedMarker(2), facing({0.6, 0.0, 1.8}, 0.3));
  EXPECT_EQ(look(picture).message, "");
  EXPECT_EQ(count("ill_conditioned"), 1u);
  ASSERT_EQ(observations().size(), 1u);
  EXPECT_EQ(observations()[0].id, 2);
  EXPECT_NEAR(observations()[0].range, 0.6, 0.01);
  EXPECT_NEAR(observations()[0].bearing, 0.0, 0.01);
}

/// A marker that is printed too large looks too near, not elsewhere in the image.
TEST_P(FiducialDetectorTest, TakesARangeToBeWrongByAShareOfIt) {
  MarkerPicture picture(kVgaCamera);
  picture.add(printedMarker(1), facing({0.3, 0.0, 1.8}, 0.3));
  std::vector<Eigen::Matrix2d> covariances;
  for (const auto* const share : {"0", "0.03"}) {
    configure({std::string("fiducial.sigma_range_relative=") + share});
    look(picture);
    ASSERT_EQ(observations().size(), 1u);
    covariances.push_back(observations()[0].covariance);
  }
  const double sigma = 0.03 * observations()[0].range;
  EXPECT_NEAR(covariances[1](0, 0) - covariances[0](0, 0), sigma * sigma, 1e-3 * sigma * sigma);
  EXPECT_NEAR(covariances[1](1, 1), covariances[0](1, 1), 1e-9);
}

TEST_P(FiducialDetectorTest, DrawsWhatItFound) {
  configure({"fiducial.ids=[1]"});
  EXPECT_TRUE(dynamic_cast<const ViewDrawer&>(*detector_).drawing().empty()) << "no image yet";
  MarkerPicture picture(kVgaCamera);
  picture.add(printedMarker(1), facing({-0.3, 0.0, 1.5}, 0.3));
  picture.add(printedMarker(2), facing({0.3, 0.0, 1.5}, 0.3));
  look(picture);
  const cv::Mat drawing = dynamic_cast<const ViewDrawer&>(*detector_).drawing();
  ASSERT_EQ(drawing.type(), CV_8UC3);
  ASSERT_EQ(drawing.size(), cv::Size(640, 480));
  const auto has = [](const cv::Mat& part, int channel) {
    for (int v = 0; v < part.rows; ++v)
      for (int u = 0; u < part.cols; ++u) {
        const auto& pixel = part.at<cv::Vec3b>(v, u);
        if (pixel[channel] > 180 && pixel[3 - channel] < 60) return true;
      }
    return false;
  };
  const auto left = drawing.colRange(0, 320), right = drawing.colRange(320, 640);
  EXPECT_TRUE(has(left, 1) && !has(left, 2)) << "green: accepted";
  EXPECT_TRUE(has(right, 2) && !has(right, 1)) << "red: rejected";
}

TEST_P(FiducialDetectorTest, RefusesConfigurationsThatCannotBe) {
  using slam::test::oneSays;
  const auto faultsWith = [&](const std::vector<std::string>& overrides) {
    return slam::test::faultsOf([&] { configure(overrides); });
  };
  EXPECT_TRUE(oneSays(faultsWith({"fiducial.marker_size=0"}), {"fiducial.marker_size", "> 0"}));
  EXPECT_TRUE(oneSays(faultsWith({"fiducial.marker_sizes={5: -0.1}"}),
                      {"fiducial.marker_sizes", "5", "> 0"}));
  EXPECT_TRUE(oneSays(faultsWith({"fiducial.sigma_range_relative=-0.01"}),
                      {"fiducial.sigma_range_relative", "-0.01"}));
  EXPECT_TRUE(oneSays(faultsWith({"fiducial.ids=[-3]"}), {"fiducial.ids", "-3"}));
  EXPECT_TRUE(oneSays(faultsWith({"fiducial.ids=[a]"}), {"fiducial.ids", "list of integers"}));
  const auto all = faultsWith({"fiducial.corner_sigma=0", "fiducial.marker_size=0"});
  EXPECT_EQ(all.size(), 2u) << "all faults at once";
}

INSTANTIATE_TEST_SUITE_P(Detectors, FiducialDetectorTest, testing::Values("apriltag", "aruco"),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace
}  // namespace slam::fiducial
