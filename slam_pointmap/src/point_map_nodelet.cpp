// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>
#include <slam_msgs/Progress.h>

#include <atomic>
#include <filesystem>
#include <map>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>

#include "nodelet_config.hpp"
#include "slam_core/common/folder_lock.hpp"
#include "slam_core/laser/laser_sweep.hpp"
#include "slam_core/point_map/point_map.hpp"
#include "slam_ros/after_load.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/part_node.hpp"
#include "slam_ros/points_publisher.hpp"
#include "slam_ros/progress_message.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/report_failure.hpp"

namespace slam_pointmap {

/// `scan`, `motion` and `pose` in, `points` out.
class PointMapNodelet : public nodelet::Nodelet {
 public:
  ~PointMapNodelet() override {
    // no callback may find what it needs gone
    start_.reset();
    reset_.shutdown();
    if (node_) node_->stop();
    publisher_.reset();
    save();
  }

 private:
  void onInit() override {
    slam_ros::reportFailure(getName(), [this] { initialise(getNodeHandle()); });
  }

  void initialise(ros::NodeHandle handle) {
    config_ = slam_ros::parametersFromRos<NodeletConfig>(getPrivateNodeHandle());
    if (!config_.output_dir.empty()) {
      std::filesystem::create_directories(config_.output_dir);
      slam::FolderLock::requireNoOtherProcess(config_.output_dir);  // the back-end locks it
    }
    node_.emplace(slam_ros::PartNode::Handles{handle, getPrivateNodeHandle(), getName()},
                  slam::ProductPart{slam::ProductPart::Extent::kModule, "pointmap"},
                  slam_ros::InputOptions());
    map_ = dynamic_cast<const slam::point_map::PointMap*>(
        node_->part().components().modules.at("pointmap").get());
    publisher_.emplace(*map_, slam_ros::ModulePublisher::Context{
                                  handle, slam_ros::frameId(node_->part().components().frames.map),
                                  config_.points_rate});
    node_->on_taken = [this](const auto& port, slam::Kind kind, const void* value) {
      if (kind == slam::kindOf<slam::LaserSweep>())
        last_scans_[port] = static_cast<const slam::LaserSweep*>(value)->stamp;
      publish();
    };
    start_.emplace([this, handle] { subscribe(handle); });
  }

  void subscribe(ros::NodeHandle handle) {
    reset_ = slam_ros::subscribeThrough<slam_msgs::Progress>(
        node_->pass(), handle, "progress", slam_ros::kQueue,
        [this](const auto& progress) { onProgress(progress); });
    // last: who sees it may send
    progress_ = handle.advertise<slam_msgs::Progress>("pointmap/progress", slam_ros::kQueue);
    tells_progress_ = true;
  }

  /// The back-end was reset or has loaded a map: its poses are those of another map.
  void onProgress(const slam_msgs::Progress& message) {
    if (message.resets != resets_) node_->reset();
    resets_ = message.resets;
  }

  void publish() {
    publisher_->update();
    if (tells_progress_ && progress_.getNumSubscribers() > 0) progress_.publish(progress());
  }

  slam_msgs::Progress progress() const {
    slam_msgs::Progress message;
    message.motion = slam_ros::toRos(map_->lastMotion().value_or(slam::Stamp()));
    message.step = slam_ros::toRos(map_->lastPose().value_or(slam::Stamp()));
    for (const auto& [port, stamp] : last_scans_) slam_ros::setProgress(message, port, stamp);
    return message;
  }

  void save() {
    if (config_.output_dir.empty() || !map_) return;
    try {
      map_->save(config_.output_dir);
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM(error.what());
    }
  }

  NodeletConfig config_;
  std::optional<slam_ros::PartNode> node_;
  const slam::point_map::PointMap* map_ = nullptr;  ///< of the part
  /// Each input has here the stamp of its last scan, whether or not that could be used.
  std::map<std::string, slam::Stamp> last_scans_;
  std::uint32_t resets_ = 0;  ///< of the back-end
  std::optional<slam_ros::PointsPublisher> publisher_;
  ros::Publisher progress_;
  ros::Subscriber reset_;
  std::atomic<bool> tells_progress_ = false;  ///< scans come from another thread before it is there
  std::optional<slam_ros::AfterLoad> start_;
};

}  // namespace slam_pointmap

PLUGINLIB_EXPORT_CLASS(slam_pointmap::PointMapNodelet, nodelet::Nodelet)
