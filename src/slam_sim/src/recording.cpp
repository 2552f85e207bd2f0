// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "recording.hpp"

#include <ros/message_traits.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <utility>

#include "ordered_tasks.hpp"
#include "sensor_messages.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_sim/base_controller.hpp"

namespace slam::sim {
namespace {

constexpr double kRest = 1.0;  // before and after the drive [s]
constexpr Stamp kStart = stampFromNanoseconds(1'600'000'000'000'000'000);

ros::Time stampOf(Duration time) { return slam_ros::toRos(kStart + time); }

}  // namespace

std::vector<std::string> streamNames(const RobotModel& robot) {
  std::vector<std::string> names = {"odom", "scan"};
  if (robot.rear_laser) names.push_back("rear_scan");
  if (robot.imu) names.push_back("imu");
  if (robot.commands) names.push_back("commands");
  for (const auto& camera : robot.cameras) names.push_back(camera.name);
  return names;
}

Recording::Recording(World world, RobotModel robot, RecordingOptions options)
    : world_(std::move(world)),
      robot_(std::move(robot)),
      options_(std::move(options)),
      drive_(world_.path, robot_),
      sensors_(world_, robot_, options_.seed),
      odometer_(WheelEncoders(robot_.wheels, robot_.noise)),
      gyro_(robot_.imu.value_or(ImuModel())),
      duration_(drive_.duration() + 2.0 * kRest) {
  requireClearance(drive_, sensors_.plan(), robot_.radius);
  if (options_.duration > 0.0) duration_ = std::min(duration_, options_.duration);
  scheduleAll();
}

void Recording::scheduleAll() {
  schedule("odom", robot_.odometry, Kind::kOdometry);
  schedule("scan", robot_.laser.pace, Kind::kScan);
  if (robot_.rear_laser) schedule("rear_scan", robot_.rear_laser->pace, Kind::kRearScan);
  if (robot_.imu) schedule("imu", robot_.imu->pace, Kind::kImu);
  if (robot_.commands) schedule("commands", robot_.commands->pace, Kind::kCommand);
  for (std::size_t i = 0; i < robot_.cameras.size(); ++i)
    schedule(robot_.cameras[i].name, robot_.cameras[i].pace, Kind::kImage, i);
  std::stable_sort(events_.begin(), events_.end(),
                   [](const Event& a, const Event& b) { return a.time < b.time; });
}

void Recording::schedule(const std::string& stream, const Pace& pace, Kind kind,
                         std::size_t camera) {
  const auto& wanted = options_.streams;
  if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), stream) == wanted.end()) return;
  if (kind == Kind::kImage) sensors_.openCamera(camera);
  for (std::uint64_t i = 0; seconds(timeOf(pace, i)) <= duration_; ++i)
    events_.push_back({timeOf(pace, i), kind, camera, i});
}

Pose2 Recording::truth(double time) const { return drive_.pose(time - kRest); }

void Recording::write(const std::string& path, Progress& progress, const std::atomic<bool>& stop) {
  slam_ros::BagFile bag(path);
  writeFirst(bag);
  writeEvents(bag, progress, stop);
  bag.complete();
}

template <class Message>
void Recording::put(slam_ros::BagFile& bag, const std::string& topic, Message message) {
  message.header.seq = sequences_[topic]++;
  bag.write(topic, message.header.stamp, message);
  ++messages_;
}

void Recording::writeFirst(slam_ros::BagFile& bag) {
  std_msgs::String name;
  name.data = robot_.name;
  bag.write("/robot", stampOf(-Duration(10)), name);
  put(bag, "/ground_truth/landmarks", truthMapMessage(world_, stampOf(-Duration(9))));
  bag.write("/tf_static", stampOf(-Duration(8)), mountMessage(robot_, stampOf(-Duration(8))));
  messages_ += 2;
  for (const auto& camera : robot_.cameras)
    put(bag, "/" + camera.name + "/camera_info", cameraInfoMessage(camera, stampOf(-Duration(1))));
}

