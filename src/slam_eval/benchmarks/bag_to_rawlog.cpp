// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>

#include "slam_core/geometry/pose2.hpp"
#include "slam_ros/command_line.hpp"

// The laser and the odometry of a bag as a rawlog of actions and sensory frames, for MRPT's
// programs. On stdout a line a scan, stamps rising: the stamp [ns], the odometry's pose [m], [rad],
// and 1 where the scan has become a frame.

namespace slam::eval {
namespace {

struct Options {
  std::string bag, rawlog;
  double distance = 0.0, angle = 0.0;  ///< between frames [m], [rad]
};

Pose2 planar(const geometry_msgs::Pose& pose) {
  const auto& q = pose.orientation;
  return {pose.position.x, pose.position.y,
          std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))};
}

mrpt::poses::CPose2D toMrpt(const Pose2& pose) { return {pose.x(), pose.y(), pose.theta()}; }

/// Beams counter-clockwise over an aperture, as MRPT has them.
mrpt::obs::CObservation2DRangeScan toMrpt(const sensor_msgs::LaserScan& scan,
                                          const mrpt::poses::CPose3D& T_base_laser) {
  mrpt::obs::CObservation2DRangeScan made;
  const auto beams = scan.ranges.size();
  const double aperture = scan.angle_increment * static_cast<double>(beams - 1);
  const double middle = scan.angle_min + 0.5 * aperture;
  made.timestamp = mrpt::Clock::fromDouble(scan.header.stamp.toSec());
  made.sensorLabel = "laser";
  made.sensorPose = T_base_laser + mrpt::poses::CPose3D(0, 0, 0, middle, 0, 0);
  made.aperture = static_cast<float>(std::abs(aperture));
  made.rightToLeft = aperture > 0.0;
  made.maxRange = scan.range_max;
  made.resizeScan(beams);
  for (std::size_t i = 0; i < beams; ++i) {
    const float range = scan.ranges[i];
    const bool is_valid = range >= scan.range_min && range < scan.range_max;
    made.setScanRange(i, is_valid ? range : scan.range_max);
    made.setScanRangeValidity(i, is_valid);
  }
  return made;
}

/// Takes the messages of a bag in their order and writes a frame where the robot has gone far
/// enough.
class RawlogWriter {
 public:
  explicit RawlogWriter(const Options& options) : options_(options), file_(options.rawlog) {
    if (!file_.fileOpenCorrectly()) throw std::runtime_error(options.rawlog + " cannot be written");
  }

  void take(const rosbag::MessageInstance& message) {
    if (scan_ && message.getTime() > time_) finish();
    if (const auto mounts = message.instantiate<tf2_msgs::TFMessage>()) mount(*mounts);
    if (const auto odometry = message.instantiate<nav_msgs::Odometry>()) move(*odometry);
    const auto scan = message.instantiate<sensor_msgs::LaserScan>();
    if (scan) scan_ = scan;
    time_ = message.getTime();
  }

  /// Writes the last scan; odometry of the same time may come after it.
  void finish() {
    if (scan_) look(*scan_);
    scan_.reset();
  }

  std::size_t frames() const { return frames_; }

 private:
  void mount(const tf2_msgs::TFMessage& mounts) {
    for (const auto& transform : mounts.transforms) {
      geometry_msgs::Pose pose;
      pose.orientation = transform.transform.rotation;
      const auto& t = transform.transform.translation;
      mounts_[transform.child_frame_id] =
          mrpt::poses::CPose3D(t.x, t.y, t.z, planar(pose).theta(), 0.0, 0.0);
    }
  }

  void move(const nav_msgs::Odometry& odometry) {
    if (odometry.pose.covariance[0] < 0.0)
      throw std::runtime_error("the odometry tells velocities only, which makes no rawlog");
    now_ = planar(odometry.pose.pose);
  }

  void look(const sensor_msgs::LaserScan& scan) {
    if (!now_ || scan.ranges.size() < 2 || scan.header.stamp <= stamp_) return;
    stamp_ = scan.header.stamp;
    const bool is_frame = isDue();
    std::cout << scan.header.stamp.toNSec() << " " << now_->x() << " " << now_->y() << " "
              << now_->theta() << " " << is_frame << "\n";
    if (is_frame) write(scan);
  }

  const mrpt::poses::CPose3D& mountOf(const sensor_msgs::LaserScan& scan) const {
    const auto mount = mounts_.find(scan.header.frame_id);
    if (mount == mounts_.end())
      throw std::runtime_error("/tf_static has no '" + scan.header.frame_id +
                               "' before its first scan: where the laser sits is not known");
    return mount->second;
  }

  bool isDue() const {
    if (!last_) return true;
    const Pose2 increment = last_->between(*now_);
    return increment.position().norm() >= options_.distance ||
           std::abs(increment.theta()) >= options_.angle;
  }

  void write(const sensor_msgs::LaserScan& scan) {
    const Pose2 increment = last_ ? last_->between(*now_) : Pose2();
    mrpt::obs::CActionRobotMovement2D motion;
    motion.computeFromOdometry(toMrpt(increment), {});
    motion.timestamp = mrpt::Clock::fromDouble(scan.header.stamp.toSec());
    mrpt::obs::CActionCollection actions;
    actions.insert(motion);
    mrpt::obs::CSensoryFrame frame;
    frame.insert(mrpt::obs::CObservation2DRangeScan::Create(toMrpt(scan, mountOf(scan))));
    auto archive = mrpt::serialization::archiveFrom(file_);
    archive << actions << frame;
    last_ = now_;
    ++frames_;
  }

  Options options_;
  mrpt::io::CFileGZOutputStream file_;
  std::map<std::string, mrpt::poses::CPose3D> mounts_;  ///< T_base_laser by the laser's frame
  sensor_msgs::LaserScan::ConstPtr scan_;               ///< that is not written yet
  ros::Time time_, stamp_;                              ///< of the last message; scan
  std::optional<Pose2> now_, last_;                     ///< odometry; that of the last frame
  std::size_t frames_ = 0;
};

void convert(const Options& options) {
  rosbag::Bag bag;
  try {
    bag.open(options.bag, rosbag::bagmode::Read);
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(options.bag + " cannot be read as a bag: " + error.what());
  }
  const std::string part = options.rawlog + ".part";
  const std::vector<std::string> topics = {"/tf_static", "/odom", "/scan"};
  try {
    RawlogWriter writer({options.bag, part, options.distance, options.angle});
    for (const auto& message : rosbag::View(bag, rosbag::TopicQuery(topics))) writer.take(message);
    writer.finish();
    if (writer.frames() == 0) throw std::runtime_error("no scan on /scan after odometry on /odom");
  } catch (const std::exception& error) {
    std::remove(part.c_str());  // a part of a log would pass for a whole one
    throw std::runtime_error(options.bag + " makes no rawlog: " + error.what());
  }
  if (std::rename(part.c_str(), options.rawlog.c_str()) != 0)
    throw std::runtime_error(options.rawlog + " cannot be written");
}

}  // namespace
}  // namespace slam::eval

int main(int argc, char** argv) {
  std::cout.precision(9);
  slam_ros::CommandLine line("slam_eval_rawlog", "The laser and the odometry of a bag as a rawlog");
  slam::eval::Options options;
  line.add("BAG", options.bag).existingFile().required();
  line.add("RAWLOG", options.rawlog).required();
  line.add("--distance", options.distance, "between frames [m]").withDefault();
  line.add("--angle", options.angle, "or so much [rad]").withDefault();
  return line.run(argc, argv, [&] { slam::eval::convert(options); });
}
