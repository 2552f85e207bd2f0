// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <slam_msgs/LandmarkObservationArray.h>
#include <slam_msgs/Motion.h>

#include <algorithm>
#include <sstream>

#include "circles_log.hpp"
#include "importer.hpp"
#include "messages.hpp"
#include "slam_core/geometry/pose2.hpp"

namespace slam::eval {

namespace {

constexpr char kMotionTopic[] = "/motion";

/// The log has no clock: step k, counted from 1, ends at k seconds. @return [ns]
std::int64_t stampOf(std::size_t step) { return static_cast<std::int64_t>(step) * 1000000000; }

geometry_msgs::Pose2D toMessage(const Pose2& pose) {
  geometry_msgs::Pose2D message;
  message.x = pose.x();
  message.y = pose.y();
  message.theta = pose.theta();
  return message;
}

slam_msgs::Motion motionOf(const CirclesLog::Step& step, std::size_t number, Pose2& odometry) {
  slam_msgs::Motion message;
  message.header.stamp = message.end = toTime(stampOf(number));
  message.header.frame_id = "odom";
  message.child_frame_id = "base_link";
  message.sequence = number - 1;
  message.start = toTime(stampOf(number - 1));
  const auto increment = Pose2::fromVector(step.displacement);
  message.increment = toMessage(increment);
  for (int i = 0; i < 9; ++i)
    message.covariance[static_cast<std::size_t>(i)] = step.covariance(i / 3, i % 3);
  message.odometry_start = toMessage(odometry);
  odometry = odometry * increment;
  message.odometry_end = toMessage(odometry);
  return message;
}

slam_msgs::LandmarkObservationArray sightOf(const CirclesLog::Step& step, std::size_t number) {
  slam_msgs::LandmarkObservationArray message;
  message.header.stamp = toTime(stampOf(number));
  // The data set refers its readings to the robot's centre: the sensor pose is the identity.
  message.header.frame_id = "base_link";
  message.sequence = number - 1;
  for (const auto& reading : step.readings) {
    slam_msgs::LandmarkObservation observation;
    observation.id = reading.id;
    observation.range = reading.range;
    observation.bearing = reading.bearing;
    for (int i = 0; i < 4; ++i)
      observation.covariance[static_cast<std::size_t>(i)] = reading.covariance(i / 2, i % 2);
    message.observations.push_back(observation);
  }
  return message;
}

std::string summary(const CirclesLog& log) {
  std::size_t readings = 0;
  double way = 0.0;
  for (const auto& step : log.steps) {
    readings += step.readings.size();
    way += step.displacement.head<2>().norm();
  }
  std::ostringstream text;
  text.precision(4);
  text << log.steps.size() << " steps over " << way << " m, " << readings << " readings, "
       << log.unidentified << " of them without an id, " << log.several_ids
       << " with several ids of which the first counts.";
  return text.str();
}

class CirclesImporter : public Importer {
 public:
  std::string name() const override { return "circles"; }

  std::string description() const override {
    return "DLR circles: odometry steps and identified landmarks with their covariances";
  }

  void addOptions(slam_ros::CommandLine& command) override {
    command.add("FILE", file_, "the data set's map.circles").required();
  }

  std::string import(BagWriter& bag, Progress&) override {
    const CirclesLog log = readCircles(file_);
    addRobotName(bag, "circles");
    Pose2 odometry;
    for (std::size_t number = 1; number <= log.steps.size(); ++number) {
      const auto& step = log.steps[number - 1];
      bag.add(kMotionTopic, motionOf(step, number, odometry));
      bag.add(kObservationsTopic, sightOf(step, number));
    }
    return summary(log);
  }

 private:
  std::string file_;
};

}  // namespace

std::unique_ptr<Importer> makeCirclesImporter() { return std::make_unique<CirclesImporter>(); }

}  // namespace slam::eval
