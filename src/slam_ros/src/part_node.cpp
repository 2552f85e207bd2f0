// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/part_node.hpp"

#include <fmt/format.h>

#include <utility>

#include "slam_ros/known_inputs.hpp"
#include "slam_ros/settings_from_ros.hpp"

namespace slam_ros {
namespace {

const ros::WallDuration kConnectionPoll(0.05);

}  // namespace

PartNode::PartNode(const Handles& handles, const slam::ProductPart& part,
                   const InputOptions& options)
    : handle_(handles.product) {
  auto settings = settingsFromRos(handles.product);
  part_.configure(settings, part);
  auto context = inputContext(handles.product, settings, options);
  topics_ = context.topics;
  requireDistinctTopics(part_.wiring(), topics_);
  diagnostics_.emplace(
      handles.product, handles.own, handles.name,
      Diagnostics::Sources{[this] { return part_.counters(); }, [this] { return waiting(); },
                           [this] { return missing(); }, [this] { return figures(); }});
  context.pass = pass();
  context.put = [this](const auto& port, auto kind, const auto* value, const auto& topic) {
    take(port, kind, value, topic);
  };
  context.warn = [this](const auto& sentence) { diagnostics_->warn(sentence); };
  inputs_.emplace(context, part_.wiring());
}

PartNode::~PartNode() {
  diagnostics_->stop();  // it asks the inputs, and callbacks of the inputs tell it what was wrong
  stop();
  diagnostics_.reset();
}

void PartNode::onceConnected(std::function<void()> call) {
  const auto attempt = [this, call = std::move(call)](const ros::WallTimerEvent&) {
    if (!inputs_->areConnected()) return;
    connecting_.stop();
    call();
  };
  start_.emplace(
      [this, attempt] { connecting_ = handle_.createWallTimer(kConnectionPoll, attempt); });
}

void PartNode::stop() {
  start_.reset();
  connecting_.stop();
  inputs_->stop();
}

Pass PartNode::pass() {
  return [this](const auto& topic, const auto& action) { diagnostics_->attempt(topic, action); };
}

void PartNode::reset() {
  part_.reset();
  if (on_reset) on_reset();
}

void PartNode::take(const std::string& port, slam::Kind kind, const void* value,
                    const std::string& topic) {
  if (!through) return takeIn(port, kind, value, topic);
  through([&] { takeIn(port, kind, value, topic); });
}

void PartNode::takeIn(const std::string& port, slam::Kind kind, const void* value,
                      const std::string& topic) {
  const auto news = silence_.heard(topic, SilenceWatch::Clock::now());
  if (!news.empty()) diagnostics_->tell(ros::console::levels::Info, news);
  if (clock_.hasJumpedBack()) reset();
  arrival_ = inputs_->of(port, kind).arrival();
  part_.put(port, kind, value);
  diagnostics_->report(topic, part_.execute());
  if (on_taken) on_taken(port, kind, value);
}

std::string PartNode::missing() const {
  const auto wait = waits_for ? waits_for() : "";
  return wait.empty() && inputs_ ? inputs_->waiting() : wait;
}

std::string PartNode::waiting() const {
  const auto wait = missing();
  return wait.empty() ? silence_.sentence(SilenceWatch::Clock::now()) : wait;
}

Diagnostics::Values PartNode::figures() const {
  Diagnostics::Values values;
  for (const auto& [name, value] : part_.wiring().figures())
    values.emplace_back(name, fmt::format("{:g}", value));
  if (latency_.empty()) return values;
  values.emplace_back("rate [1/s]", fmt::format("{:.2f}", latency_.rate()));
  values.emplace_back("latency p50 [ms]", fmt::format("{:.2f}", latency_.milliseconds(0.5)));
  values.emplace_back("latency p99 [ms]", fmt::format("{:.2f}", latency_.milliseconds(0.99)));
  return values;
}

}  // namespace slam_ros
