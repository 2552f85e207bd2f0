// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <slam_msgs/LandmarkObservationArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "importer.hpp"
#include "laser_messages.hpp"
#include "messages.hpp"
#include "rawlog_log.hpp"
#include "rawlog_truth.hpp"

namespace slam::eval {

namespace {

nav_msgs::Odometry toMessage(const RawlogLog::Odometry& odometry) {
  nav_msgs::Odometry message = makeOdometry(odometry.stamp);
  message.pose.pose = toPose(odometry.x, odometry.y, odometry.theta);
  message.twist.twist.linear.x = odometry.vx;
  message.twist.twist.linear.y = odometry.vy;
  message.twist.twist.angular.z = odometry.omega;
  return message;
}

slam_msgs::LandmarkObservationArray toMessage(const RawlogLog::Sighting& sighting,
                                              std::uint64_t sequence) {
  slam_msgs::LandmarkObservationArray message;
  message.header.stamp = toTime(sighting.stamp);
  message.header.frame_id = sighting.sensor;
  message.sequence = sequence;
  message.sensor_pose.x = sighting.x;
  message.sensor_pose.y = sighting.y;
  message.sensor_pose.theta = sighting.theta;
  for (const RawlogLog::Reading& reading : sighting.readings) {
    slam_msgs::LandmarkObservation observation;
    observation.id = reading.id;
    observation.range = reading.range;
    observation.bearing = reading.bearing;
    std::copy(reading.covariance.begin(), reading.covariance.end(), observation.covariance.begin());
    message.observations.push_back(observation);
  }
  return message;
}

geometry_msgs::Pose toPose(const RawlogLog::Laser& laser) {
  const Eigen::Quaterniond turn = Eigen::AngleAxisd(laser.yaw, Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(laser.pitch, Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(laser.roll, Eigen::Vector3d::UnitX());
  geometry_msgs::Pose pose;
  pose.position.x = laser.x;
  pose.position.y = laser.y;
  pose.position.z = laser.z;
  pose.orientation.x = turn.x();
  pose.orientation.y = turn.y();
  pose.orientation.z = turn.z();
  pose.orientation.w = turn.w();
  return pose;
}

void addScans(const RawlogLog& log, BagWriter& bag) {
  if (!log.main_laser) return;
  addLaserMount(bag, kLaserFrame, toPose(log.lasers[*log.main_laser]));
  for (const auto& scan : log.scans)
    bag.add(kScanTopic, toMessage(scan.reading, scan.stamp, kLaserFrame));
}

void addLog(const RawlogLog& log, BagWriter& bag) {
  for (const auto& odometry : log.odometry) bag.add(kOdometryTopic, toMessage(odometry));
  std::uint64_t sequence = 0;
  for (const auto& sighting : log.sightings) {
    bag.add(kObservationsTopic, toMessage(sighting, sequence++));
  }
  addScans(log, bag);
}

std::string laserSummary(const RawlogLog& log) {
  if (!log.main_laser) return "";
  std::ostringstream text;
  text << " " << log.scans.size() << " scans";
  if (log.left_out_scans > 0) text << ", " << log.left_out_scans << " without beams left out";
  for (std::size_t i = 0; i < log.lasers.size(); ++i) {
    if (i == *log.main_laser) continue;
    const auto& laser = log.lasers[i];
    text << ", " << laser.scans << " of the laser '" << laser.label << "' left out, which looks "
         << std::lround(laser.yaw * 180.0 / M_PI) << " deg to the left";
  }
  text << ".";
  return text.str();
}

std::string summary(const RawlogLog& log) {
  std::size_t readings = 0;
  for (const auto& sighting : log.sightings) readings += sighting.readings.size();
  std::ostringstream text;
  text << log.odometry.size() << " odometry messages, " << log.sightings.size()
       << " observation arrays with " << readings
       << " readings. Left out: " << log.left_out_odometry
       << " odometry entries without a frame behind them, " << log.left_out_readings
       << " impossible readings, " << log.other_objects
       << " objects of other kinds. Sorted: " << log.out_of_order << " entries out of order.";
  text << laserSummary(log);
  if (log.sightings.empty() && log.scans.empty())
    text << " The log holds neither range-bearing observations nor scans.";
  if (log.made_up_stamps) {
    text << " The log's own stamps are missing, equal or closer than 5 ms: frame k (from 1) has "
            "the stamp 1 s + k * 0.1 s.";
  }
  return text.str();
}

class RawlogImporter : public Importer {
 public:
  std::string name() const override { return "rawlog"; }

  std::string description() const override {
    return "MRPT rawlog: planar odometry, range-bearing observations, scans, truth files beside it";
  }

  void addOptions(slam_ros::CommandLine& command) override {
    command.add("FILE", file_, "the rawlog").required();
    command.add("--truth-landmarks", landmarks_file_,
                "true landmarks [default: NAME_ground_truth.txt beside the rawlog]");
    command.add("--truth-path", path_file_,
                "true path [default: NAME_ground_truth_robot_path.txt beside the rawlog]");
  }

  std::string fileOfLibrary() const override { return file_; }

  std::string import(BagWriter& bag, Progress& progress) override {
    const RawlogLog log = readRawlog(file_, progress);
    addRobotName(bag, log.scans.empty() ? "mrpt_demo" : "sena");
    std::string text = summary(log);
    text += addTrueLandmarks(bag);
    text += addTruePath(log, bag);
    addLog(log, bag);
    return text;
  }

 private:
  std::string addTrueLandmarks(BagWriter& bag) {
    if (landmarks_file_.empty()) landmarks_file_ = findTruthFile(file_, "_ground_truth.txt");
    if (landmarks_file_.empty()) return " No true landmarks: there is no such file beside it.";
    slam_msgs::LandmarkMap map = makeTruthMap();
    for (const auto& landmark : readTrueLandmarks(landmarks_file_)) {
      map.landmarks.push_back(makeTruthLandmark(landmark.id, landmark.x, landmark.y));
    }
    bag.addFirstStamped(kTruthLandmarksTopic, map);
    return " " + std::to_string(map.landmarks.size()) + " true landmarks.";
  }

  std::string addTruePath(const RawlogLog& log, BagWriter& bag) {
    if (path_file_.empty()) path_file_ = findTruthFile(file_, "_ground_truth_robot_path.txt");
    if (path_file_.empty()) return " No true path: there is no such file beside it.";
    const auto poses = readTruePath(path_file_, log.frame_stamps.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
      bag.add(kTruthPoseTopic,
              makeTruthPose(log.frame_stamps[i], poses[i].x, poses[i].y, poses[i].theta));
    }
    return " " + std::to_string(poses.size()) + " true poses.";
  }

  std::string file_;
  std::string landmarks_file_;
  std::string path_file_;
};

}  // namespace

std::unique_ptr<Importer> makeRawlogImporter() { return std::make_unique<RawlogImporter>(); }

}  // namespace slam::eval
