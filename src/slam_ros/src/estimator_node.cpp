// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/estimator_node.hpp"

#include <fmt/core.h>
#include <slam_msgs/Progress.h>

#include <stdexcept>
#include <utility>

#include "slam_ros/conversions.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/settings_from_ros.hpp"

namespace slam_ros {

EstimatorNode::EstimatorNode(const Handles& handles, const OutputsConfig& outputs,
                             StepSource& source)
    : source_(source) {
  auto settings = settingsFromRos(handles.product);
  topics_ = settings.read<TopicsConfig>();
  source_.configure(settings);
  silence_.mayPause(topics_.observations);
  map_frame_ = frameId(settings.read<slam::FramesConfig>().map);
  auto& estimator = source_.estimator();
  slam::MapState start;
  slam::Status start_status;
  if (!outputs.load_map.empty()) {
    start = slam::loadMap(outputs.load_map, map_frame_, estimator.backend().usesScans()).map;
    start_status = estimator.startWith(start);
    if (start_status.level == slam::Status::Level::kError)
      throw std::runtime_error("cannot use the map " + outputs.load_map + ": " +
                               start_status.message);
  }
  diagnostics_.emplace(
      handles.product, handles.own, handles.name,
      Diagnostics::Sources{[this] { return source_.counters(); }, [this] { return waiting(); },
                           [this] { return figures(); }});
  if (!start.landmarks.empty() && start.joint_covariance.size() == 0)
    diagnostics_->warn(outputs.load_map + " has no joint covariance; its marginals are inflated");
  diagnostics_->report(outputs.load_map, start_status);
  if (!outputs.load_map.empty() && estimator.backend().usesScans() && !start.grid)
    diagnostics_->warn("no grid found at " + outputs.load_map + "; the grid begins empty");
  recorder_.emplace(outputs, map_frame_, settings.inForce(), *diagnostics_);
  outputs_.emplace(handles.product, estimator.backend(), map_frame_, outputs);
  outputs_->refresh();
  consistency_.emplace(handles.product, *diagnostics_, estimator.consistency());
  services_.emplace(handles.product, map_frame_, estimator.backend().usesScans(), actions());
  for (const auto& topic : {topics_.motion, topics_.observations})
    handles.product.resolveName(topic);  // throws now what subscribing would throw later
  if (source_.usesScans()) connectLaser(handles.product, settings);
  start_.emplace([this, handle = handles.product] { subscribe(handle); });
}

void EstimatorNode::connectLaser(ros::NodeHandle handle, slam::Settings& settings) {
  const LaserSubscriber::Options options{topics_.scan,
                                         frameId(settings.read<slam::FramesConfig>().base),
                                         !settings.read<slam::LaserConfig>().sensor_pose.empty()};
  const auto take = [this](const auto& input) {
    checkClock();
    source_.set(input);
    takeSteps(topics_.scan);
  };
  const auto take_scan = [this, take](const slam::LaserSweep& sweep) {
    last_scan_ = sweep.stamp;
    take(sweep);
  };
  laser_.emplace(handle, options, LaserInput::Sinks{take_scan, take});
}

EstimatorNode::~EstimatorNode() {
  // from here on no callback runs
  start_.reset();
  silence_timer_.stop();
  if (laser_) laser_->stop();
  subscribers_.clear();
  services_.reset();
  consistency_.reset();
  outputs_.reset();
  recorder_->finish(source_.estimator().backend(), source_.dropped());
}

void EstimatorNode::subscribe(ros::NodeHandle handle) {
  consistency_->subscribe(handle);
  subscribers_ = {
      handle.subscribe(topics_.motion, kQueue, &EstimatorNode::onMotion, this),
      handle.subscribe(topics_.observations, kQueue, &EstimatorNode::onObservations, this),
      handle.subscribe("initialpose", 1, &EstimatorNode::onInitialPose, this)};
  silence_timer_ = handle.createWallTimer(ros::WallDuration(1.0),
                                          [this](const ros::WallTimerEvent&) { tellOfSilence(); });
  // last: who sees it may send
  progress_ = handle.advertise<slam_msgs::Progress>("progress", kQueue);
  tells_progress_ = true;
}

BackendActions EstimatorNode::actions() {
  BackendActions actions;
  actions.reset = [this] { reset(); };
  actions.pause = [this](bool paused) { source_.estimator().pause(paused); };
  actions.map = [this] {
    return slam::LandmarkFile{map_frame_, recorder_->lastStamp(),
                              source_.estimator().backend().state()};
  };
  actions.load = [this](const slam::LandmarkFile& file) {
    const auto status = source_.set(file.map);
    if (status.level == slam::Status::Level::kError) return status;
    outputs_->refresh();
    tellOfReset();
    return status;
  };
  return actions;
}

void EstimatorNode::onMotion(const slam_msgs::Motion& message) {
  checkClock();
  const auto motion = fromMsg(message);
  const auto frames = motion.odometry_frame + " -> " + motion.base_frame;
  if (!motion_frames_.empty() && frames != motion_frames_)
    diagnostics_->warn(topics_.motion + ": its frames changed from " + motion_frames_ + " to " +
                       frames + "; the new ones are used");
  motion_frames_ = frames;
  source_.set(motion);
  takeSteps(topics_.motion);
}

void EstimatorNode::onObservations(const slam_msgs::LandmarkObservationArray& message) {
  checkClock();
  source_.estimator().set(fromMsg(message));
  takeSteps(topics_.observations);
}

void EstimatorNode::onInitialPose(const geometry_msgs::PoseWithCovarianceStamped& message) {
  const auto estimate = fromMsg(message);
  if (frameId(message.header.frame_id) != map_frame_)
    diagnostics_->warn("initialpose: it is in frame '" + message.header.frame_id +
                       "', the map frame is '" + map_frame_ + "'; it is left out");
  else if (!estimate.pose.isFinite() || !slam::isCovariance(estimate.covariance))
    diagnostics_->warn(
        "initialpose: its pose is not a number or its covariance of (x, y, yaw) is "
        "not positive definite; it is left out");
  else
    diagnostics_->report("initialpose", source_.estimator().set(estimate));
}

void EstimatorNode::tellOfSilence() {
  const auto news = silence_.news(SilenceWatch::Clock::now());
  if (!news.empty()) diagnostics_->tell(ros::console::levels::Warn, news);
  const auto starving = this->starving();
  if (!starving.empty() && !is_starving_) diagnostics_->tell(ros::console::levels::Warn, starving);
  is_starving_ = !starving.empty();
}

std::string EstimatorNode::starving() const {
  const auto what = source_.estimator().starving();
  return what.empty() ? "" : "nothing steps: " + what + " on " + motion_topic_;
}

void EstimatorNode::takeSteps(const std::string& topic) {
  const auto news = silence_.heard(topic, SilenceWatch::Clock::now());
  if (!news.empty()) diagnostics_->tell(ros::console::levels::Info, news);
  const auto& estimator = source_.estimator();
  if (std::exchange(last_motion_, estimator.lastMotion()) != estimator.lastMotion())
    motion_topic_ = topic;
  const auto& report = estimator.report();
  do {
    const auto start = RunMetrics::Clock::now();
    const auto status = source_.execute();
    const auto time = RunMetrics::Clock::now() - start;
    diagnostics_->report(topic, status);
    if (report) publishStep(*report, time);
  } while (report);
  if (on_idle) on_idle();
  publishProgress();
}

void EstimatorNode::publishStep(const slam::StepReport& report, RunMetrics::Clock::duration time) {
  if (report.restarted) {
    outputs_->restart();
    consistency_->restart();
  }
  recorder_->write(report, time);
  outputs_->publish(report);
  consistency_->publish(report);
  if (on_step) on_step(report);
}

void EstimatorNode::publishProgress() {
  if (!tells_progress_ || progress_.getNumSubscribers() == 0) return;
  const auto& estimator = source_.estimator();
  slam_msgs::Progress message;
  message.motion = toRos(estimator.lastMotion().value_or(slam::Stamp()));
  message.observations = toRos(estimator.lastObservations().value_or(slam::Stamp()));
  message.scans = toRos(last_scan_);
  message.step = toRos(recorder_->lastStamp());
  message.resets = resets_;
  progress_.publish(message);
}

void EstimatorNode::checkClock() {
  if (!clock_.hasJumpedBack()) return;
  const auto& [from, to] = clock_.jump();
  const auto middle = fromRos(to + (from - to) * 0.5);
  if (source_.estimator().lastMotion().value_or(slam::Stamp()) < middle) return;  // it has seen it
  diagnostics_->warn("/clock jumped back by " + std::to_string((from - to).toSec()) +
                     " s: map and pose begin anew");
  beginAnew();
}

void EstimatorNode::reset() {
  beginAnew();
  tellOfReset();
}

void EstimatorNode::tellOfReset() {
  ++resets_;
  publishProgress();
}

void EstimatorNode::beginAnew() {
  source_.reset();
  recorder_->restart();
  outputs_->restart();
  consistency_->restart();
  motion_frames_.clear();
}

std::string EstimatorNode::waiting() const {
  const auto& estimator = source_.estimator();
  if (!estimator.lastMotion()) return "waiting for motion on " + topics_.motion;
  if (const auto wait = laser_ ? laser_->waiting() : ""; !wait.empty()) return wait;
  if (const auto starving = this->starving(); !starving.empty()) return starving;
  if (const auto stale = silence_.sentence(SilenceWatch::Clock::now()); !stale.empty())
    return stale;
  if (estimator.lastObservations() || estimator.usesScans()) return "";
  const auto sensor = front_end_waiting ? front_end_waiting() : "";
  return sensor.empty() ? "waiting for observations on " + topics_.observations : sensor;
}

Diagnostics::Values EstimatorNode::figures() const {
  Diagnostics::Values values;
  for (const auto& [name, value] : source_.estimator().backend().figures())
    values.emplace_back(name, fmt::format("{:g}", value));
  return values;
}

}  // namespace slam_ros
