// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "slam_core/camera/test/ceiling_picture.hpp"
#include "slam_core/common/test/temporary_folder.hpp"
#include "slam_core/fiducial/test/marker_picture.hpp"
#include "slam_core/grid_map/grid_file.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/point_map/test/room.hpp"

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

/// The numbers of each line, behind the word that it may begin with.
std::vector<std::vector<double>> table(const std::string& text, const std::string& kind = "") {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(line.substr(0, kind.size()), kind);
    std::istringstream words(line.substr(kind.size()));
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
  const auto rows = table(run.output, "motion ");
  ASSERT_EQ(rows.size(), 1u);
  ASSERT_EQ(rows[0].size(), 11u);
  EXPECT_EQ(rows[0][0], 1e9);
  EXPECT_EQ(rows[0][1], 2e9);
  EXPECT_NEAR(rows[0][5], 0.5, 1e-5);  // straight ahead
  EXPECT_NEAR(rows[0][6], 0.0, 1e-5);
  EXPECT_NEAR(rows[0][7], 2.0 - M_PI / 2, 1e-5);
  for (int i : {8, 9, 10}) EXPECT_GT(rows[0][i], 0.0);
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
  writeCalibration(folder, test::ceilings::smallCamera());
  const test::ceilings::Ceiling ceiling;
  const Pose2 step(0.08, 0.03, 0.1);
  Pose2 truth;
  std::ostringstream log;
  for (int i = 0; i < 4; ++i, truth = truth * step) {
    const auto name = "image " + std::to_string(i) + ".png";
    cv::Mat gray;
    ceiling.seenBy(test::ceilings::mountUp(), truth).convertTo(gray, CV_8U);
    cv::imwrite(folder / name, gray);
    log << "image " << 1000000000 + i * 100000000 << ' ' << name << '\n';
  }
  folder.write("log.txt", log.str());
  const auto run = call(folder, "slam_core_ceiling_images",
                        "camera.yaml log.txt visual_odometry.ceiling_height=1.7 "
                        "'ceiling_camera.sensor_pose=[0, 0, 0.8, 0, 0, 0]'");
  ASSERT_EQ(run.code, 0) << run.errors;
  const auto rows = table(run.output, "motion ");
  ASSERT_EQ(rows.size(), 3u) << run.errors;
  for (const auto& row : rows) {
    EXPECT_NEAR(row.at(5), step.x(), 0.006);
    EXPECT_NEAR(row.at(6), step.y(), 0.006);
    EXPECT_NEAR(row.at(7), step.theta(), 0.006);
  }
}

TEST(CeilingImages, NamesAnImageThatIsNotThere) {
  const TemporaryFolder folder;
  writeCalibration(folder, test::ceilings::smallCamera());
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

TEST(EkfLog, FindsRobotAndLandmarks) {
  const TemporaryFolder folder;
  folder.write("log.txt",
               "motion 1000000000 2000000000 1 0 0  1 0 0  0.05 0.05 0.02\n"
               "observations 2000000000 3 2.0 0.0 4 1.0 1.5707963\n"
               "motion 2000000000 3000000000 2.1 0 0  1.1 0 0  0.1 0.1 0.02  # 0.1 m too far\n"
               "observations 3000000000 3 1.0 0.0 4 1.4142136 2.3561945\n");
  const auto run = call(folder, "slam_core_ekf_log",
                        "log.txt landmark_sensor.sigma_range=0.01 "
                        "landmark_sensor.sigma_bearing=0.005");
  ASSERT_EQ(run.code, 0) << run.errors;
  const auto landmarks_begin = run.output.find("landmark ");
  ASSERT_NE(landmarks_begin, std::string::npos) << run.output;
  const auto poses = table(run.output.substr(0, landmarks_begin), "pose ");
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_NEAR(poses[1].at(1), 2.0, 0.02);  // the landmarks say so
  EXPECT_NEAR(poses[1].at(2), 0.0, 0.02);
  const auto landmarks = table(run.output.substr(landmarks_begin), "landmark ");
  ASSERT_EQ(landmarks.size(), 2u);
  EXPECT_EQ(landmarks[0].at(0), 3);
  EXPECT_NEAR(landmarks[0].at(1), 3.0, 0.03);
  EXPECT_NEAR(landmarks[1].at(2), 1.0, 0.03);
}

TEST(EkfLog, NamesALineThatIsCutOff) {
  const TemporaryFolder folder;
  folder.write("log.txt", "observations 2000000000 3 2.0\n");
  const auto run = call(folder, "slam_core_ekf_log", "log.txt");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.errors.find("line 1: a number is missing"), std::string::npos) << run.errors;
  EXPECT_EQ(call(folder, "slam_core_ekf_log", "").code, 2);
  folder.write("log.txt", "\nobservations 2000000000 3 nan 0\n");
  EXPECT_EQ(call(folder, "slam_core_ekf_log", "log.txt").errors.find("line 2: "), 0u);
}

