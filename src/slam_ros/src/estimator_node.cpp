// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/estimator_node.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "slam_core/common/input_file.hpp"
#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/session_keeper.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/known_inputs.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/settings_from_ros.hpp"

namespace slam_ros {

EstimatorNode::EstimatorNode(const Handles& handles, const OutputsConfig& outputs,
                             slam::MetaCoordinator& coordinator, const slam::ProductPart& part,
                             const InputOptions& inputs)
    : coordinator_(coordinator) {
  auto settings = settingsFromRos(handles.product);
  topics_ = settings.read<TopicsConfig>();
  coordinator_.configure(settings, part);
  requireKnownInputs(coordinator_.wiring());
  requireDistinctTopics(coordinator_.wiring(), topics_);
  const bool is_resumed = resume(handles.product, settings, part);
  flow_.emplace(coordinator_.components());
  notes_ = ArrivalNotes(*flow_, slam::portsOf(estimator()));
  for (const auto& input : slam::portsOf(estimator()).inputs())
    if (input.kind == slam::kindOf<slam::LandmarkObservationArray>())
      silence_.mayPause(topics_.of(input.name));
  const auto frames = settings.read<slam::FramesConfig>();
  map_frame_ = frameId(frames.map);
  const bool makes_grid = estimator().capabilities().find<slam::GridMapper>() != nullptr;
  slam::MapState start;
  slam::Status start_status;
  if (!outputs.load_map.empty() && !is_resumed) {
    start = slam::loadMap(outputs.load_map, map_frame_, makes_grid).map;
    start_status = estimator().startWith(start);
    if (start_status.level == slam::Status::Level::kError)
      throw std::runtime_error("cannot use the map " + outputs.load_map + ": " +
                               start_status.message);
  }
  if (!outputs.load_session.empty() && !is_resumed) start_status = startWithSession(outputs);
  diagnostics_.emplace(
      handles.product, handles.own, handles.name,
      Diagnostics::Sources{[this] { return coordinator_.counters(); }, [this] { return waiting(); },
                           [this] { return missing(); }, [this] { return figures(); }});
  if (!start.landmarks.empty() && start.joint_covariance.size() == 0)
    diagnostics_->warn(outputs.load_map + " has no joint covariance; its marginals are inflated");
  diagnostics_->report(outputs.load_map + outputs.load_session, start_status);
  if (!outputs.load_map.empty() && !is_resumed && makes_grid && !start.grid)
    diagnostics_->warn("no grid found at " + outputs.load_map + "; the grid begins empty");
  recorder_.emplace(outputs, map_frame_, settings, robotFileFromRos(handles.product),
                    *diagnostics_);
  for (const auto& warning : checkpoints_->news().warnings) diagnostics_->warn(warning);
  if (const auto& text = checkpoints_->news().text; !text.empty())
    diagnostics_->tell(ros::console::levels::Info, text);
  outputs_.emplace(handles.product, estimator(), map_frame_, outputs,
                   slam::JumpLimit::Limits{frames.jump_limit, frames.jump_limit_heading});
  outputs_->refresh();
  live_config_ = outputs;
  live_.emplace(handles.own, &live_config_, [this] { outputs_->configure(live_config_); });
  consistency_.emplace(handles.product, *diagnostics_, estimator().consistency());
  services_.emplace(handles.product, map_frame_, makes_grid,
                    MapFolder(settings.read<FilesConfig>()), actions());
  localisation_.emplace(handles.product, map_frame_, localisationActions());
  connect(handles.product, settings, inputs);
  start_.emplace([this, handle = handles.product] { subscribe(handle); });
}

/// A checkpoint holds the map that its product began with.
bool EstimatorNode::resume(const ros::NodeHandle& product, slam::Settings& settings,
                           const slam::ProductPart& part) {
  const auto& names = coordinator_.components().product;
  const bool is_whole = part.extent == slam::ProductPart::Extent::kWhole;
  stages_ = StageStates(product, coordinator_.components());
  checkpoints_.emplace(ros::NodeHandle(product, "checkpoints"),
                       slam::RunIdentity{names.product, names.robot,
                                         is_whole ? "live data, inprocess" : "live data, pubsub",
                                         settings.inForce()},
                       coordinator_, stages_);
  return checkpoints_->resume([&] { coordinator_.configure(settings, part); });
}

slam::Status EstimatorNode::startWithSession(const OutputsConfig& outputs) {
  const auto& path = outputs.load_session;
  if (!outputs.load_map.empty())
    throw std::runtime_error("a session holds its map: give load_map or load_session, not both");
  const auto status =
      estimator().startWith(slam::SavedSession{slam::readInputFile(path, "the session")});
  if (status.level == slam::Status::Level::kError)
    throw std::runtime_error("cannot use the session " + path + ": " + status.message);
  return status;
}

void EstimatorNode::connect(const ros::NodeHandle& handle, slam::Settings& settings,
                            const InputOptions& options) {
  auto context = inputContext(handle, settings, options);
  context.pass = pass();
  context.put = [this](const auto& port, auto kind, const auto* value, const auto& topic) {
    take(port, kind, value, topic);
  };
  context.warn = [this](const auto& sentence) { diagnostics_->warn(sentence); };
  inputs_.emplace(context, coordinator_.wiring(), slam::portsOf(estimator()));
}

Pass EstimatorNode::pass() {
  return [this](const auto& topic, const auto& action) { diagnostics_->guard(topic, action); };
}

EstimatorNode::~EstimatorNode() {
  // from here on no callback runs
  start_.reset();
  silence_timer_.stop();
  diagnostics_->stop();  // it asks the inputs
  inputs_->stop();
  subscribers_.clear();
  localisation_.reset();
  services_.reset();
  consistency_.reset();
  live_.reset();
  outputs_.reset();
  saveLast();
  recorder_->finish(estimator().capabilities(), coordinator_.dropped());
}

/// Not what a step has left that threw: the last checkpoint is of a state that was whole.
void EstimatorNode::saveLast() {
  if (!diagnostics_->isGuardOpen()) return;
  if (const auto fault = checkpoints_->finish(); !fault.empty())
    ROS_WARN_STREAM_NAMED("slam", fault);
}

void EstimatorNode::subscribe(ros::NodeHandle handle) {
  consistency_->subscribe(handle);
  subscribers_ = {subscribeThrough<geometry_msgs::PoseWithCovarianceStamped>(
      pass(), handle, "initialpose", 1, [this](const auto& message) { onInitialPose(message); })};
  silence_timer_ = handle.createWallTimer(ros::WallDuration(1.0),
                                          [this](const ros::WallTimerEvent&) { tellOfSilence(); });
  // last: who sees it may send
  progress_ = handle.advertise<slam_msgs::Progress>("progress", kQueue);
  tells_progress_ = true;
}

BackendActions EstimatorNode::actions() {
  BackendActions actions;
  actions.reset = [this] { reset(); };
  actions.pause = [this](bool paused) { estimator().pause(paused); };
  actions.map = [this] {
    const auto* keeper = estimator().capabilities().find<slam::MapKeeper>();
    if (keeper == nullptr)
      throw std::runtime_error("this back-end keeps no map that could be saved");
    return slam::LandmarkFile{map_frame_, recorder_->lastStamp(), keeper->state()};
  };
  actions.load = [this](const slam::LandmarkFile& file) {
    return tellingOfMap(coordinator_.set(file.map));
  };
  actions.remove = [this](slam::LandmarkId id) { return removeLandmark(id, estimator()); };
  const auto* keeper = estimator().capabilities().find<slam::SessionKeeper>();
  if (keeper == nullptr) return actions;
  actions.session = [keeper] { return keeper->session(); };
  actions.take_up = [this](const slam::SavedSession& session) {
    return tellingOfMap(coordinator_.set(session));
  };
  actions.merge = [this](const slam::SavedSession& session) { return merge(session, estimator()); };
  return actions;
}

LocalisationActions EstimatorNode::localisationActions() {
  using slam::relocalisation::Belief;
  LocalisationActions actions;
  actions.search = [this] {
    auto& relocaliser = relocaliserOf(estimator());
    const auto status = relocaliser.assume(Belief::kAnywhere);
    if (relocaliser.belief() == Belief::kAnywhere) return slam::Status::ok();
    if (!status.isOk()) return slam::Status::error(status.message);
    return slam::Status::error(
        "there is no map to look for the robot in, or relocalisation.enabled is false: load a map");
  };
  actions.search_anyway = [this] { relocaliserOf(estimator()).searchAnyway(); };
  actions.report = [this](const auto& topic, const auto& status) {
    diagnostics_->report(topic, status);
  };
  if (estimator().capabilities().find<slam::GridMapper>() == nullptr) return actions;
  actions.set_map = [this](const slam::MapState& map) {
    const auto status = tellingOfMap(coordinator_.set(map));
    // the request says where the robot is
    if (status.level != slam::Status::Level::kError)
      relocaliserOf(estimator()).assume(Belief::kSure);
    return status;
  };
  return actions;
}

/// All outputs are published anew where another map is in force now.
slam::Status EstimatorNode::tellingOfMap(slam::Status status) {
  if (status.level == slam::Status::Level::kError) return status;
  outputs_->refresh();
  tellOfReset();
  return status;
}

void EstimatorNode::take(const std::string& port, slam::Kind kind, const void* value,
                         const std::string& topic) {
  checkClock();
  if (kind == slam::kindOf<slam::Motion>())
    noteFrames(*static_cast<const slam::Motion*>(value), topic);
  notes_.take(port, kind, value);
  coordinator_.put(port, kind, value);
  takeSteps(topic);
}

void EstimatorNode::noteFrames(const slam::Motion& motion, const std::string& topic) {
  const auto frames = motion.odometry_frame + " -> " + motion.base_frame;
  if (!motion_frames_.empty() && frames != motion_frames_)
    diagnostics_->warn(topic + ": its frames changed from " + motion_frames_ + " to " + frames +
                       "; the new ones are used");
  motion_frames_ = frames;
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
    diagnostics_->report("initialpose", estimator().set(estimate));
}

void EstimatorNode::tellOfSilence() {
  const auto news = silence_.news(SilenceWatch::Clock::now());
  if (!news.empty()) diagnostics_->tell(ros::console::levels::Warn, news);
  const auto starving = this->starving();
  if (!starving.empty() && !is_starving_) diagnostics_->tell(ros::console::levels::Warn, starving);
  is_starving_ = !starving.empty();
}

std::string EstimatorNode::starving() const {
  const auto what = estimator().intake().arrivals().starving;
  return what.empty() ? "" : "no update: " + what + " on " + notes_.motionTopic();
}

void EstimatorNode::takeSteps(const std::string& topic) {
  const auto news = silence_.heard(topic, SilenceWatch::Clock::now());
  if (!news.empty()) diagnostics_->tell(ros::console::levels::Info, news);
  notes_.taken(topic, estimator().intake().arrivals().motion);
  const auto& report = estimator().report();
  do {
    const auto start = RunMetrics::Clock::now();
    const auto status = coordinator_.execute();
    const auto time = RunMetrics::Clock::now() - start;
    diagnostics_->report(topic, status);
    if (report) publishStep(*report, time);
    if (report) last_step_ = report->stamp;
  } while (report);
  if (last_step_)
    if (const auto fault = checkpoints_->note(*last_step_); !fault.empty())
      diagnostics_->warn(fault);
  if (on_idle) on_idle();
  publishProgress();
}

void EstimatorNode::publishStep(const slam::StepReport& report, RunMetrics::Clock::duration time) {
  if (report.restarted) {
    checkpoints_->beginAnew();
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
  slam_msgs::Progress message;
  notes_.acknowledge(estimator().intake().arrivals(), message);
  message.step = toRos(recorder_->lastStamp());
  message.resets = resets_;
  progress_.publish(message);
}

void EstimatorNode::checkClock() {
  if (!clock_.hasJumpedBack()) return;
  // as stamps: ROS's durations hold 68 years, its times 136
  const auto from = fromRos(clock_.jump().from), to = fromRos(clock_.jump().to);
  const auto middle = to + (from - to) / 2;
  if (estimator().intake().arrivals().motion.value_or(recorder_->lastStamp()) < middle)
    return;  // it has seen it
  diagnostics_->warn("/clock jumped back by " + std::to_string(slam::seconds(from - to)) +
                     " s: map and pose begin anew");
  beginAnew();
}

void EstimatorNode::reset() {
  beginAnew();
  stages_.goOnFrom({});
  tellOfReset();
}

void EstimatorNode::tellOfReset() {
  ++resets_;
  publishProgress();
}

void EstimatorNode::beginAnew() {
  coordinator_.reset();
  checkpoints_->beginAnew();
  diagnostics_->recover();
  recorder_->restart();
  outputs_->restart();
  consistency_->restart();
  motion_frames_.clear();
  notes_.forget();
}

std::string EstimatorNode::missing() const {
  return inputs_ ? inputs_->waiting(needlessInputs()) : "";
}

std::string EstimatorNode::waiting() const {
  if (const auto wait = missing(); !wait.empty()) return wait;
  if (const auto starving = this->starving(); !starving.empty()) return starving;
  return silence_.sentence(SilenceWatch::Clock::now());
}

/// Inputs of components whose data have come. It does not matter whether the component of this
/// process has made them or one of another.
std::vector<slam::InputPort> EstimatorNode::needlessInputs() const {
  const auto arrivals = estimator().intake().arrivals();
  std::vector<slam::InputPort> needless;
  for (const auto& part : flow_->parts()) {
    const auto outputs = flow_->lastOutputs(part);
    const auto has_stamp = [&](const auto& output) {
      return arrivals.lastOf(output.name).has_value();
    };
    const bool has_come = flow_->triggersSteps(part)
                              ? std::any_of(outputs.begin(), outputs.end(), has_stamp)
                              : arrivals.motion.has_value();
    if (!part.is_maker || !has_come) continue;
    for (const auto& input : flow_->inputsOfAlone(part)) needless.push_back(input);
  }
  return needless;
}

Diagnostics::Values EstimatorNode::figures() const {
  Diagnostics::Values values;
  for (const auto& [name, value] : estimator().figures())
    values.emplace_back(name, fmt::format("{:g}", value));
  if (const double pause = checkpoints_->longestPause(); pause > 0.0)
    values.emplace_back("checkpoint_longest_pause_ms", fmt::format("{:.3g}", pause));
  return values;
}

}  // namespace slam_ros
