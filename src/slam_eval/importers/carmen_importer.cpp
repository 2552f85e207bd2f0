// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>

#include "carmen_clock.hpp"
#include "carmen_log.hpp"
#include "importer.hpp"
#include "laser_messages.hpp"
#include "messages.hpp"

namespace slam::eval {
namespace {

constexpr std::int64_t kLongGap = 5'000'000'000;  // [ns]
constexpr double kFarJump = 1.0;                  // [m] between two scans

nav_msgs::Odometry odometryAt(std::int64_t stamp, const Pose2& pose) {
  nav_msgs::Odometry message = makeOdometry(stamp);
  message.pose.pose = toPose(pose.x(), pose.y(), pose.theta());
  return message;
}

nav_msgs::Odometry toMessage(const CarmenLog::Odometry& odometry) {
  nav_msgs::Odometry message = odometryAt(odometry.stamp, odometry.pose);
  message.twist.twist.linear.x = odometry.forward;
  message.twist.twist.angular.z = odometry.angular;
  return message;
}

std::string beamsOf(const CarmenLog& log) {
  std::set<std::size_t> numbers;
  for (const auto& scan : log.scans) numbers.insert(scan.reading.ranges.size());
  std::string text;
  for (const auto number : numbers) text += (text.empty() ? "" : " or ") + std::to_string(number);
  return text;
}

std::string irregularities(const CarmenLog& log, const CarmenClock& clock) {
  std::size_t gaps = 0, jumps = 0;
  double farthest = 0.0;
  for (std::size_t i = 1; i < log.scans.size(); ++i) {
    gaps += log.scans[i].stamp - log.scans[i - 1].stamp > kLongGap;
    const double way = log.scans[i - 1].odometry.between(log.scans[i].odometry).position().norm();
    jumps += way > kFarJump;
    farthest = std::max(farthest, way);
  }
  std::ostringstream text;
  text << " Irregular: " << clock.steps_back << " stamps step back, by up to "
       << static_cast<double>(clock.largest_step_back) * 1e-9 << " s; " << clock.repeated
       << " stand twice; " << gaps << " gaps over 5 s; " << jumps
       << " jumps of the odometry over 1 m.";
  if (jumps > 0) text << " The farthest: " << farthest << " m.";
  return text.str();
}

std::string leftOut(const CarmenLog& log, std::size_t odometry) {
  std::ostringstream text;
  text << " Left out: " << odometry << " odometry lines that are not between their scans";
  for (const auto& [kind, lines] : log.left_out) text << ", " << lines << " lines of " << kind;
  text << ".";
  if (log.bad_lines > 0)
    text << " Bad lines left out: " << log.bad_lines << "; the first: " << log.first_bad_line
         << ".";
  return text.str();
}

class CarmenImporter : public Importer {
 public:
  std::string name() const override { return "carmen"; }

  std::string description() const override {
    return "CARMEN log: scans of the front laser with raw odometry";
  }

  void addOptions(slam_ros::CommandLine& command) override {
    command.add("LOG", file_, "the log").required();
    command
        .add("--max-range", max_range_,
             "range [m] at and beyond which the laser saw nothing [default: what the log "
             "says, at most 80]")
        .positive();
  }

  std::string import(BagWriter& bag, Progress&) override {
    const CarmenLog log = readCarmen(file_, max_range_);
    const CarmenClock clock = makeClock(log.scans);
    addRobotName(bag, "carmen");
    const Pose2& mount = log.T_base_laser;
    addLaserMount(bag, kLaserFrame, toPose(mount.x(), mount.y(), mount.theta()));
    const auto between = odometryBetween(log, clock);
    for (const auto i : between) bag.add(kOdometryTopic, toMessage(log.odometry[i]));
    for (std::size_t i = 0; i < log.scans.size(); ++i) {
      bag.add(kOdometryTopic, odometryAt(clock.written[i], log.scans[i].odometry));
      bag.add(kScanTopic,
              slam::eval::toMessage(log.scans[i].reading, clock.written[i], kLaserFrame));
    }
    bag.addBeside(".stamps.csv", stampTable(log.scans, clock));
    std::ostringstream text;
    text << log.scans.size() << " scans (" << log.scan_kind << ") of " << beamsOf(log) << " beams, "
         << between.size() << " odometry messages between them.";
    return text.str() + irregularities(log, clock) +
           leftOut(log, log.odometry.size() - between.size());
  }

 private:
  std::string file_;
  std::optional<double> max_range_;
};

}  // namespace

std::unique_ptr<Importer> makeCarmenImporter() { return std::make_unique<CarmenImporter>(); }

}  // namespace slam::eval
