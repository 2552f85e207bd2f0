// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>

#include "camera_bag.hpp"
#include "found_inputs.hpp"
#include "slam_core/product/landmark_file.hpp"
#include "slam_ros/offline_run.hpp"

namespace slam_ros {
namespace {

using test::addCamera;
using test::BagMaker;
using test::contains;
using test::messageOf;
using test::Topics;

constexpr const char* kRaw = "/camera/image_raw";
constexpr const char* kCompressed = "/camera/image_raw/compressed";
constexpr const char* kInfo = "/camera/camera_info";

struct CameraBag : ::testing::Test {
  BagInputs find(const std::vector<Remap>& remaps = {}) const {
    slam::ProductConfig product;
    product.detector = "aruco";
    return findOf(product, remaps);
  }
  BagInputs findOf(const slam::ProductConfig& product,
                   const std::vector<Remap>& remaps = {}) const {
    return test::findInputs(BagReader(folder / "x.bag"), product, remaps);
  }
  Topics camera(const std::vector<Remap>& remaps = {}) const {
    return find(remaps).topicsOf("camera");
  }
  test::Folder folder;
};

TEST_F(CameraBag, ImagesAreFoundByNameRawBeforeCompressed) {
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    addCamera(bag, kCompressed, kInfo);
    addCamera(bag, "/rear/image_raw", "/rear/camera_info");
  }
  EXPECT_EQ(camera(), (Topics{kCompressed, kInfo}));
  EXPECT_TRUE(find().notes().empty());
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    addCamera(bag, kCompressed, kInfo);
    addCamera(bag, kRaw, "");
  }
  EXPECT_EQ(camera(), (Topics{kRaw, kInfo}));
}

TEST_F(CameraBag, ARearCameraHasATopicOfItsOwn) {
  slam::ProductConfig product;
  product.detector = "apriltag";
  product.second_detector = "aruco";
  product.second_camera = true;
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    addCamera(bag, "/front/image_raw", "/front/camera_info");
  }
  const auto sentence = messageOf([&] { findOf(product); });
  EXPECT_TRUE(contains(sentence, "no data of rear_camera, only of camera on /front/image_raw"));
  EXPECT_TRUE(contains(sentence, "--remap rear_camera:=TOPIC"));
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    addCamera(bag, kRaw, kInfo);
    addCamera(bag, "/rear_camera/image_raw", "/rear_camera/camera_info");
  }
  const auto inputs = findOf(product);
  EXPECT_EQ(inputs.topicsOf("camera"), (Topics{kRaw, kInfo}));
  EXPECT_EQ(inputs.topicsOf("rear_camera"),
            (Topics{"/rear_camera/image_raw", "/rear_camera/camera_info"}));
}

TEST_F(CameraBag, TheOnlyImagesThereAreAreFoundByTypeWithTheCalibrationBesideThem) {
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    addCamera(bag, "/eye/image/compressed", "/eye/camera_info");
    bag.add("/other/camera_info", 1, test::cameraInfo(1));
    bag.add("/detections/image", 1, test::rawImage(1));
  }
  EXPECT_EQ(camera(), (Topics{"/eye/image/compressed", "/eye/camera_info"}));
  ASSERT_EQ(find().notes().size(), 1u);
  EXPECT_TRUE(contains(find().notes()[0], "the only one of type sensor_msgs/CompressedImage"));
}

TEST_F(CameraBag, ACameraThatLooksUpIsFoundWhereTheOdometryNeedsItAndIsNoOtherCamera) {
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    addCamera(bag, "/ceiling_camera/image_raw", "/ceiling_camera/camera_info");
    addCamera(bag, kCompressed, kInfo);
    bag.add("/visual_odometry/image", 1, test::rawImage(1));
  }
  EXPECT_EQ(find().topicsOf("ceiling_camera"), Topics{}) << "wheels need no ceiling";
  EXPECT_EQ(camera(), (Topics{kCompressed, kInfo}));
  slam::ProductConfig product;
  product.detector = "aruco";
  product.odometry = "visual";
  const auto inputs = findOf(product);
  EXPECT_EQ(inputs.topicsOf("ceiling_camera"),
            (Topics{"/ceiling_camera/image_raw", "/ceiling_camera/camera_info"}));
  EXPECT_EQ(inputs.topicsOf("camera"), (Topics{kCompressed, kInfo}));
  EXPECT_EQ(inputs.topicsOf("odom"), Topics{}) << "nobody takes it in";
}

TEST_F(CameraBag, ABagWithoutTheCeilingLacksIt) {
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    bag.addObservations();
  }
  slam::ProductConfig product;
  product.odometry = "visual_wheel";
  EXPECT_TRUE(contains(messageOf([&] { findOf(product); }),
                       "images of the ceiling: 'ceiling_camera/image_raw'"));
}

