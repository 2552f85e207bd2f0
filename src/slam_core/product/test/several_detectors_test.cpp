// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/product/test/product_run.hpp"
#include "slam_core/product/test/spot_detector.hpp"

namespace slam {
namespace {

using test::faultsOfWords;
using test::oneSays;

/// The brightest spot of an image is a beacon 2 m away, whose number is its gray value. Detectors
/// of two families take the same spots for beacons of their own.
template <char family>
class BeaconDetector final : public test::SpotDetector {
 public:
  void startIdsAt(LandmarkId first) override { first_ = first; }
  std::vector<IdRange> ids() const override {
    return {{std::string("beacons_") + family, first_, 256}};
  }

 private:
  LandmarkId idOf(double brightness) const override {
    return first_ + static_cast<LandmarkId>(brightness);
  }
  Pose2 sensorPose(const CameraView& view) const override {
    const auto& R = view.mount.T_base_camera.linear();
    return {0, 0, std::atan2(R(1, 0), R(0, 0))};
  }

  LandmarkId first_ = 0;
};

const Registrar<LandmarkDetector, BeaconDetector<'a'>> kBeaconsA("beacons_a");
const Registrar<LandmarkDetector, BeaconDetector<'b'>> kBeaconsB("beacons_b");

const std::vector<std::string> kFour = {"detector=beacons_a", "second_detector=beacons_b",
                                        "second_camera=true"};

Stamp when(int milliseconds) {
  return stampFromNanoseconds(1000000000) + std::chrono::milliseconds(milliseconds);
}

Image beacon(const std::string& camera, int number, int milliseconds) {
  Image image{when(milliseconds), camera, cv::Mat::zeros(24, 32, CV_8UC1), ""};
  image.gray.at<std::uint8_t>(12, 16) = static_cast<std::uint8_t>(number);
  image.gray.at<std::uint8_t>(0, 0) = static_cast<std::uint8_t>(milliseconds / 10 % 3);  // noise
  return image;
}

class SeveralDetectors : public testing::Test, protected test::ProductRun {
 protected:
  explicit SeveralDetectors(const std::vector<std::string>& overrides = kFour) {
    configure(overrides);
  }
  /// Odometry up to a time [ms].
  void drive(int until) {
    for (; driven_ <= until; driven_ += 100) {
      OdometrySample sample;
      sample.stamp = when(driven_);
      sample.pose = Pose2(1e-4 * driven_, 0, 0);
      coordinator.set(sample);
      drain();
    }
  }
  void know(const std::string& camera, double yaw) {
    coordinator.put(camera, CameraCalibration{32, 24, "plumb_bob", 16, 16, 16, 12, {}});
    CameraMount mount{camera, Eigen::Isometry3d::Identity()};
    mount.T_base_camera.linear() =
        Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    coordinator.put(camera, mount);
  }
  void knowBoth() {
    know("camera", 0.0);
    know("rear_camera", M_PI);
  }
  /// The camera sees beacon 3, the rear one beacon 4.
  void look(const std::string& camera, int milliseconds) {
    coordinator.put(camera, beacon(camera, camera == "camera" ? 3 : 4, milliseconds));
    drain();
  }
  LandmarkMap map() const {
    return coordinator.estimator().capabilities().find<LandmarkMapper>()->landmarks();
  }
  std::vector<LandmarkId> ids() const {
    std::vector<LandmarkId> ids;
    for (const auto& landmark : map()) ids.push_back(landmark.id);
    return ids;
  }
  std::vector<std::string> triggers() const {
    std::vector<std::string> names;
    for (const auto& report : reports) names.push_back(report.trigger);
    return names;
  }

 private:
  int driven_ = 0;
};

TEST_F(SeveralDetectors, HaveInputsKeysAndTitlesOfTheirOwn) {
  std::vector<std::string> keys;
  for (const auto& part : inOrder(coordinator.components())) keys.push_back(part.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"odometry", "detector", "second_detector",
                                            "rear_detector", "rear_second_detector", "backend"}));
  std::vector<std::string> inputs;
  for (const auto& input : portsOf(coordinator.estimator()).inputs()) inputs.push_back(input.name);
  EXPECT_EQ(inputs, (std::vector<std::string>{"motion", "observations", "second_observations",
                                              "rear_observations", "rear_second_observations"}));
}

