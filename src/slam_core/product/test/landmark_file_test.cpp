// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/landmark_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "slam_core/common/random.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam {
namespace {

using test::contentOf;
using test::oneSays;
using test::sentenceOf;

LandmarkFile exampleFile(int landmarks = 3) {
  RandomStream random(1, 0);
  LandmarkFile file;
  file.stamp = stampFromNanoseconds(1288971842000000345);
  const Eigen::Index size = 3 + 2 * landmarks;
  const Eigen::MatrixXd A =
      Eigen::MatrixXd::NullaryExpr(size, size + 2, [&] { return 1e-3 * random.gaussian(); });
  Eigen::MatrixXd P = A * A.transpose();
  P.triangularView<Eigen::StrictlyUpper>() = P.transpose();
  file.map.joint_covariance = P;
  file.map.robot = {Pose2(random.gaussian(), 1e-17, -3.1), P.topLeftCorner<3, 3>()};
  for (int i = 0; i < landmarks; ++i) {
    const Eigen::Index row = 3 + 2 * i;
    file.map.landmarks.push_back(
        {7 * i, {1e3 * random.gaussian(), random.gaussian()}, P.block<2, 2>(row, row)});
  }
  return file;
}

class LandmarkFileTest : public testing::Test {
 protected:
  std::string refusalOf(const std::string& content) {
    const auto written = folder.write("landmarks.yaml", content);
    return sentenceOf([&] { loadLandmarks(written, "map"); });
  }
  /// What is said about the example with one piece of its text replaced.
  std::string refusalWith(const std::string& piece, const std::string& replacement) {
    auto text = toYaml(exampleFile());
    const auto at = text.find(piece);
    EXPECT_NE(at, std::string::npos) << piece << " in\n" << text;
    return refusalOf(text.replace(at, piece.size(), replacement));
  }

