// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <Eigen/Core>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "slam_core/common/test/temporary_folder.hpp"
#include "slam_core/fiducial/test/marker_picture.hpp"
#include "slam_core/visual_odometry/test/ceiling_picture.hpp"

// The components as programs of their own, without ROS: logs with a known answer in, text out.

namespace slam {
namespace {

using test::TemporaryFolder;

struct Run {
  int code;
  std::string output, errors;
};

Run call(const TemporaryFolder& folder, const std::string& program, const std::string& arguments) {
  const auto output = folder / "output.txt", errors = folder / "errors.txt";
  const auto command = "cd '" + folder / "" + "' && '" + std::string(PROGRAMS) + "/" + program +
                       "' " + arguments + " >'" + output + "' 2>'" + errors + "'";
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), test::contentOf(output), test::contentOf(errors)};
}

/// The numbers of each line.
std::vector<std::vector<double>> table(const std::string& text) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    rows.emplace_back();
    for (double number; words >> number;) rows.back().push_back(number);
  }
  return rows;
}

void writeCalibration(const TemporaryFolder& folder, const CameraCalibration& camera) {
  std::ostringstream yaml;
  yaml << "image_width: " << camera.width << "\nimage_height: " << camera.height
       << "\ncamera_matrix: {data: [" << camera.fx << ", 0, " << camera.cx << ", 0, " << camera.fy
       << ", " << camera.cy << ", 0, 0, 1]}\ndistortion_model: plumb_bob\n"
       << "distortion_coefficients: {data: [";
  for (std::size_t i = 0; i < 5; ++i) yaml << (i > 0 ? ", " : "") << camera.distortion.at(i);
  folder.write("camera.yaml", yaml.str() + "]}\n");
}

TEST(WheelLog, GivesTheIncrementBetweenTwoPoses) {
  const TemporaryFolder folder;
  folder.write("log.txt",
               "# a turn to the left\nodometry 1000000000 0 0 1.5707963267948966\n"
               "observations 1500000000 3 2.0 0.1\nodometry 2000000000 0 0.5 2.0\n");
  const auto run = call(folder, "slam_core_wheel_log", "log.txt");
  ASSERT_EQ(run.code, 0) << run.errors;
  const auto rows = table(run.output);
  ASSERT_EQ(rows.size(), 1u);
  ASSERT_EQ(rows[0].size(), 10u);
  EXPECT_EQ(rows[0][0], 2e9);
  EXPECT_NEAR(rows[0][4], 0.5, 1e-5);  // straight ahead
  EXPECT_NEAR(rows[0][5], 0.0, 1e-5);
  EXPECT_NEAR(rows[0][6], 2.0 - M_PI / 2, 1e-5);
  for (int i : {7, 8, 9}) EXPECT_GT(rows[0][i], 0.0);
}

TEST(WheelLog, NamesTheLineOfAFault) {
  const TemporaryFolder folder;
  folder.write("log.txt", "odometry 1000000000 0 0 0\nodometry 2000000000 0\n");
  const auto run = call(folder, "slam_core_wheel_log", "log.txt");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.errors.find("line 2: "), std::string::npos) << run.errors;
  EXPECT_EQ(call(folder, "slam_core_wheel_log", "").code, 2);
}