TEST_F(SeveralDetectors, MapWhatEachOfThemSeesUnderIdsThatNeverMix) {
  knowBoth();
  for (int i = 0; i < 5; ++i) {
    drive(100 * i);
    look("camera", 50 + 100 * i);
    look("rear_camera", 70 + 100 * i);
  }
  drive(600);
  EXPECT_EQ(ids(), (std::vector<LandmarkId>{3, 4, 10003, 10004}));
  EXPECT_NEAR(map()[0].position.x(), 2.0, 0.1);
  EXPECT_NEAR(map()[1].position.x(), -2.0, 0.1) << "of the rear camera's own mount";
  EXPECT_EQ(sentences, std::vector<std::string>());
}

TEST_F(SeveralDetectors, OfOneImageAreOneStepAndThoseOfTwoCamerasTwo) {
  knowBoth();
  for (const int time : {50, 150}) {
    look("rear_camera", time);
    look("camera", time);
  }
  drive(200);
  EXPECT_EQ(triggers(), (std::vector<std::string>{"observations", "rear_observations",
                                                  "observations", "rear_observations"}));
  ASSERT_EQ(reports.size(), 4u);
  EXPECT_EQ(reports[1].stamp, when(50));
  EXPECT_EQ(reports[2].stamp, when(150));
  EXPECT_EQ(reports[2].statistics.used, 2) << "one landmark of each detector";
}

TEST_F(SeveralDetectors, GiveTheSameWhateverTheOrderOfArrival) {
  knowBoth();
  for (int i = 0; i < 10; ++i) {
    drive(100 * i);
    look("camera", 50 + 100 * i);
    look("rear_camera", 90 + 100 * i);
  }
  drive(1000);
  struct Other : SeveralDetectors {
    void TestBody() override {
      for (int i = 0; i < 5; ++i) look("rear_camera", 90 + 100 * i);
      for (int i = 0; i < 10; ++i) look("camera", 50 + 100 * i);
      knowBoth();
      for (int i = 5; i < 10; ++i) look("rear_camera", 90 + 100 * i);
      drive(1000);
    }
    using SeveralDetectors::map;
    using SeveralDetectors::reports;
  } other;
  other.TestBody();
  ASSERT_EQ(other.reports.size(), reports.size());
  for (std::size_t i = 0; i < reports.size(); ++i) {
    EXPECT_EQ(other.reports[i].stamp, reports[i].stamp);
    EXPECT_EQ(other.reports[i].pose.pose.vector(), reports[i].pose.pose.vector());
    EXPECT_EQ(other.reports[i].pose.covariance, reports[i].pose.covariance);
  }
  ASSERT_EQ(other.map().size(), map().size());
  for (std::size_t i = 0; i < map().size(); ++i)
    EXPECT_EQ(other.map()[i].position, map()[i].position);
}

TEST_F(SeveralDetectors, OfACameraThatDiesDoNotStopTheOthers) {
  knowBoth();
  for (int i = 0; i < 30; ++i) {
    drive(100 * i);
    look("camera", 50 + 100 * i);
    if (i < 3) look("rear_camera", 70 + 100 * i);
  }
  EXPECT_GE(coordinator.counters()["source_timeout"], 1u);
  EXPECT_GE(reports.back().stamp, when(1800));
  for (int i = 30; i < 36; ++i) {
    drive(100 * i);
    look("camera", 50 + 100 * i);
    look("rear_camera", 70 + 100 * i);
  }
  EXPECT_GE(reports.back().stamp, when(3400)) << "it counts again when it is back";
  EXPECT_EQ(std::count_if(reports.begin(), reports.end(),
                          [](const auto& report) {
                            return report.trigger == "rear_observations" &&
                                   report.stamp > when(3000);
                          }),
            5);
}

