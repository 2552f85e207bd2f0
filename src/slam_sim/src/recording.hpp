// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <sensor_msgs/CompressedImage.h>

#include <atomic>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "slam_core/common/progress.hpp"
#include "slam_ros/bag_file.hpp"
#include "slam_sim/drive.hpp"
#include "slam_sim/gyroscope.hpp"
#include "slam_sim/sensors.hpp"

namespace slam::sim {

struct RecordingOptions {
  std::uint64_t seed = 1;
  std::vector<std::string> streams;  ///< of streamNames(); none: all of them
  double duration = 0.0;             ///< at most [s]; 0: the whole drive
  unsigned threads = 1;              ///< that render; the bag does not depend on their number
};

/// The run was ended from outside.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "odom", "scan", "rear_scan", "imu" and "commands" where there are any, and the names of the
/// cameras.
std::vector<std::string> streamNames(const RobotModel& robot);

/// A robot's drive through a world as a bag: what its sensors say, and the truth.
///
/// The receive time of a message is its stamp. The robot's name, the true landmarks, the mounts and
/// each camera's calibration come first, some nanoseconds before everything else.
class Recording {
 public:
  /// @throw ConfigError the robot touches something on its path
  Recording(World world, RobotModel robot, RecordingOptions options);

  double duration() const { return duration_; }       ///< [s]
  double length() const { return drive_.length(); }   ///< of the whole drive [m]
  std::size_t messages() const { return messages_; }  ///< written

  /// Ends soon after `stop` has become true. Once.
  /// @throw slam_ros::BagPathError, slam_ros::BagWriteError, Interrupted; no bag is left then
  void write(const std::string& path, Progress& progress, const std::atomic<bool>& stop);

 private:
  enum class Kind { kOdometry, kScan, kRearScan, kImu, kCommand, kImage };
  struct Event {
    Duration time;  ///< after the start
    Kind kind;
    std::size_t camera;
    std::uint64_t reading;
  };

  void scheduleAll();
  void schedule(const std::string& stream, const Pace& pace, Kind kind, std::size_t camera = 0);
  Pose2 truth(double time) const;
  void writeFirst(slam_ros::BagFile& bag);
  void writeEvents(slam_ros::BagFile& bag, Progress& progress, const std::atomic<bool>& stop);
  void writeOdometry(slam_ros::BagFile& bag, const Event& event);
  void writeScan(slam_ros::BagFile& bag, const Event& event);
  void writeRearScan(slam_ros::BagFile& bag, const Event& event);
  void writeImu(slam_ros::BagFile& bag, const Event& event);
  void writeCommand(slam_ros::BagFile& bag, const Event& event);
  void writeImage(slam_ros::BagFile& bag, const Event& event, sensor_msgs::CompressedImage image);
  sensor_msgs::CompressedImage takeImage(const Event& event) const;
  template <class Message>
  void put(slam_ros::BagFile& bag, const std::string& topic, Message message);

  World world_;
  RobotModel robot_;
  RecordingOptions options_;
  Drive drive_;
  Sensors sensors_;
  WheelOdometer odometer_;
  Gyroscope gyro_;
  double duration_;
  std::vector<Event> events_;                       ///< in the order of time
  std::map<std::string, std::uint32_t> sequences_;  ///< of each topic's headers
  std::size_t messages_ = 0;
};

}  // namespace slam::sim