TEST_F(CameraBag, ARemappingMeansRawOrCompressedImages) {
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    addCamera(bag, "/left/image/compressed", "/left/camera_info");
    addCamera(bag, "/right/image/compressed", "/right/camera_info");
    addCamera(bag, "/rear/image", "/rear/camera_info");
    addCamera(bag, "/front/image", "/front/camera_info");
  }
  EXPECT_TRUE(contains(messageOf([&] { find(); }), "choose with --remap camera:="));
  EXPECT_EQ(camera({{"camera", "/left/image/compressed"}}),
            (Topics{"/left/image/compressed", "/left/camera_info"}));
  EXPECT_EQ(camera({{"camera", "/right/image"}}).front(), "/right/image/compressed");
  EXPECT_EQ(camera({{"camera", "/rear/image"}, {"camera_info", "/left/camera_info"}}),
            (Topics{"/rear/image", "/left/camera_info"}));
}

TEST_F(CameraBag, ObservationsInTheBagLeaveTheDetectorOut) {
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry().addObservations();
    addCamera(bag, kRaw, kInfo);
  }
  EXPECT_EQ(camera(), Topics{});
  ASSERT_EQ(find().notes().size(), 1u);
  EXPECT_EQ(find().notes()[0],
            "the bag carries observations: the detector is left out; --remap camera:=TOPIC has it "
            "look at that camera's images instead");
  EXPECT_EQ(camera({{"camera", kRaw}}), (Topics{kRaw, kInfo})) << "what is named is asked for";
  EXPECT_EQ(find({{"camera", kRaw}}).topicsOf("observations"), Topics{});
}

TEST_F(CameraBag, WithoutObservationsAndImagesSaysWhatIsMissingAndWhatThereIs) {
  BagMaker(folder / "x.bag").addOdometry();
  const auto sentence = messageOf([&] { find(); });
  for (const auto* part :
       {"lacks landmarks", "'observations'", "'camera/image_raw' (sensor_msgs/Image)",
        "'camera/image_raw/compressed'", "it has /odom"})
    EXPECT_TRUE(contains(sentence, part)) << sentence;
}

TEST_F(CameraBag, ImagesWithoutCalibrationAreAWarning) {
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    addCamera(bag, kRaw, "");
    bag.add("/other/camera_info", 1, test::cameraInfo(1));
  }
  EXPECT_EQ(camera(), Topics{kRaw});
  ASSERT_EQ(find().warnings().size(), 1u);
  EXPECT_TRUE(contains(find().warnings()[0], "the bag has no /camera/camera_info"));
}

struct OfflineCamera : CameraBag {
  OfflineCamera() {
    product = folder.write("product.yaml", "version: 1\nproduct: test\ndetector: aruco\n");
    robot = folder.write("robot.yaml",
                         "version: 1\nrobot: test\nfiducial: {marker_size: 0.4}\n"
                         "aruco: {dictionaries: [DICT_4X4_50]}\n");
  }
  /// What it throws.
  std::string run(const std::string& out, const std::vector<std::string>& overrides = {},
                  const std::string& load_map = "") const {
    OfflineOptions options;
    options.product = product;
    options.robot = robot;
    options.bag = folder / "x.bag";
    options.folder = folder / out;
    options.overrides = overrides;
    options.load_map = load_map;
    return messageOf([&] { OfflineRun(options).run(); });
  }
  long lines(const std::string& out) const {
    const auto text = folder.read(out + "/trajectory.tum");
    return std::count(text.begin(), text.end(), '\n');
  }
  std::string product, robot;
};

TEST_F(OfflineCamera, MapsTheMarkerFromRawAndFromCompressedImagesAlike) {
  for (const auto* topic : {kRaw, kCompressed}) {
    {
      BagMaker bag(folder / "x.bag");
      bag.addOdometry().add("/tf_static", 0, test::cameraMount());
      addCamera(bag, topic, kInfo);
    }
    ASSERT_EQ(run(topic == kRaw ? "raw" : "compressed"), "");
  }
  EXPECT_EQ(lines("raw"), 35);
  const auto map = slam::loadLandmarks(folder / "raw/landmarks.yaml", "map").map;
  ASSERT_EQ(map.landmarks.size(), 1u);
  EXPECT_EQ(map.landmarks[0].id, test::kMarkerId);
  EXPECT_NEAR(map.landmarks[0].position.x(), test::kMarkerX, 0.1);
  EXPECT_NEAR(map.landmarks[0].position.y(), test::kMarkerY, 0.05);
  for (const auto* name : {"/trajectory.tum", "/landmarks.yaml", "/updates.csv"})
    EXPECT_EQ(folder.read(std::string("raw") + name),
              folder.read(std::string("compressed") + name));
}