std::string motionText(const Motion& motion) {
  std::ostringstream row;
  row.precision(12);
  row << "motion " << nanoseconds(motion.start) << ' ' << nanoseconds(motion.end);
  const Eigen::Vector3d pose = motion.odometry_end.vector(), step = motion.increment.vector();
  for (int i = 0; i < 3; ++i) row << ' ' << pose(i);
  for (int i = 0; i < 3; ++i) row << ' ' << step(i);
  for (int i = 0; i < 3; ++i) row << ' ' << std::sqrt(motion.covariance(i, i));
  row << '\n';
  return row.str();
}

/// A beam that met nothing is as drivers tell it, +Inf.
std::string scanText(const LaserScan& scan) {
  std::ostringstream row;
  const auto& beams = scan.beams;
  row << "scan " << nanoseconds(scan.stamp) << ' ' << beams.at(0).bearing << ' '
      << (beams.back().bearing - beams.front().bearing) / static_cast<float>(beams.size() - 1)
      << " 0.02 8.0";
  for (const auto& beam : beams) beam.hit ? row << ' ' << beam.range : row << " inf";
  row << '\n';
  return row.str();
}

/// Of the poses of a room's drive.
std::vector<Pose2> writeRoomLog(const TemporaryFolder& folder, int steps) {
  test::RoomDrive drive(1);
  std::vector<Pose2> truth;
  std::ostringstream log;
  for (int i = 0; i < steps; ++i) {
    const auto step = drive.next();
    log << motionText(step.motion) << scanText(step.scan);
    truth.push_back(step.truth);
  }
  folder.write("log.txt", log.str());
  return truth;
}

constexpr const char* kRoomMount = "'laser.sensor_pose=[0.1, 0, 0, 0, 0, 0.05]'";

TEST(GridLog, FollowsTheRobotAndMapsTheRoom) {
  const TemporaryFolder folder;
  const auto truth = writeRoomLog(folder, 145);  // once round
  const auto run = call(folder, "slam_core_grid_log",
                        std::string("log.txt map.yaml pf.particles=15 ") + kRoomMount);
  ASSERT_EQ(run.code, 0) << run.errors;
  const auto rows = table(run.output, "pose ");
  ASSERT_EQ(rows.size(), truth.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 4u);
    EXPECT_NEAR(rows[i][1], truth[i].x(), 0.15) << i;
    EXPECT_NEAR(rows[i][2], truth[i].y(), 0.15) << i;
  }
  const auto grid = grid_map::loadGrid(folder / "map.yaml");
  EXPECT_GT(test::shareOnWalls(grid, test::Room()), 0.8);
}

TEST(GridLog, SaysWhenThereIsNothingToMap) {
  const TemporaryFolder folder;
  folder.write("log.txt", "motion 1000000000 2000000000 1 0 0  1 0 0  0.1 0.1 0.1\n");
  const auto run = call(folder, "slam_core_grid_log", "log.txt map.yaml");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.errors.find("holds no scan"), std::string::npos) << run.errors;
  EXPECT_FALSE(std::filesystem::exists(folder / "map.yaml"));
  EXPECT_EQ(call(folder, "slam_core_grid_log", "log.txt").code, 2);
}

