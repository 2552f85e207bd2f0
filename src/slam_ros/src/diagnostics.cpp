// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/diagnostics.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

namespace slam_ros {
namespace {

constexpr double kQuietTime = 5.0;  // [s] of the wall

/// What a counter that grew means; a reason that is not here is no cause for a warning.
const std::map<std::string, std::string>& sentences() {
  static const std::map<std::string, std::string> kSentences = {
      {"late", "messages had a stamp that was not newer than the one before; they were dropped"},
      {"lost", "messages were lost on the way, as the gap in their sequence tells"},
      {"bridged", "gaps of lost motion were bridged by the odometry's own poses"},
      {"coasted",
       "motion was missing and the odometry's poses did not tell it; the robot was taken to have "
       "gone on at its last velocity"},
      {"set_aside",
       "messages have stamps from before those of the messages before them; they count once all "
       "sources go back"},
      {"odometry_implausible",
       "odometry messages told of more than wheel_odometry.max_speed or max_turn_rate allow"},
      {"odometry_pose_jump",
       "jumps of the odometry's pose, as of a driver that was restarted, were made up for"},
      {"overflow", "messages were dropped because nothing came to go with them"},
      {"before_start", "observation arrays were older than the first motion and were left out"},
      {"stamp_jump", "messages were stamped far ahead of those around them; they were dropped"},
      {"abandoned", "messages waited when time began anew and were left out"},
      {"in_gap", "messages came from a time of which the motion is missing and were left out"},
      {"restart", "time began anew: map and pose were reset"},
      {"unknown_id", "observations without a known id were left out"},
      {"duplicate", "observations repeated an id of their own array and were left out"},
      {"ambiguous",
       "observations may be of several landmarks by their place, or lie too near to one to be of "
       "another, and were left out"},
      {"on_trial", "observations of what may be a new landmark were not enough yet"},
      {"ghost", "landmarks were removed, since they were not seen where they should have been"},
      {"begun_anew", "landmarks that were repeatedly seen elsewhere were re-initialised there"},
      {"distrusted", "landmarks were removed, since what has their id was found in several places"},
      {"distrusted_id", "observations of ids that are found in several places were left out"},
      {"odometry_stamp_jump",
       "odometry messages were stamped far ahead of those before them; they were left out"},
      {"weight_underflow", "steps left no particle any weight; they were made equal"},
      {"doubtful",
       "steps saw most of the well known landmarks elsewhere than the map has them; it was left as "
       "it is"},
      {"odometry_late", "odometry messages were not newer than the one before; they were dropped"},
      {"camera_late", "images were not newer than the one before; they were dropped"}};
  return kSentences;
}

/// The sentence without its numbers, so that the same fault of another landmark is the same kind.
std::string kindOf(std::string sentence) {
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  sentence.erase(std::remove_if(sentence.begin(), sentence.end(), is_digit), sentence.end());
  return sentence;
}

}  // namespace

Diagnostics::Diagnostics(ros::NodeHandle handle, ros::NodeHandle private_handle,
                         const std::string& name, Sources sources)
    : name_(name), sources_(std::move(sources)), updater_(handle, private_handle, name) {
  updater_.setHardwareID("none");
  updater_.add("state", [this](auto& status) { fill(status); });
  timer_ = handle.createWallTimer(ros::WallDuration(1.0),
                                  [this](const ros::WallTimerEvent&) { tick(); });
}

Diagnostics::~Diagnostics() {
  stop();
  warnOfCounters();
}

void Diagnostics::report(const std::string& topic, const slam::Status& status) {
  if (status.isOk()) return;
  warn(topic + ": " + status.message);
  is_last_an_error_ = status.level == slam::Status::Level::kError;
}

void Diagnostics::warn(const std::string& sentence) {
  const auto now = ros::WallTime::now();
  last_warning_ = sentence;
  is_last_an_error_ = false;
  last_warning_time_ = now;
  auto& told = told_[kindOf(sentence)];
  if (!told.isZero() && now - told < ros::WallDuration(kQuietTime)) return;
  told = now;
  ROS_WARN_STREAM_NAMED("slam", name_ << ": " << sentence);
}

void Diagnostics::tell(ros::console::Level level, const std::string& sentence) {
  ROS_LOG_STREAM(level, ROSCONSOLE_DEFAULT_NAME ".slam", name_ << ": " << sentence);
}

void Diagnostics::fail(const std::string& sentence) {
  failure_ = sentence;
  ROS_ERROR_STREAM_NAMED("slam", name_ << ": " << sentence);
}

void Diagnostics::attempt(const std::string& topic, const Action& action) {
  const auto fault = faultIn(action);
  if (!fault.empty()) report(topic, slam::Status::error(fault + "; it is left out"));
}

void Diagnostics::guard(const std::string& topic, const Action& action) {
  const auto fault = door_.pass(topic, action);
  if (!fault.empty()) ROS_ERROR_STREAM_NAMED("slam", name_ << ": " << fault);
}

void Diagnostics::tick() {
  warnOfCounters();
  warnOfMissing();
  try {
    updater_.force_update();
  } catch (const std::runtime_error&) {
    // its next time is past the last second that ROS's clock can show: a /clock gone astray
  }
}

void Diagnostics::warnOfCounters() {
  const auto counters = sources_.counters();
  for (const auto& [reason, count] : counters.all()) {
    const auto sentence = sentences().find(reason);
    const auto before = counted_[reason];
    if (sentence != sentences().end() && count > before)
      warn(std::to_string(count - before) + " x " + reason + ": " + sentence->second);
  }
  counted_ = counters;
}

/// Else an input that never comes shows in /diagnostics alone, and the console stays silent.
void Diagnostics::warnOfMissing() {
  const auto now = ros::WallTime::now();
  if (const auto missing = sources_.missing(); missing != missing_) {
    missing_ = missing;
    missing_since_ = now;
    is_missing_told_ = false;
  }
  const bool is_due = now - missing_since_ >= ros::WallDuration(kQuietTime);
  if (missing_.empty() || is_missing_told_ || !is_due) return;
  is_missing_told_ = true;
  tell(ros::console::levels::Warn, missing_);
}

void Diagnostics::fill(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  const auto waiting = sources_.waiting();
  const bool warned = !last_warning_.empty() &&
                      ros::WallTime::now() - last_warning_time_ < ros::WallDuration(kQuietTime);
  if (!failure_.empty())
    status.summary(DiagnosticStatus::ERROR, failure_);
  else if (!door_.fault().empty())
    status.summary(DiagnosticStatus::ERROR, door_.fault());
  else if (ros::Time::isSimTime() && ros::Time::now().isZero())
    status.summary(DiagnosticStatus::WARN,
                   "use_sim_time is set and nobody publishes /clock: start the simulator or "
                   "rosbag play --clock, or unset the parameter");
  else if (warned)
    status.summary(is_last_an_error_ ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN,
                   last_warning_);
  else if (!waiting.empty())
    status.summary(DiagnosticStatus::WARN, waiting);
  else
    status.summary(DiagnosticStatus::OK, "running");
  const auto counters = sources_.counters();
  if (sources_.values)
    for (const auto& [name, value] : sources_.values()) status.add(name, value);
  for (const auto& [reason, count] : counters.all()) status.add(reason, count);
  if (door_.refused() > 0) status.add("refused after an error", door_.refused());
  if (!last_warning_.empty()) status.add("last warning", last_warning_);
}

}  // namespace slam_ros