TEST_F(OfflineCamera, CalibrationAndTransformMayComeAfterTheFirstImages) {
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry().add("/tf_static", 0, test::cameraMount()).add(kInfo, 0, test::cameraInfo(0));
    addCamera(bag, kRaw, "");
  }
  ASSERT_EQ(run("first"), "");
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry().add("/tf_static", 3, test::cameraMount()).add(kInfo, 2, test::cameraInfo(2));
    addCamera(bag, kRaw, "");
  }
  ASSERT_EQ(run("later"), "");
  for (const auto* name : {"/trajectory.tum", "/landmarks.yaml", "/updates.csv"})
    EXPECT_EQ(folder.read(std::string("first") + name), folder.read(std::string("later") + name));
}

/// Its path would be that of the odometry alone.
TEST_F(OfflineCamera, FailsWithoutCalibrationOrTransformOfTheWholeBag) {
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry().add("/tf_static", 0, test::cameraMount());
    addCamera(bag, kRaw, "");
  }
  EXPECT_EQ(run("run"),
            "nothing that the sensors saw could be used, and odometry alone is no result: "
            "/camera/image_raw came without the camera's calibration");
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    addCamera(bag, kRaw, kInfo);
  }
  EXPECT_TRUE(contains(run("run"), "does not tell the transform base_link -> camera"));
  EXPECT_EQ(run("run", {"camera.sensor_pose=[0.1, 0, 0.3, -1.57, 0, -1.57]"}), "")
      << "the robot file may give the mount";
}

TEST_F(OfflineCamera, FailsWhereNoImageOfTheWholeBagCanBeUsed) {
  const auto sentenceWith = [&](auto&& spoil) {
    {
      BagMaker bag(folder / "x.bag");
      bag.addOdometry().add("/tf_static", 0, test::cameraMount());
      for (double t = 0.5; t < 3.0; t += 0.5) {
        auto info = test::cameraInfo(t);
        auto image = test::rawImage(t);
        spoil(info, image, t);
        bag.add(kInfo, t, info).add(kRaw, t, image);
      }
    }
    return run("run");
  };
  const std::string beginning =
      "nothing that the sensors saw could be used, and odometry alone is no result: "
      "/camera/image_raw cannot be used: ";
  EXPECT_EQ(sentenceWith([](auto& info, auto&, double) { info.K = {}; }),
            beginning + "its focal lengths are zero: the camera is not calibrated");
  EXPECT_TRUE(contains(sentenceWith([](auto& info, auto&, double) { info.width /= 2; }),
                       beginning + "its images are of another size than its calibration"));
  EXPECT_TRUE(contains(sentenceWith([](auto&, auto& image, double) { image.encoding = "grau8"; }),
                       beginning + "an image of the encoding 'grau8' cannot be used"));
  EXPECT_EQ(sentenceWith([](auto& info, auto&, double t) {
              if (t < 2.0) info.K = {};
            }),
            "")
      << "the last images are good";
}

TEST_F(OfflineCamera, SaysWhatTheImagesOfAShortBagWaitedFor) {
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    addCamera(bag, kRaw, kInfo, 1.0);
  }
  EXPECT_TRUE(contains(run("run"), "does not tell the transform base_link -> camera"));
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry();
    addCamera(bag, kRaw, "", 1.0);
  }
  EXPECT_TRUE(contains(run("run"), "/camera/image_raw came without the camera's calibration"));
}

TEST_F(OfflineCamera, ALoadedMapIsThereFromTheStart) {
  {
    BagMaker bag(folder / "x.bag");
    bag.addOdometry().add("/tf_static", 0, test::cameraMount());
    addCamera(bag, kRaw, kInfo);
  }
  ASSERT_EQ(run("mapping"), "");
  EXPECT_EQ(run("known", {"ekf.mode=localization"}, folder / "mapping/landmarks.yaml"), "");
  const auto map = slam::loadLandmarks(folder / "mapping/landmarks.yaml", "map").map;
  const auto kept = slam::loadLandmarks(folder / "known/landmarks.yaml", "map").map;
  ASSERT_EQ(kept.landmarks.size(), 1u);
  EXPECT_EQ(kept.landmarks[0].position, map.landmarks[0].position);
  EXPECT_TRUE(contains(run("none", {}, folder / "nothing.yaml"), "does it exist?"));
}

}  // namespace
}  // namespace slam_ros