TEST(PointMapLog, DrawsTheWallsFromPosesMotionAndScans) {
  const TemporaryFolder folder;
  const point_map::test::Room room(6.0, 4.0);
  std::ostringstream log;
  std::uint64_t count = 0;
  const Pose2 step(0.05, 0.0, 0.02);
  Pose2 truth(2.0, 1.5, 0.3);
  for (; count < 40; ++count, truth = truth * step) {
    Motion motion;
    motion.start = stampFromNanoseconds(1000000000) + count * std::chrono::milliseconds(100);
    motion.end = motion.start + std::chrono::milliseconds(100);
    motion.increment = step;
    motion.covariance = Eigen::Matrix3d::Identity() * 1e-4;
    // the filter tells every other pose only: motion leads from there to the scan
    if (count % 2 == 0)
      log << "pose " << nanoseconds(motion.start) << ' ' << truth.x() << ' ' << truth.y() << ' '
          << truth.theta() << "\n";
    log << motionText(motion);
    auto scan = room.scan(truth);
    scan.stamp = motion.start;
    log << scanText(scan);
  }
  folder.write("log.txt", log.str());
  const auto run =
      call(folder, "slam_core_point_map_log", "log.txt 'laser.sensor_pose=[0.1, 0, 0, 0, 0, 0]'");
  ASSERT_EQ(run.code, 0) << run.errors;
  const auto data = run.output.find("DATA ascii\n");
  ASSERT_NE(data, std::string::npos) << run.output;
  const auto points = table(run.output.substr(data + 11));
  EXPECT_GT(points.size(), 200u);
  for (const auto& point : points) EXPECT_LT(room.distance({point.at(0), point.at(1)}), 0.01);
}

TEST(PointMapLog, NamesARowThatNobodyKnows) {
  const TemporaryFolder folder;
  folder.write("log.txt", "# of a laser\nscna 1000000000 0 0.1 0.02 8 1 1 1\n");
  const auto run = call(folder, "slam_core_point_map_log", "log.txt");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.errors.find("line 2: 'scna' is no kind of row (did you mean 'scan'?)"),
            std::string::npos)
      << run.errors;
}

TEST(PointMapLog, ToldNoPoseItSaysWhatBecameOfTheScans) {
  const TemporaryFolder folder;
  folder.write("log.txt", "scan 1000000000 0 0.1 0.02 8 1 x 1\n");
  auto run = call(folder, "slam_core_point_map_log", "log.txt");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.errors.find("line 1: a number is missing or malformed: 'x'"), std::string::npos)
      << run.errors;
  folder.write("log.txt",
               "scan 1000000000 0 0.1 0.02 8 1 nan inf\n"
               "motion 1500000000 2000000000 0 0 0  0 0 0  0.1 0.1 0.1\npose 1500000000 0 0 0\n"
               "pose 1900000000 0 0 0\n");
  run = call(folder, "slam_core_point_map_log", "log.txt");
  EXPECT_EQ(run.code, 0);
  EXPECT_NE(run.errors.find("1 x before_pose"), std::string::npos) << run.errors;
  EXPECT_NE(run.output.find("POINTS 0\n"), std::string::npos) << run.output;
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

TEST(TextLog, RunsAProductThatDrawsWhatALaserSees) {
  const TemporaryFolder folder;
  folder.write("product.yaml", "version: 1\nproduct: p\nbackend: ekf\npointmap: true\n");
  folder.write("robot.yaml",
               "version: 1\nrobot: r\nlaser: {sensor_pose: [0.1, 0, 0, 0, 0, 0.05]}\n"
               "landmark_sensor: {sigma_range: 0.05, sigma_bearing: 0.01}\n");
  test::RoomDrive drive(1);
  Pose2 before;
  std::ostringstream log;
  for (int i = 0; i < 20; ++i) {
    auto step = drive.next();
    step.motion.increment = before.between(step.truth);  // wheels that do not err
    before = step.truth;
    log << motionText(step.motion) << "observations " << nanoseconds(step.motion.end) << '\n'
        << scanText(step.scan);
  }
  folder.write("log.txt", log.str());
  const auto run = call(folder, "slam_core_text_log", "product.yaml robot.yaml log.txt out");
  ASSERT_EQ(run.code, 0) << run.errors;
  const auto pcd = test::contentOf(folder / "out/points.pcd");
  const auto points = table(pcd.substr(pcd.find("DATA ascii\n") + 11));
  EXPECT_GT(points.size(), 200u);
  for (const auto& point : points) {
    const auto in_room = test::RoomDrive::start().transform({point.at(0), point.at(1)});
    EXPECT_LT(drive.room().distance(in_room), 0.06);  // the laser errs by 0.01 m
  }
}

}  // namespace
}  // namespace slam