  const test::TemporaryFolder folder;
  const std::string path = folder / "landmarks.yaml";
};

TEST_F(LandmarkFileTest, ALineStaysALine) {
  auto saved = exampleFile();
  auto& line = saved.map.landmarks[1];
  line.kind = LandmarkKind::kLine;
  line.direction = -1.0 / 3.0;
  line.extent = {-2.0 / 7.0, 5.5};
  saveLandmarks(path, saved);
  const auto loaded = loadLandmarks(path, "map").map.landmarks;
  EXPECT_FALSE(loaded[0].isLine());
  ASSERT_TRUE(loaded[1].isLine());
  EXPECT_EQ(loaded[1].position, line.position);
  EXPECT_EQ(loaded[1].direction, line.direction);
  EXPECT_EQ(loaded[1].extent.begin, line.extent.begin);
  EXPECT_EQ(loaded[1].extent.end, line.extent.end);
  const auto refusal = [&](const std::string& piece, const std::string& other) {
    auto text = toYaml(saved);
    return refusalOf(text.replace(text.find(piece), piece.size(), other));
  };
  EXPECT_TRUE(
      oneSays({refusal("kind: line", "kind: circle")}, {"landmark 7", "neither point nor line"}));
  EXPECT_TRUE(oneSays({refusal("end: 5.5", "end: -1")}, {"line 7 ends where it begins"}));
  EXPECT_TRUE(oneSays({refusal("end: 5.5", "end: .nan")}, {"end is not a finite number"}));
}

TEST_F(LandmarkFileTest, ReadsBackEveryBit) {
  const auto saved = exampleFile();
  saveLandmarks(path, saved);
  const auto loaded = loadLandmarks(path, "map");
  EXPECT_EQ(loaded.frame, "map");
  EXPECT_EQ(loaded.stamp, saved.stamp);
  EXPECT_EQ(loaded.map.robot.pose.vector(), saved.map.robot.pose.vector());
  EXPECT_EQ(loaded.map.robot.covariance, saved.map.robot.covariance);
  EXPECT_EQ(loaded.map.joint_covariance, saved.map.joint_covariance);
  ASSERT_EQ(loaded.map.landmarks.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(loaded.map.landmarks[i].id, saved.map.landmarks[i].id);
    EXPECT_EQ(loaded.map.landmarks[i].position, saved.map.landmarks[i].position);
    EXPECT_EQ(loaded.map.landmarks[i].covariance, saved.map.landmarks[i].covariance);
  }
  EXPECT_EQ(toYaml(loaded), contentOf(path));
}

TEST_F(LandmarkFileTest, KeepsADescriptorAndRefusesOneThatIsNone) {
  auto saved = exampleFile();
  saved.map.landmarks[1].descriptor = descriptorOf(0.1F / 3.0F, 0.01);
  saveLandmarks(path, saved);
  const auto read = loadLandmarks(path, "map").map.landmarks;
  EXPECT_TRUE(read[0].descriptor.isEmpty());
  EXPECT_EQ(read[1].descriptor.values, saved.map.landmarks[1].descriptor.values);
  EXPECT_EQ(read[1].descriptor.sigmas, saved.map.landmarks[1].descriptor.sigmas);
  EXPECT_TRUE(test::oneSays({refusalWith("id: 7,", "id: 7, descriptor: [1, 2],")},
                            {"landmark 7 has a descriptor of 2 elements and sigmas of 0"}));
  EXPECT_TRUE(
      test::oneSays({refusalWith("id: 7,", "id: 7, descriptor: [1], descriptor_sigma: [-1],")},
                    {"landmark 7 has a descriptor with a sigma that is not positive"}));
}

TEST_F(LandmarkFileTest, ReadsAnEmptyMap) {
  auto file = exampleFile(0);
  saveLandmarks(path, file);
  EXPECT_TRUE(loadLandmarks(path, "map").map.landmarks.empty());
}

TEST_F(LandmarkFileTest, MayHaveNoJointCovariance) {
  auto file = exampleFile();
  file.map.joint_covariance.resize(0, 0);
  saveLandmarks(path, file);
  EXPECT_EQ(loadLandmarks(path, "map").map.joint_covariance.size(), 0);
}

TEST_F(LandmarkFileTest, MayBeWrittenByHand) {
  folder.write("landmarks.yaml",
               "{version: 1, frame: map, pose: {x: 0, y: 0, theta: 0, covariance: [1,0,0,0,1,0,0,0,"
               "1]}, landmarks: [{id: 4, x: 1, y: 2, covariance: [0.1, 0, 0, 0.1]}]}");
  EXPECT_EQ(loadLandmarks(path, "map").map.landmarks.at(0).id, 4);
}

TEST_F(LandmarkFileTest, IsNotWrittenWithWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refusalOf = [&](const LandmarkFile& file) {
    return sentenceOf([&] { saveLandmarks(path, file); });
  };
  auto of_landmark = exampleFile(), of_pose = exampleFile(), of_joint = exampleFile();
  of_landmark.map.landmarks[1].covariance(0, 1) = nan;
  of_pose.map.robot.covariance(0, 0) = std::numeric_limits<double>::infinity();
  of_joint.map.joint_covariance(6, 2) = nan;
  EXPECT_TRUE(oneSays({refusalOf(of_landmark)}, {path.c_str(), "landmark 7", "not finite"}));
  EXPECT_TRUE(oneSays({refusalOf(of_pose)}, {path.c_str(), "the pose", "not finite"}));
  EXPECT_TRUE(oneSays({refusalOf(of_joint)}, {path.c_str(), "joint covariance", "not finite"}));
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(LandmarkFileTest, SaysThatItIsMissing) {
  EXPECT_TRUE(oneSays({sentenceOf([&] { loadLandmarks(path, "map"); })}, {path.c_str(), "exist"}));
}

TEST_F(LandmarkFileTest, RefusesAnotherVersion) {
  EXPECT_TRUE(oneSays({refusalWith("version: 1", "version: 2")},
                      {path.c_str(), "version 2", "reads version 1"}));
  EXPECT_TRUE(oneSays({refusalWith("version: 1\n", "")}, {path.c_str(), "no version"}));
}

TEST_F(LandmarkFileTest, RefusesAnotherFrame) {
  EXPECT_TRUE(oneSays({refusalWith("frame: map", "frame: office")}, {"'office'", "'map'"}));
}

TEST_F(LandmarkFileTest, RefusesOtherUnitsAndPlacesOutOfThisWorld) {
  EXPECT_TRUE(oneSays({refusalWith("position: m,", "position: cm,")}, {"cm", "in m", "rad"}));
  EXPECT_TRUE(oneSays({refusalWith("{id: 7, x: ", "{id: 7, x: 1e160, z: ")}, {"landmark 7", "km"}));
  EXPECT_TRUE(oneSays({refusalWith("pose: {x: ", "pose: {x: -1e9, z: ")}, {"the pose", "km"}));
}

TEST_F(LandmarkFileTest, RefusesEveryTruncation) {
  const auto whole = toYaml(exampleFile());
  for (std::size_t length = 0; length + 2 < whole.size(); ++length)
    ASSERT_TRUE(oneSays({refusalOf(whole.substr(0, length))}, {path.c_str()}))
        << "cut off after\n"
        << whole.substr(0, length);
  ASSERT_EQ(refusalOf(whole), "");
}

TEST_F(LandmarkFileTest, RefusesGarbage) {
  for (const auto* garbage : {"",
                              "\x7f"
                              "ELF\x02\x01\x01",
                              "[1, 2, 3]", "version: {", "hello"})
    EXPECT_TRUE(oneSays({refusalOf(garbage)}, {path.c_str()})) << garbage;
  EXPECT_TRUE(oneSays({sentenceOf([&] { loadLandmarks(folder / "", "map"); })}, {"is a folder"}));
}

TEST_F(LandmarkFileTest, RefusesALandmarkThatIsThereTwice) {
  EXPECT_TRUE(oneSays({refusalWith("id: 7,", "id: 0,")}, {"landmark 0", "twice"}));
  EXPECT_TRUE(oneSays({refusalWith("id: 7,", "id: 20,")}, {"sorted"}));
}

TEST_F(LandmarkFileTest, RefusesNumbersThatAreNone) {
  EXPECT_TRUE(oneSays({refusalWith("theta: ", "theta: .nan #")}, {path.c_str()}));
  EXPECT_TRUE(oneSays({refusalWith("{id: 7, x: ", "{id: 7, x: .inf, z: ")}, {"x", "finite"}));
  EXPECT_TRUE(oneSays({refusalWith("stamp: \"", "stamp: \"soon")}, {"stamp", "soon"}));
}

TEST_F(LandmarkFileTest, RefusesACovarianceThatIsNone) {
  auto file = exampleFile();
  file.map.landmarks[1].covariance(0, 0) *= -1;
  EXPECT_TRUE(oneSays({refusalOf(toYaml(file))}, {"landmark 7", "positive definite"}));
  file = exampleFile();
  file.map.robot.covariance.setZero();
  EXPECT_TRUE(oneSays({refusalOf(toYaml(file))}, {"pose", "positive definite"}));
  file = exampleFile();
  file.map.joint_covariance(4, 4) = 0;
  EXPECT_TRUE(oneSays({refusalOf(toYaml(file))}, {"joint_covariance", "positive definite"}));
  file = exampleFile();
  file.map.joint_covariance = file.map.joint_covariance.topLeftCorner(7, 7).eval();
  EXPECT_TRUE(oneSays({refusalOf(toYaml(file))}, {"joint_covariance", "9 rows"}));
}

TEST_F(LandmarkFileTest, StaysAsItWasWhenItCannotBeSaved) {
  const auto nowhere = folder / "nowhere/landmarks.yaml";
  EXPECT_TRUE(oneSays({sentenceOf([&] { saveLandmarks(nowhere, exampleFile()); })},
                      {nowhere.c_str(), "No such file"}));
}

}  // namespace
}  // namespace slam
