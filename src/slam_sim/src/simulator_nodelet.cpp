// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <geometry_msgs/Twist.h>
#include <ros/package.h>
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <vector>

#include "camera_publisher.hpp"
#include "sensor_messages.hpp"
#include "slam_ros/after_load.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/product_files.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_sim/base_controller.hpp"
#include "slam_sim/gyroscope.hpp"
#include "slam_sim/live_robot.hpp"
#include "slam_sim/world_file.hpp"

namespace slam::sim {
namespace {

constexpr std::uint32_t kQueue = 50;

struct NodeletConfig {
  static constexpr const char* kSection = "";

  std::string world = "office", robot = "segway", drive = "path";
  std::uint64_t seed = 1;

  void describe(slam::Fields& fields) {
    fields.add("world", &world, "name or file of the world");
    fields.add("robot", &robot, "name or file of the simulated robot");
    fields
        .add("drive", &drive,
             "path: once somebody listens to a sensor it follows the world's path, until a cmd_vel "
             "comes; cmd_vel: it waits for one")
        .oneOf({"path", "cmd_vel"});
    fields.add("seed", &seed, "of all noise");
  }
};

std::string fileOf(const std::string& folder, const std::string& kind, const std::string& name) {
  return slam_ros::findConfigFile(ros::package::getPath("slam_sim") + "/" + folder, kind, name);
}

}  // namespace

/// The simulated robot in real time: `cmd_vel` in; sensors, transforms and truth out.
class SimulatorNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    slam_ros::reportFailure(getName(), [this] { initialise(); });
  }

  void initialise() {
    const auto config = slam_ros::parametersFromRos<NodeletConfig>(getPrivateNodeHandle());
    const auto world = readWorldFile(fileOf("worlds", "world", config.world));
    model_ = readRobotFile(fileOf("robots", "simulated robot", config.robot));
    if (model_.imu) gyro_ = Gyroscope(*model_.imu);
    robot_ = std::make_unique<LiveRobot>(world, model_, config.seed, config.drive == "path");
    waits_for_listeners_ = config.drive == "path";
    announce(world);
    advertise();
    if (waits_for_listeners_)
      NODELET_INFO(
          "the robot drives once somebody listens to odom, scan or an image: start slam.launch in "
          "another terminal");
    startTimers();
    start_obeying_.emplace([this, handle = getNodeHandle()]() mutable {
      cmd_vel_ = handle.subscribe("cmd_vel", kQueue, &SimulatorNodelet::onCommand, this);
    });
    if (ros::Time::isSimTime())
      NODELET_WARN(
          "/use_sim_time is set: the robot stands still until somebody publishes /clock; for real "
          "time: rosparam set /use_sim_time false");
  }

  /// What is said once.
  void announce(const World& world) {
    auto handle = getNodeHandle();
    name_ = handle.advertise<std_msgs::String>("robot", 1, true);
    std_msgs::String name;
    name.data = model_.name;
    name_.publish(name);
    landmarks_ = handle.advertise<slam_msgs::LandmarkMap>("ground_truth/landmarks", 1, true);
    landmarks_.publish(truthMapMessage(world, ros::Time::now()));
    mounts_.sendTransform(mountMessage(model_, ros::Time::now()).transforms);
  }

  void advertise() {
    auto handle = getNodeHandle();
    odom_ = handle.advertise<nav_msgs::Odometry>("odom", kQueue);
    truth_ = handle.advertise<geometry_msgs::PoseStamped>("ground_truth/pose", kQueue);
    scan_ = handle.advertise<sensor_msgs::LaserScan>("scan", kQueue);
    if (model_.rear_laser)
      rear_scan_ = handle.advertise<sensor_msgs::LaserScan>("rear_scan", kQueue);
    if (model_.imu) imu_ = handle.advertise<sensor_msgs::Imu>("imu", kQueue);
    if (model_.commands)
      commands_ = handle.advertise<geometry_msgs::TwistStamped>("cmd_vel_out", kQueue);
    for (std::size_t i = 0; i < model_.cameras.size(); ++i) {
      robot_->sensors().openCamera(i);
      cameras_.push_back(
          std::make_unique<CameraPublisher>(getMTNodeHandle(), model_.cameras[i], i));
    }
  }

  void startTimers() {
    auto handle = getNodeHandle();
    timers_.push_back(handle.createTimer(ros::Duration(1.0 / model_.odometry.rate),
                                         &SimulatorNodelet::onOdometry, this));
    timers_.push_back(handle.createTimer(ros::Duration(1.0 / model_.laser.pace.rate),
                                         &SimulatorNodelet::onScan, this));
    if (model_.rear_laser)
      timers_.push_back(handle.createTimer(ros::Duration(1.0 / model_.rear_laser->pace.rate),
                                           &SimulatorNodelet::onRearScan, this));
    if (model_.imu)
      timers_.push_back(handle.createTimer(ros::Duration(1.0 / model_.imu->pace.rate),
                                           &SimulatorNodelet::onImu, this));
    if (model_.commands)
      timers_.push_back(handle.createTimer(ros::Duration(1.0 / model_.commands->pace.rate),
                                           &SimulatorNodelet::onController, this));
    for (std::size_t i = 0; i < cameras_.size(); ++i)
      timers_.push_back(
          getMTNodeHandle().createTimer(ros::Duration(1.0 / model_.cameras[i].pace.rate),
                                        [this, i](const ros::TimerEvent&) { onCamera(i); }));
  }

  bool isHeard() const {
    return odom_.getNumSubscribers() > 0 || scan_.getNumSubscribers() > 0 ||
           std::any_of(cameras_.begin(), cameras_.end(),
                       [](const auto& camera) { return camera->isWanted(); });
  }

  /// The start is the first time that anybody asks after the robot need not wait any more.
  double seconds(const ros::Time& time) {
    if (start_.isZero()) {
      if (waits_for_listeners_ && !isHeard()) return 0.0;
      start_ = time;
    }
    return (time - start_).toSec();
  }

  void onCommand(const geometry_msgs::Twist& twist) {
    const std::lock_guard lock(mutex_);
    waits_for_listeners_ = false;
    robot_->command({twist.linear.x, twist.linear.y, twist.angular.z});
  }

  void onOdometry(const ros::TimerEvent&) {
    const auto stamp = ros::Time::now();
    const std::lock_guard lock(mutex_);
    if (!robot_->advance(seconds(stamp))) return;
    const auto odometry =
        odometryMessage(model_, stamp, robot_->odometer().pose(), robot_->measuredVelocity());
    odom_.publish(odometry);
    transforms_.sendTransform(transformMessage(odometry).transforms);
    truth_.publish(truthMessage(stamp, robot_->pose(seconds(stamp))));
    if (robot_->touches())
      ROS_WARN_THROTTLE_NAMED(2.0, "slam_sim", "the robot touches a wall or furniture");
  }

  void onScan(const ros::TimerEvent&) {
    if (scan_.getNumSubscribers() == 0) return;
    const auto stamp = ros::Time::now();
    const auto pose = poseAround(stamp)(0.0);
    scan_.publish(scanMessage(model_.laser, stamp, robot_->sensors().scan(pose, scans_++)));
  }

  void onRearScan(const ros::TimerEvent&) {
    if (rear_scan_.getNumSubscribers() == 0) return;
    const auto stamp = ros::Time::now();
    const auto pose = poseAround(stamp)(0.0);
    rear_scan_.publish(
        scanMessage(*model_.rear_laser, stamp, robot_->sensors().rearScan(pose, rear_scans_++)));
  }

  void onImu(const ros::TimerEvent&) {
    const auto stamp = ros::Time::now();
    auto noise = robot_->sensors().imuNoise(imu_readings_++);
    const Eigen::Vector3d rate = gyro_.measure(turnRate(poseAround(stamp)), noise);
    imu_.publish(imuMessage(*model_.imu, stamp, rate));
  }

  void onController(const ros::TimerEvent&) {
    const auto stamp = ros::Time::now();
    auto noise = robot_->sensors().commandNoise(commands_sent_++);
    commands_.publish(
        commandMessage(model_, stamp, commandFor(poseAround(stamp), *model_.commands, noise)));
  }

  void onCamera(std::size_t camera) {
    const auto stamp = ros::Time::now();
    const auto path = poseAround(stamp);
    cameras_[camera]->publish(stamp, robot_->sensors(), path, timeOf(stamp));
  }

  double timeOf(const ros::Time& stamp) {
    const std::lock_guard lock(mutex_);
    return seconds(stamp);
  }

  /// A copy of the motion at `stamp`, so that nobody waits for a picture.
  BasePath poseAround(const ros::Time& stamp) {
    const std::lock_guard lock(mutex_);
    const double time = seconds(stamp);
    constexpr double kStep = 0.005;  // [s]
    const Pose2 before = robot_->pose(time - kStep), now = robot_->pose(time);
    const Eigen::Vector3d velocity = before.between(now).log() / kStep;
    return [now, velocity](double offset) { return now * Pose2::exp(velocity * offset); };
  }

  RobotModel model_;
  std::unique_ptr<LiveRobot> robot_;
  std::vector<std::unique_ptr<CameraPublisher>> cameras_;
  std::mutex mutex_;  ///< of robot_'s motion and the next two
  bool waits_for_listeners_ = false;
  ros::Time start_;
  std::uint64_t scans_ = 0, rear_scans_ = 0, imu_readings_ = 0, commands_sent_ = 0;
  Gyroscope gyro_;
  tf2_ros::TransformBroadcaster transforms_;
  tf2_ros::StaticTransformBroadcaster mounts_;
  ros::Publisher name_, landmarks_, odom_, truth_, scan_, rear_scan_, imu_, commands_;
  ros::Subscriber cmd_vel_;  // with what follows last: no callback may find the others gone
  std::vector<ros::Timer> timers_;
  std::optional<slam_ros::AfterLoad> start_obeying_;
};

}  // namespace slam::sim

PLUGINLIB_EXPORT_CLASS(slam::sim::SimulatorNodelet, nodelet::Nodelet)
