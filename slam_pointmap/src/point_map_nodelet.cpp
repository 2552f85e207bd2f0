// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>
#include <slam_msgs/Progress.h>

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>

#include "estimate_subscriber.hpp"
#include "map_feed.hpp"
#include "nodelet_config.hpp"
#include "slam_core/point_map/pcd_file.hpp"
#include "slam_core/product/product_components.hpp"
#include "slam_ros/after_load.hpp"
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

/// `scan`, `motion` and `pose` in, `points` out.
class PointMapNodelet : public nodelet::Nodelet {
 public:
  ~PointMapNodelet() override {
    // no callback may find what it needs gone
    start_.reset();
    if (laser_) laser_->stop();
    estimates_.reset();
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
    feed_.configure(settings, [this](const std::string& topic, const slam::Status& status) {
      diagnostics_->report(topic, status);
    });
    config_ = slam_ros::parametersFromRos<NodeletConfig>(getPrivateNodeHandle());
    if (!config_.output_dir.empty()) std::filesystem::create_directories(config_.output_dir);
    diagnostics_.emplace(
        handle, getPrivateNodeHandle(), getName(),
        slam_ros::Diagnostics::Sources{[this] { return feed_.counters(); },
                                       [this] { return waiting(); }, [this] { return figures(); }});
    publisher_.emplace(handle, feed_.map(), slam_ros::frameId(frames.map), config_.points_rate);
    handle.resolveName(topics_.motion);  // throws now what subscribing would throw later
    connectLaser(handle, slam_ros::frameId(frames.base), !laser.sensor_pose.empty());
    start_.emplace([this, handle] { subscribe(handle); });
  }

  void connectLaser(ros::NodeHandle handle, const std::string& base, bool has_mount) {
    const auto take_sweep = [this](const slam::LaserSweep& sweep) {
      feed_.takeSweep(sweep, topics_.scan);
      publish();
    };
    const auto take_mount = [this](const slam::LaserMount& mount) {
      feed_.takeMount(mount, topics_.scan);
      publish();
    };
    laser_.emplace(handle, slam_ros::LaserSubscriber::Options{topics_.scan, base, has_mount},
                   slam_ros::LaserInput::Sinks{take_sweep, take_mount});
  }

  void subscribe(ros::NodeHandle handle) {
    estimates_.emplace(
        handle, topics_.motion,
        EstimateSubscriber::Sinks{[this](const auto& motion) { take(motion, "motion"); },
                                  [this](const auto& pose) { take(pose, "pose"); },
                                  [this] { feed_.reset(); }});
    // last: who sees it may send
    progress_ = handle.advertise<slam_msgs::Progress>("pointmap/progress", slam_ros::kQueue);
    tells_progress_ = true;
  }

  template <class Input>
  void take(const Input& input, const std::string& topic) {
    feed_.take(input, topic);
    publish();
  }

  void publish() {
    publisher_->update();
    if (tells_progress_ && progress_.getNumSubscribers() > 0) progress_.publish(feed_.progress());
  }

  void save() {
    if (config_.output_dir.empty() || !diagnostics_) return;
    try {
      slam::point_map::savePcd(config_.output_dir + "/points.pcd", feed_.map().points());
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM(error.what());
    }
  }

  std::string waiting() const {
    if (const auto wait = laser_ ? laser_->waiting() : ""; !wait.empty()) return wait;
    if (!feed_.map().lastMotion()) return "waiting for motion on " + topics_.motion;
    return feed_.map().lastPose() ? "" : "waiting for the back-end's pose";
  }

  slam_ros::Diagnostics::Values figures() const {
    return {{"points", std::to_string(feed_.map().points().size())}};
  }

  NodeletConfig config_;
  slam_ros::TopicsConfig topics_;
  MapFeed feed_;
  std::optional<slam_ros::Diagnostics> diagnostics_;
  std::optional<slam_ros::PointsPublisher> publisher_;
  std::optional<slam_ros::LaserSubscriber> laser_;
  ros::Publisher progress_;
  std::atomic<bool> tells_progress_ = false;  ///< scans come from another thread before it is there
  std::optional<EstimateSubscriber> estimates_;
  std::optional<slam_ros::AfterLoad> start_;
};

}  // namespace slam_pointmap

PLUGINLIB_EXPORT_CLASS(slam_pointmap::PointMapNodelet, nodelet::Nodelet)
