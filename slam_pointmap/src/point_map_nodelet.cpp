// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nodelet/nodelet.h>
#include <slam_msgs/Motion.h>
#include <slam_msgs/Progress.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>
#include <vector>

#include "slam_core/laser/scan_gate.hpp"
#include "slam_core/point_map/pcd_file.hpp"
#include "slam_core/point_map/point_map.hpp"
#include "slam_core/product/product_components.hpp"
#include "slam_ros/after_load.hpp"
#include "slam_ros/clock_watch.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/diagnostics.hpp"
#include "slam_ros/laser_subscriber.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/points_publisher.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/settings_from_ros.hpp"
#include "slam_ros/topics_config.hpp"

namespace slam_pointmap {
namespace {

using slam_ros::kQueue;

slam::point_map::FilterPose fromMsg(const geometry_msgs::PoseWithCovarianceStamped& message) {
  const auto& pose = message.pose.pose;
  return {slam_ros::fromRos(message.header.stamp), pose.position.x, pose.position.y,
          pose.orientation.z, pose.orientation.w};
}

}  // namespace

struct NodeletConfig {
  static constexpr const char* kSection = "";

  std::string output_dir;
  double points_rate = 1.0;

  void describe(slam::Fields& fields) {
    fields.add("output_dir", &output_dir, "folder that gets a points.pcd at the end");
    fields.add("points_rate", &points_rate, "of the points, at most")
        .unit("1/s of stamps")
        .in(slam::Range::above(0));
  }
};

/// `scan`, `motion` and `pose` in, `points` out.
class PointMapNodelet : public nodelet::Nodelet {
 public:
  ~PointMapNodelet() override {
    // no callback may find what it needs gone
    start_.reset();
    if (laser_) laser_->stop();
    for (auto& subscriber : subscribers_) subscriber.shutdown();
    publisher_.reset();
    save();
    diagnostics_.reset();
  }

 private:
  void onInit() override {
    slam_ros::reportFailure(getName(), [this] { initialise(getNodeHandle()); });
  }

  void initialise(ros::NodeHandle handle) {
    auto settings = slam_ros::settingsFromRos(handle);
    topics_ = settings.read<slam_ros::TopicsConfig>();
    const auto frames = settings.read<slam::FramesConfig>();
    const auto laser = settings.read<slam::LaserConfig>();
    gate_.configure(laser);
    map_.configure(settings);
    config_ = slam_ros::parametersFromRos<NodeletConfig>(getPrivateNodeHandle());
    if (!config_.output_dir.empty()) std::filesystem::create_directories(config_.output_dir);
    diagnostics_.emplace(
        handle, getPrivateNodeHandle(), getName(),
        slam_ros::Diagnostics::Sources{[this] { return counters(); }, [this] { return waiting(); },
                                       [this] { return figures(); }});
    publisher_.emplace(handle, map_, slam_ros::frameId(frames.map), config_.points_rate);
    handle.resolveName(topics_.motion);  // throws now what subscribing would throw later
    connectLaser(handle, slam_ros::frameId(frames.base), !laser.sensor_pose.empty());
    start_.emplace([this, handle] { subscribe(handle); });
  }

  void connectLaser(ros::NodeHandle handle, const std::string& base, bool has_mount) {
    const auto take = [this](const auto& input) {
      checkClock();
      gate_.set(input);
      takeScans();
    };
    const auto take_scan = [this, take](const slam::LaserSweep& sweep) {
      last_scan_ = sweep.stamp;
      take(sweep);
    };
    laser_.emplace(handle, slam_ros::LaserSubscriber::Options{topics_.scan, base, has_mount},
                   slam_ros::LaserInput::Sinks{take_scan, take});
  }

  void subscribe(ros::NodeHandle handle) {
    subscribers_ = {handle.subscribe(topics_.motion, kQueue, &PointMapNodelet::onMotion, this),
                    handle.subscribe("pose", kQueue, &PointMapNodelet::onPose, this),
                    handle.subscribe("progress", kQueue, &PointMapNodelet::onProgress, this)};
    // last: who sees it may send
    progress_ = handle.advertise<slam_msgs::Progress>("pointmap/progress", kQueue);
  }

  void onMotion(const slam_msgs::Motion& message) { take(slam_ros::fromMsg(message), "motion"); }

  void onPose(const geometry_msgs::PoseWithCovarianceStamped& message) {
    take(fromMsg(message), "pose");
  }

  /// The back-end was reset: its poses are those of another map.
  void onProgress(const slam_msgs::Progress& message) {
    if (message.resets != resets_) reset();
    resets_ = message.resets;
  }

  template <class Input>
  void take(const Input& input, const std::string& topic) {
    checkClock();
    map_.set(input);
    update(topic);
  }

  void takeScans() {
    const auto& scan = gate_.scan();
    do {
      diagnostics_->report(topics_.scan, gate_.next());
      if (scan) map_.set(*scan);
    } while (scan);
    update(topics_.scan);
  }

  void update(const std::string& topic) {
    do diagnostics_->report(topic, map_.execute());
    while (map_.isBusy());
    publisher_->update();
    publishProgress();
  }

  void publishProgress() {
    if (!progress_ || progress_.getNumSubscribers() == 0) return;
    auto message = boost::make_shared<slam_msgs::Progress>();
    message->motion = slam_ros::toRos(map_.lastMotion().value_or(slam::Stamp()));
    message->step = slam_ros::toRos(map_.lastPose().value_or(slam::Stamp()));
    message->scans = slam_ros::toRos(last_scan_);
    progress_.publish(message);
  }

  void checkClock() {
    if (clock_.hasJumpedBack()) reset();
  }

  void reset() {
    gate_.reset();
    map_.reset();
  }

  void save() {
    if (config_.output_dir.empty() || !diagnostics_) return;
    try {
      slam::point_map::savePcd(config_.output_dir + "/points.pcd", map_.points());
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM(error.what());
    }
  }

  slam::Counters counters() const {
    auto all = map_.counters();
    for (const auto& [reason, count] : gate_.counters().all()) all.add("laser_" + reason, count);
    return all;
  }

  std::string waiting() const {
    if (const auto wait = laser_ ? laser_->waiting() : ""; !wait.empty()) return wait;
    if (!map_.lastMotion()) return "waiting for motion on " + topics_.motion;
    return map_.lastPose() ? "" : "waiting for the back-end's pose";
  }

  slam_ros::Diagnostics::Values figures() const {
    return {{"points", std::to_string(map_.points().size())}};
  }

  NodeletConfig config_;
  slam_ros::TopicsConfig topics_;
  slam::ScanGate gate_;
  slam::point_map::PointMap map_;
  slam_ros::ClockWatch clock_;
  slam::Stamp last_scan_;  ///< that has come, whether or not it could be used
  std::uint32_t resets_ = 0;
  std::optional<slam_ros::Diagnostics> diagnostics_;
  std::optional<slam_ros::PointsPublisher> publisher_;
  std::optional<slam_ros::LaserSubscriber> laser_;
  ros::Publisher progress_;
  std::vector<ros::Subscriber> subscribers_;
  std::optional<slam_ros::AfterLoad> start_;
};

}  // namespace slam_pointmap

PLUGINLIB_EXPORT_CLASS(slam_pointmap::PointMapNodelet, nodelet::Nodelet)
