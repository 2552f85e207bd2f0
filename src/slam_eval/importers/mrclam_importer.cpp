// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <slam_msgs/LandmarkObservationArray.h>

#include <sstream>

#include "importer.hpp"
#include "messages.hpp"
#include "mrclam_log.hpp"

namespace slam::eval {

namespace {

slam_msgs::LandmarkObservationArray toMessage(const MrclamLog::Sighting& sighting,
                                              std::uint64_t sequence) {
  slam_msgs::LandmarkObservationArray message;
  message.header.stamp = toTime(sighting.stamp);
  // The data set refers its readings to the robot's centre: the sensor pose is the identity.
  message.header.frame_id = "base_link";
  message.sequence = sequence;
  for (const MrclamLog::Reading& reading : sighting.readings) {
    slam_msgs::LandmarkObservation observation;
    observation.id = reading.landmark;
    observation.range = reading.range;
    observation.bearing = reading.bearing;
    observation.covariance[0] = -1.0;
    message.observations.push_back(observation);
  }
  return message;
}

nav_msgs::Odometry toMessage(const MrclamLog::Velocity& velocity) {
  nav_msgs::Odometry message = makeOdometry(velocity.stamp);
  message.pose.covariance[0] = -1.0;
  message.twist.twist.linear.x = velocity.forward;
  message.twist.twist.angular.z = velocity.angular;
  return message;
}

slam_msgs::LandmarkMap toMessage(const std::vector<MrclamLog::Landmark>& landmarks) {
  slam_msgs::LandmarkMap map = makeTruthMap();
  for (const MrclamLog::Landmark& landmark : landmarks) {
    map.landmarks.push_back(makeTruthLandmark(landmark.id, landmark.x, landmark.y));
  }
  return map;
}

std::string summary(const MrclamLog& log) {
  std::size_t readings = 0;
  for (const MrclamLog::Sighting& sighting : log.sightings) readings += sighting.readings.size();
  std::ostringstream text;
  text << log.odometry.size() << " odometry messages, " << log.sightings.size()
       << " observation arrays with " << readings << " readings, " << log.truth.size()
       << " true poses, " << log.landmarks.size()
       << " true landmarks. Dropped: " << log.robot_readings << " readings of other robots, "
       << log.unknown_readings << " of unknown barcodes, " << log.replaced_odometry
       << " odometry rows replaced by a later one of the same stamp. Sorted: " << log.out_of_order
       << " rows out of order.";
  return text.str();
}

class MrclamImporter : public Importer {
 public:
  std::string name() const override { return "mrclam"; }

  std::string description() const override {
    return "UTIAS MRCLAM: velocities, landmark readings and truth of one robot";
  }

  void addOptions(slam_ros::CommandLine& command) override {
    command.add("DIR", folder_, "folder of the data set").required();
    command.add("--robot", robot_, "number of the robot").required();
  }

  std::string import(BagWriter& bag, Progress&) override {
    const MrclamLog log = readMrclam(folder_, robot_);
    addRobotName(bag, "mrclam");
    bag.addFirstStamped(kTruthLandmarksTopic, toMessage(log.landmarks));
    for (const auto& velocity : log.odometry) bag.add(kOdometryTopic, toMessage(velocity));
    for (const auto& pose : log.truth) {
      bag.add(kTruthPoseTopic, makeTruthPose(pose.stamp, pose.x, pose.y, pose.theta));
    }
    std::uint64_t sequence = 0;
    for (const auto& sighting : log.sightings) {
      bag.add(kObservationsTopic, toMessage(sighting, sequence++));
    }
    return summary(log);
  }

 private:
  std::string folder_;
  int robot_ = 0;
};

}  // namespace

std::unique_ptr<Importer> makeMrclamImporter() { return std::make_unique<MrclamImporter>(); }

}  // namespace slam::eval
