// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/PointStamped.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "importer.hpp"
#include "laser_messages.hpp"
#include "messages.hpp"
#include "victoria_park_log.hpp"
#include "victoria_park_vehicle.hpp"

namespace slam::eval {
namespace {

constexpr double kReach = 80.0;  // of the laser [m]

sensor_msgs::LaserScan scanMessage(const VictoriaParkLog::Scan& scan) {
  LaserReading reading;
  reading.start_angle = -M_PI / 2.0;
  reading.increment = M_PI / 360.0;
  reading.max_range = kReach;
  reading.ranges = scan.ranges;
  auto message = toMessage(reading, scan.stamp, kLaserFrame);
  message.intensities = scan.intensities;
  return message;
}

nav_msgs::Odometry odometryMessage(const VictoriaParkLog::Driving& driving, const Pose2& pose) {
  auto message = makeOdometry(driving.stamp);
  message.pose.pose = toPose(pose.x(), pose.y(), pose.theta());
  message.twist.twist.linear.x = driving.forward;
  message.twist.twist.angular.z = driving.angular;
  return message;
}

/// A quaternion of zeros says that the heading is not known.
geometry_msgs::PoseStamped truthWithoutHeading(const VictoriaParkLog::Fix& fix) {
  auto message = makeTruthPose(fix.stamp, fix.x, fix.y, 0.0);
  message.pose.orientation.w = message.pose.orientation.z = 0.0;
  return message;
}

/// The true positions are those of this point of the robot.
void addAntenna(BagWriter& bag) {
  geometry_msgs::PointStamped message;
  message.header.frame_id = "base_link";
  message.point.x = victoria_park::kLaserAhead;
  message.point.y = victoria_park::kLaserLeft;
  bag.addFirstStamped(kTruthPointTopic, message);
}

double longestGap(const std::vector<VictoriaParkLog::Fix>& fixes) {
  std::int64_t gap = 0;
  for (std::size_t i = 1; i < fixes.size(); ++i)
    gap = std::max(gap, fixes[i].stamp - fixes[i - 1].stamp);
  return 1e-9 * static_cast<double>(gap);
}

std::string summaryOf(const VictoriaParkLog& log) {
  std::ostringstream text;
  text << log.scans.size() << " scans, " << log.driving.size() << " velocities, "
       << log.fixes.size() << " GPS fixes as truth without heading";
  if (log.fixes.size() > 1) text << " (longest gap " << longestGap(log.fixes) << " s)";
  text << "; rows left out: " << log.left_out << ".";
  if (log.are_axes_swapped)
    text << " The GPS columns are north and east: as x and y they would turn against the steering.";
  return text.str();
}

class VictoriaParkImporter : public Importer {
 public:
  std::string name() const override { return "victoria_park"; }

  std::string description() const override {
    return "Victoria Park data set: laser, speed and steering of a car, GPS as truth";
  }

  void addOptions(slam_ros::CommandLine& command) override {
    command.add("DIR", folder_, "the folder with aa3_lsr2.mat, aa3_dr.mat, aa3_gpsx.mat")
        .required();
  }

  std::string import(BagWriter& bag, Progress&) override {
    const auto log = makeVictoriaParkLog(readVictoriaParkTables(folder_));
    addRobotName(bag, "victoria_park");
    addLaserMount(bag, kLaserFrame,
                  toPose(victoria_park::kLaserAhead, victoria_park::kLaserLeft, 0.0));
    if (!log.fixes.empty()) addAntenna(bag);
    const auto poses = deadReckoning(log.driving);
    for (std::size_t i = 0; i < poses.size(); ++i)
      bag.add(kOdometryTopic, odometryMessage(log.driving[i], poses[i]));
    for (const auto& scan : log.scans) bag.add(kScanTopic, scanMessage(scan));
    for (const auto& fix : log.fixes) bag.add(kTruthPoseTopic, truthWithoutHeading(fix));
    return summaryOf(log);
  }

 private:
  std::string folder_;
};

}  // namespace

std::unique_ptr<Importer> makeVictoriaParkImporter() {
  return std::make_unique<VictoriaParkImporter>();
}

}  // namespace slam::eval
