// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <slam_msgs/Progress.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <cstdint>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>

#include "decision_publisher.hpp"
#include "nodelet_config.hpp"
#include "slam_core/active_path/explorer.hpp"
#include "slam_ros/after_load.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/diagnostics.hpp"
#include "slam_ros/grid_publisher.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/rate_limit.hpp"
#include "slam_ros/report_failure.hpp"

namespace slam_active {

using slam::active_path::Decision;

namespace {

const char* nameOf(Decision::State state) {
  switch (state) {
    case Decision::State::kExploring:
      return "exploring";
    case Decision::State::kClosingLoop:
      return "closing a loop";
    case Decision::State::kExplored:
      return "explored";
    case Decision::State::kWaiting:
      break;
  }
  return "waiting";
}

}  // namespace

/// `map` and `pose` in; goals, the way to them and whether all is explored out. It decides when a
/// pose comes, at a bounded rate; time is the poses' time.
class ExplorerNodelet : public nodelet::Nodelet {
 public:
  ~ExplorerNodelet() override {
    // no callback may find what it needs gone
    start_.reset();
    map_subscriber_.shutdown();
    pose_subscriber_.shutdown();
    progress_subscriber_.shutdown();
    pause_.shutdown();
    restart_.shutdown();
    if (diagnostics_) diagnostics_->stop();
  }

 private:
  void onInit() override {
    slam_ros::reportFailure(getName(), [this] { initialise(getNodeHandle()); });
  }

  void initialise(ros::NodeHandle handle) {
    const auto config = slam_ros::parametersFromRos<NodeletConfig>(getPrivateNodeHandle());
    explorer_.emplace(config.explorer);
    rate_.set(config.decision_rate);
    diagnostics_.emplace(handle, getPrivateNodeHandle(), getName(),
                         slam_ros::Diagnostics::Sources{
                             [this] { return explorer_->counters(); }, [this] { return waiting(); },
                             [this] { return waiting(); }, [this] { return values(); }});
    publisher_.emplace(handle);
    pause_ = handle.advertiseService("active_path/pause", &ExplorerNodelet::onPause, this);
    restart_ = handle.advertiseService("active_path/restart", &ExplorerNodelet::onRestart, this);
    start_.emplace([this, handle] { subscribe(handle); });
  }

  void subscribe(ros::NodeHandle handle) {
    const auto pass = [this](const auto& topic, const auto& action) {
      diagnostics_->attempt(topic, action);
    };
    map_subscriber_ = slam_ros::subscribeThrough<nav_msgs::OccupancyGrid>(
        pass, handle, "map", 1, [this](const auto& message) { onMap(message); });
    pose_subscriber_ = slam_ros::subscribeThrough<geometry_msgs::PoseWithCovarianceStamped>(
        pass, handle, "pose", 1, [this](const auto& message) { onPose(message); });
    progress_subscriber_ = slam_ros::subscribeThrough<slam_msgs::Progress>(
        pass, handle, "progress", slam_ros::kQueue,
        [this](const auto& message) { onProgress(message); });
  }

  void onMap(const nav_msgs::OccupancyGrid& message) {
    if (slam_ros::isTurned(message)) {
      diagnostics_->warn(
          "map: the map's origin is turned or no number; its axes must be those of "
          "the map frame: it is left out");
      return;
    }
    map_ = slam_ros::fromMsg(message);
    map_frame_ = slam_ros::frameId(message.header.frame_id);
  }

  void onPose(const geometry_msgs::PoseWithCovarianceStamped& message) {
    last_pose_ = message.header.stamp;
    const auto stamp = slam_ros::fromRos(message.header.stamp);
    if (!map_ || is_paused_ || !rate_.isDue(stamp)) return;
    if (const auto frame = slam_ros::frameId(message.header.frame_id); frame != map_frame_) {
      diagnostics_->warn("pose: the pose is in the frame '" + frame + "', the map in '" +
                         map_frame_ + "': remap one of them");
      return;
    }
    const auto decision = explorer_->decide(stamp, *map_, slam_ros::fromMsg(message));
    diagnostics_->report("active_path", decision.status);
    publish(decision, message.header.stamp);
  }

  /// The back-end was reset or has loaded a map: what was seen and visited is of another map.
  void onProgress(const slam_msgs::Progress& message) {
    if (resets_ && message.resets != *resets_) {
      explorer_->reset();
      map_.reset();
      publisher_->stop(header(last_pose_));
    }
    resets_ = message.resets;
  }

  void publish(const Decision& decision, const ros::Time& stamp) {
    publisher_->publish(decision, map_->resolution, header(stamp));
    if (decision.state == Decision::State::kExplored && state_ != decision.state)
      NODELET_INFO("the map is explored: no place that the robot can reach shows anything new");
    state_ = decision.state;
    if (decision.goal) last_goal_ = decision.goal;
  }

  std_msgs::Header header(const ros::Time& stamp) const {
    std_msgs::Header header;
    header.stamp = stamp;
    header.frame_id = map_frame_;
    return header;
  }

  bool onPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
    is_paused_ = request.data;
    response.success = true;
    response.message = is_paused_ ? "paused: no more goals" : "going on";
    if (is_paused_) publisher_->stop(header(last_pose_));
    return true;
  }

  bool onRestart(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    explorer_->resume();
    response.success = true;
    response.message = "looks again at all goals that were left out";
    return true;
  }

  std::string waiting() const {
    if (!map_) return "waiting for map";
    return last_pose_.isZero() ? "waiting for pose" : "";
  }

  slam_ros::Diagnostics::Values values() const {
    slam_ros::Diagnostics::Values values{{"exploration", is_paused_ ? "paused" : nameOf(state_)}};
    if (last_goal_) {
      values.emplace_back("goal x [m]", std::to_string(last_goal_->pose.x()));
      values.emplace_back("goal y [m]", std::to_string(last_goal_->pose.y()));
      values.emplace_back("expected gain [bit m^2]", std::to_string(last_goal_->gain));
      values.emplace_back("way [m]", std::to_string(last_goal_->cost));
    }
    return values;
  }

  std::optional<slam::active_path::Explorer> explorer_;
  slam_ros::RateLimit rate_{1.0};
  std::optional<slam_ros::Diagnostics> diagnostics_;
  std::optional<slam::OccupancyGrid> map_;
  std::string map_frame_;
  std::optional<std::uint32_t> resets_;  ///< of the back-end
  ros::Time last_pose_;                  ///< zero until one has come
  bool is_paused_ = false;
  Decision::State state_ = Decision::State::kWaiting;
  std::optional<slam::active_path::Goal> last_goal_;
  std::optional<DecisionPublisher> publisher_;
  ros::ServiceServer pause_, restart_;
  ros::Subscriber map_subscriber_, pose_subscriber_, progress_subscriber_;
  std::optional<slam_ros::AfterLoad> start_;
};

}  // namespace slam_active

PLUGINLIB_EXPORT_CLASS(slam_active::ExplorerNodelet, nodelet::Nodelet)