TEST_F(SeveralDetectors, OfACameraWithoutAMountDoNotStopTheOthers) {
  know("camera", 0.0);
  coordinator.put("rear_camera", CameraCalibration{32, 24, "plumb_bob", 16, 16, 16, 12, {}});
  for (int i = 0; i < 30; ++i) {
    drive(100 * i);
    look("camera", 50 + 100 * i);
    look("rear_camera", 70 + 100 * i);
  }
  EXPECT_GE(reports.back().stamp, when(1500));
  EXPECT_EQ(ids(), (std::vector<LandmarkId>{3, 10003}));
  EXPECT_TRUE(oneSays(sentences, {"'rear_camera' is mounted", "rear_camera.sensor_pose"}));
  EXPECT_GT(heldAtGates(coordinator.wiring())["rear_camera_no_mount"], 0u);
}

TEST(SeveralDetectorsConfig, OneOfAPartHasThePortsOfItsPlace) {
  Settings settings({}, {}, kFour);
  MetaCoordinator part;
  part.configure(settings, {ProductPart::Extent::kDetector, "", "rear_second_"});
  ASSERT_EQ(part.components().detectors.size(), 1u);
  EXPECT_EQ(part.components().detectors[0].place.name, "beacons_b");
  const auto open = part.wiring().ports().open();
  EXPECT_NE(findPort(open, "rear_camera", kindOf<Image>()), nullptr);
  EXPECT_EQ(findPort(open, "camera", kindOf<Image>()), nullptr);
}

TEST(SeveralDetectorsConfig, RefusesTheSameDetectorTwice) {
  EXPECT_TRUE(oneSays(faultsOfWords({"detector=beacons_a", "second_detector=beacons_a"}),
                      {"second_detector", "'beacons_a' is the first detector already"}));
}

TEST(SeveralDetectorsConfig, RefusesARearCameraForADetectorThatHasNone) {
  EXPECT_TRUE(oneSays(faultsOfWords({"detector=laser_trunks", "second_camera=true"}),
                      {"second_camera", "'laser_trunks' does not look through the camera"}));
}

TEST(SeveralDetectorsConfig, RefusesToCalibrateASensorOfTwo) {
  EXPECT_TRUE(oneSays(faultsOfWords({"detector=beacons_a", "second_camera=true",
                                     "calibration.estimate=[sensor_yaw]"}),
                      {"calibration.estimate", "second_camera"}));
}

TEST(SeveralDetectorsConfig, RefusesACorrectionOfOneMountOfTwo) {
  const std::string yaw = "landmark_sensor.mount_yaw=0.01";
  EXPECT_TRUE(oneSays(faultsOfWords({"detector=beacons_a", "second_camera=true", yaw}),
                      {"landmark_sensor", "mount_yaw", "camera.sensor_pose"}));
  EXPECT_TRUE(faultsOfWords({"detector=beacons_a", yaw}).empty());
}

TEST(SeveralDetectorsConfig, RefusesMarkersThatTwoDetectorsWouldFind) {
  const std::vector<std::string> both = {"detector=apriltag", "second_detector=aruco"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), both.begin(), both.end());
    return faultsOfWords(more);
  };
  EXPECT_TRUE(with({"aruco.dictionaries=[DICT_4X4_50]"}).empty());
  EXPECT_TRUE(oneSays(with({"aruco.dictionaries=[DICT_APRILTAG_36h11]"}),
                      {"aruco", "DICT_APRILTAG_36h11 holds the markers of apriltag's 36h11"}));
  EXPECT_TRUE(
      oneSays(with({"aruco.dictionaries=[DICT_4X4_50]", "aruco.id_offsets={DICT_4X4_50: 500}"}),
              {"aruco.id_offsets", "apriltag's 36h11 (0 .. 586)",
               "aruco's DICT_4X4_50 (500 .. 549)", "an offset of 587 or more"}));
  EXPECT_TRUE(oneSays(with({"second_camera=true", "aruco.dictionaries=[DICT_APRILTAG_36h11]"}),
                      {"aruco", "DICT_APRILTAG_36h11 holds the markers of apriltag's 36h11"}))
      << "each fault once, however many cameras there are";
}

}  // namespace
}  // namespace slam