void Recording::writeEvents(slam_ros::BagFile& bag, Progress& progress,
                            const std::atomic<bool>& stop) {
  std::vector<OrderedTasks<sensor_msgs::CompressedImage>::Task> tasks;
  for (const auto& event : events_)
    if (event.kind == Kind::kImage) tasks.push_back([this, &event] { return takeImage(event); });
  OrderedTasks<sensor_msgs::CompressedImage> images(std::move(tasks), options_.threads);
  progress.begin("simulating", events_.size());
  for (std::size_t i = 0; i < events_.size(); ++i) {
    if (stop) throw Interrupted("interrupted; no bag was left");
    const auto& event = events_[i];
    if (event.kind == Kind::kOdometry) writeOdometry(bag, event);
    if (event.kind == Kind::kScan) writeScan(bag, event);
    if (event.kind == Kind::kRearScan) writeRearScan(bag, event);
    if (event.kind == Kind::kImu) writeImu(bag, event);
    if (event.kind == Kind::kCommand) writeCommand(bag, event);
    if (event.kind == Kind::kImage) writeImage(bag, event, images.next());
    progress.update(i + 1);
  }
  progress.end();
}

void Recording::writeOdometry(slam_ros::BagFile& bag, const Event& event) {
  const auto stamp = stampOf(event.time);
  const auto pose = truth(seconds(event.time));
  auto noise = sensors_.wheelNoise(event.reading);
  odometer_.moveTo(pose, noise);
  const auto odometry = odometryMessage(robot_, stamp, odometer_.pose(),
                                        odometer_.increment() * robot_.odometry.rate);
  put(bag, "/ground_truth/pose", truthMessage(stamp, pose));
  put(bag, "/odom", odometry);
  bag.write("/tf", stamp, transformMessage(odometry));
  ++messages_;
}

void Recording::writeScan(slam_ros::BagFile& bag, const Event& event) {
  put(bag, "/scan",
      scanMessage(robot_.laser, stampOf(event.time),
                  sensors_.scan(truth(seconds(event.time)), event.reading)));
}

void Recording::writeRearScan(slam_ros::BagFile& bag, const Event& event) {
  put(bag, "/rear_scan",
      scanMessage(*robot_.rear_laser, stampOf(event.time),
                  sensors_.rearScan(truth(seconds(event.time)), event.reading)));
}

void Recording::writeImu(slam_ros::BagFile& bag, const Event& event) {
  auto noise = sensors_.imuNoise(event.reading);
  const double now = seconds(event.time);
  const double rate = turnRate([&](double offset) { return truth(now + offset); });
  put(bag, "/imu", imuMessage(*robot_.imu, stampOf(event.time), gyro_.measure(rate, noise)));
}

void Recording::writeCommand(slam_ros::BagFile& bag, const Event& event) {
  auto noise = sensors_.commandNoise(event.reading);
  const double now = seconds(event.time);
  const auto path = [this, now](double offset) { return truth(now + offset); };
  put(bag, "/cmd_vel_out",
      commandMessage(robot_, stampOf(event.time), commandFor(path, *robot_.commands, noise)));
}

sensor_msgs::CompressedImage Recording::takeImage(const Event& event) const {
  const double middle = seconds(event.time);
  const auto path = [this, middle](double offset) { return truth(middle + offset); };
  return compressedMessage(robot_.cameras[event.camera], stampOf(event.time),
                           sensors_.image(event.camera, path, event.reading, middle));
}

void Recording::writeImage(slam_ros::BagFile& bag, const Event& event,
                           sensor_msgs::CompressedImage image) {
  const auto& camera = robot_.cameras[event.camera];
  put(bag, "/" + camera.name + "/camera_info", cameraInfoMessage(camera, stampOf(event.time)));
  put(bag, "/" + camera.name + "/image_raw/compressed", std::move(image));
}

}  // namespace slam::sim
