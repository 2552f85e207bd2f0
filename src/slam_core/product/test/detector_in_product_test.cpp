// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/product/test/product_run.hpp"
#include "slam_core/product/test/spot_detector.hpp"

namespace slam {
namespace {

using test::oneSays;

struct LampConfig {
  static constexpr const char* kSection = "lamp";

  double distance = 2.0;

  void describe(Fields& fields) {
    fields.add("distance", &distance, "of the lamp").unit("m").in(Range::above(0)).ofRobot();
  }
};

/// A detector of one's own: the brightest spot of an image is the lamp, landmark 1.
class LampDetector final : public test::SpotDetector {
 public:
  void configure(Settings& settings) override {
    SpotDetector::configure(settings);
    config_ = settings.read<LampConfig>();
  }

 private:
  LandmarkId idOf(double /*brightness*/) const override { return 1; }
  double distance() const override { return config_.distance; }

  LampConfig config_;
};

const Registrar<LandmarkDetector, LampDetector> kRegistrar("lamp");
const SectionRegistrar<LampConfig> kSectionRegistrar;

std::vector<std::string> faultsOf(const std::string& product, const std::string& robot,
                                  const std::vector<std::string>& overrides = {}) {
  return test::faultsOf([&] {
    Settings settings({"product.yaml", YAML::Load(product)}, {"robot.yaml", YAML::Load(robot)},
                      overrides);
    MetaCoordinator().configure(settings);
  });
}

TEST(DetectorConfig, AnyRegisteredDetectorCanBeNamed) {
  EXPECT_TRUE(
      faultsOf("{version: 1, detector: lamp}", "{version: 1, lamp: {distance: 1}}").empty());
  EXPECT_TRUE(faultsOf("{version: 1, detector: none}", "").empty());
  EXPECT_TRUE(oneSays(faultsOf("{version: 1, detector: lmap}", ""),
                      {"detector 'lmap'", "did you mean 'lamp'", "'none'"}));
}

TEST(DetectorConfig, SectionsOfUnusedComponentsMayStandInTheFilesButAreChecked) {
  EXPECT_TRUE(faultsOf("", "{version: 1, lamp: {distance: 3}}").empty());
  EXPECT_TRUE(oneSays(faultsOf("", "{version: 1, lamp: {distance: 0}}"), {"lamp.distance", "> 0"}));
  EXPECT_TRUE(oneSays(faultsOf("", "{version: 1, lamp: {distence: 1}}"),
                      {"lamp.distence", "did you mean 'distance'"}));
  EXPECT_TRUE(oneSays(faultsOf("", "{version: 1, lmap: {}}"), {"did you mean 'lamp'"}));
}

TEST(DetectorConfig, AnOverrideThatWouldHaveNoEffectIsRefused) {
  EXPECT_TRUE(oneSays(faultsOf("", "", {"lamp.distance=3"}), {"lamp.distance=3", "no section"}));
  EXPECT_TRUE(faultsOf("", "", {"detector=lamp", "lamp.distance=3"}).empty());
}

TEST(DetectorConfig, ValuesInForceAreThoseOfTheComponentsInUse) {
  Settings settings({}, {"robot.yaml", YAML::Load("{version: 1, lamp: {distance: 3}}")}, {});
  MetaCoordinator().configure(settings);
  EXPECT_EQ(settings.inForce().find("lamp"), std::string::npos);
}

Stamp at(int milliseconds) {
  return stampFromNanoseconds(1000000000) + std::chrono::milliseconds(milliseconds);
}

Image lampAt(int column, int milliseconds) {
  Image image{at(milliseconds), "camera", cv::Mat::zeros(24, 32, CV_8UC1), ""};
  image.gray.at<std::uint8_t>(12, column) = 255;
  image.gray.at<std::uint8_t>(0, milliseconds / 100 % 32) = 1;  // a camera repeats no image
  return image;
}

struct DetectorRun : testing::Test, test::ProductRun {
  DetectorRun() {
    configure({"detector=lamp"});
    for (int i = 0; i <= 20; ++i) {
      OdometrySample sample;
      sample.stamp = at(100 * i);
      sample.pose = Pose2(0.01 * i, 0, 0);
      coordinator.set(sample);
    }
  }
  void giveCalibrationAndMount() {
    coordinator.put("camera", CameraCalibration{32, 24, "plumb_bob", 16, 16, 16, 12, {}});
    coordinator.put("camera", CameraMount{"camera", Eigen::Isometry3d::Identity()});
  }
};

TEST_F(DetectorRun, EveryImageIsAStepAndWhatIsSeenIsMapped) {
  giveCalibrationAndMount();
  for (int i = 0; i < 5; ++i) coordinator.set(lampAt(16, 50 + 100 * i));
  drain();
  ASSERT_EQ(reports.size(), 5u);
  EXPECT_EQ(reports.front().stamp, at(50));
  EXPECT_EQ(reports.front().trigger, "observations");
  const auto map = coordinator.estimator().capabilities().find<LandmarkMapper>()->landmarks();
  ASSERT_EQ(map.size(), 1u);
  EXPECT_NEAR(map[0].position.x(), 2.0, 0.1);
  EXPECT_EQ(sentences, std::vector<std::string>());
}

TEST_F(DetectorRun, TheOrderOfImagesCalibrationAndMountDoesNotMatter) {
  for (int i = 0; i < 5; ++i) coordinator.set(lampAt(16 + i, 50 + 100 * i));
  drain();
  EXPECT_TRUE(reports.empty());
  giveCalibrationAndMount();
  drain();
  ASSERT_EQ(reports.size(), 5u);

  struct Other : DetectorRun {
    void TestBody() override {}
  } other;
  other.giveCalibrationAndMount();
  for (int i = 0; i < 5; ++i) other.coordinator.set(lampAt(16 + i, 50 + 100 * i));
  other.drain();
  ASSERT_EQ(other.reports.size(), 5u);
  EXPECT_EQ(other.reports.back().pose.pose.vector(), reports.back().pose.pose.vector());
  EXPECT_EQ(other.reports.back().pose.covariance, reports.back().pose.covariance);
}

TEST_F(DetectorRun, WarningsAndCountsOfTheCameraComeOutAndLateImagesAreDropped) {
  giveCalibrationAndMount();
  coordinator.set(lampAt(16, 100));
  coordinator.set(lampAt(16, 100));
  drain();
  EXPECT_TRUE(oneSays(sentences, {"image", "not newer"}));
  EXPECT_EQ(coordinator.counters()["camera_late"], 1u);
  EXPECT_EQ(coordinator.dropped(), 1u);
  coordinator.reset();
  EXPECT_EQ(coordinator.dropped(), 0u);
}

TEST_F(DetectorRun, ArraysAreShownToWhoWantsToDrawThem) {
  std::vector<Stamp> shown;
  coordinator.listen<LandmarkObservationArray>(
      "observations", [&](const auto& array) { shown.push_back(array.stamp); });
  coordinator.set(lampAt(16, 100));
  giveCalibrationAndMount();
  coordinator.set(lampAt(16, 200));
  EXPECT_EQ(shown, (std::vector<Stamp>{at(100), at(200)}));
}

TEST(DetectorNone, ImagesHaveNoEffect) {
  Settings settings;
  MetaCoordinator coordinator;
  coordinator.configure(settings);
  EXPECT_TRUE(coordinator.components().detectors.empty());
  coordinator.set(lampAt(16, 100));
  EXPECT_TRUE(coordinator.execute().isOk());
  EXPECT_TRUE(coordinator.counters().all().empty());
}

}  // namespace
}  // namespace slam