TEST(CeilingImages, FollowsTheRobot) {
  const TemporaryFolder folder;
  writeCalibration(folder, visual_odometry::test::smallCamera());
  const visual_odometry::test::Ceiling ceiling;
  const Pose2 step(0.08, 0.03, 0.1);
  Pose2 truth;
  std::ostringstream log;
  for (int i = 0; i < 4; ++i, truth = truth * step) {
    const auto name = "image " + std::to_string(i) + ".png";
    cv::Mat gray;
    ceiling.seenBy(visual_odometry::test::mountUp(), truth).convertTo(gray, CV_8U);
    cv::imwrite(folder / name, gray);
    log << "image " << 1000000000 + i * 100000000 << ' ' << name << '\n';
  }
  folder.write("log.txt", log.str());
  const auto run = call(folder, "slam_core_ceiling_images",
                        "camera.yaml log.txt visual_odometry.ceiling_height=1.7 "
                        "'ceiling_camera.sensor_pose=[0, 0, 0.8, 0, 0, 0]'");
  ASSERT_EQ(run.code, 0) << run.errors;
  const auto rows = table(run.output);
  ASSERT_EQ(rows.size(), 3u) << run.errors;
  for (const auto& row : rows) {
    EXPECT_NEAR(row.at(4), step.x(), 0.006);
    EXPECT_NEAR(row.at(5), step.y(), 0.006);
    EXPECT_NEAR(row.at(6), step.theta(), 0.006);
  }
}

TEST(CeilingImages, NamesAnImageThatIsNotThere) {
  const TemporaryFolder folder;
  writeCalibration(folder, visual_odometry::test::smallCamera());
  folder.write("log.txt", "image 1000000000 none.png\n");
  const auto run = call(folder, "slam_core_ceiling_images",
                        "camera.yaml log.txt visual_odometry.ceiling_height=1.7");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.errors.find("line 1: cannot read the image"), std::string::npos) << run.errors;
}

TEST(FiducialImages, TellsIdAndRangeOfAMarker) {
  const TemporaryFolder folder;
  CameraCalibration calibration;
  calibration.width = 640;
  calibration.height = 480;
  calibration.fx = calibration.fy = 500.0;
  calibration.cx = 320.0;
  calibration.cy = 240.0;
  calibration.distortion_model = "plumb_bob";
  calibration.distortion = {0, 0, 0, 0, 0};
  writeCalibration(folder, calibration);
  fiducial::test::MarkerPicture picture{CameraModel(calibration)};
  Eigen::Isometry3d T_camera_marker = Eigen::Isometry3d::Identity();
  T_camera_marker.translation().z() = 1.5;
  T_camera_marker.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  picture.add(fiducial::test::printedMarker(7), T_camera_marker);
  cv::imwrite(folder / "marker.png", picture.exposed());
  const auto run = call(folder, "slam_core_fiducial_images",
                        "apriltag camera.yaml fiducial.marker_size=0.16 marker.png");
  ASSERT_EQ(run.code, 0) << run.errors;
  EXPECT_NE(run.output.find("id 7"), std::string::npos) << run.output;
  const auto range = run.output.find("range ");
  ASSERT_NE(range, std::string::npos) << run.output;
  EXPECT_NEAR(std::stod(run.output.substr(range + 6)), 1.5, 0.02);
}

TEST(TextLog, RunsAProductOnALog) {
  for (const std::string backend : {"ekf", "pf"}) {
    const TemporaryFolder folder;
    folder.write("product.yaml", "version: 1\nproduct: p\nbackend: " + backend + "\n");
    folder.write(
        "robot.yaml",
        "version: 1\nrobot: r\nlandmark_sensor: {sigma_range: 0.05, sigma_bearing: 0.01}\n");
    folder.write("log.txt",
                 "odometry 1000000000 0 0 0\nodometry 2000000000 1 0 0\n"
                 "observations 2000000000 3 2.0 0.0 4 1.0 1.0\nodometry 3000000000 2 0 0\n"
                 "observations 3000000000 3 1.0 0.0\n");
    const auto run = call(folder, "slam_core_text_log", "product.yaml robot.yaml log.txt out");
    ASSERT_EQ(run.code, 0) << run.errors;
    EXPECT_NE(run.output.find("2 poses, 2 landmarks"), std::string::npos) << run.output;
    const auto rows = table(test::contentOf(folder / "out/trajectory.tum"));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_NEAR(rows[1][1], 2.0, 0.2);  // where wheels and landmark agree
  }
}

}  // namespace
}  // namespace slam
