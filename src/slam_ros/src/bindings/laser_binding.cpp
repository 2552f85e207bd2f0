// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <optional>

#include "slam_ros/after_load.hpp"
#include "slam_ros/input_bindings.hpp"
#include "slam_ros/laser_input.hpp"

// A laser's scans with its mount.

namespace slam_ros {
namespace {

class LaserBinding final : public InputBinding {
 public:
  LaserBinding(const InputContext& context, const slam::InputPort& port)
      : topic_(context.topics.of(port.name)),
        robot_file_has_mount_(context.has_laser_mount),
        input_(frameId(context.frames.base), sinks(context, port)) {
    context.handle.resolveName(topic_);  // throws now what subscribing would throw later
    start_.emplace([this, handle = context.handle, pass = context.pass] {
      const auto take = [this](const auto& message) { input_.take(message); };
      transforms_ = subscribeThrough<tf2_msgs::TFMessage>(pass, handle, "/tf_static", kQueue, take);
      scans_ = subscribeThrough<sensor_msgs::LaserScan>(pass, handle, topic_, kQueue, take);
    });
  }
  ~LaserBinding() override {
    start_.reset();
    scans_.shutdown();
    transforms_.shutdown();
  }

  const std::string& topic() const override { return topic_; }
  std::string waiting() const override {
    if (!input_.hasScan()) return "waiting for scans on " + topic_;
    const auto transform = robot_file_has_mount_ ? "" : input_.missingTransform();
    return transform.empty() ? "" : "waiting for the transform " + transform + " on /tf_static";
  }

 private:
  LaserInput::Sinks sinks(const InputContext& context, const slam::InputPort& port) {
    const auto put = [this, name = port.name, put = context.put](const auto& data) {
      put(name, slam::kindOf<std::decay_t<decltype(data)>>(), &data, topic_);
    };
    const auto take = [this, put](const slam::LaserSweep& sweep) {
      noteArrival();
      put(sweep);
    };
    return {take, put};
  }

  std::string topic_;
  bool robot_file_has_mount_;  ///< else it comes as a transform
  LaserInput input_;
  ros::Subscriber scans_, transforms_;
  std::optional<AfterLoad> start_;
};

class LaserInBag final : public TopicInBag {
 public:
  LaserInBag(const BagContext& context, const std::string& port)
      : TopicInBag(inputOf<sensor_msgs::LaserScan>(port, context.topics.of(port))),
        base_frame_(frameId(context.frames.base)) {}

  BagHandlers readers(const BagSinks& sinks) override {
    const auto put = [sinks](const auto& data) { sinks.give(data); };
    laser_.emplace(base_frame_, LaserInput::Sinks{put, put});
    laser_->take(sinks.static_transforms);
    const auto take = [this](const sensor_msgs::LaserScan& scan) { laser_->take(scan); };
    return {{topic_, onMessage<sensor_msgs::LaserScan>(take)}};
  }
  std::string lacking() const override { return lackOfTransform(laser_->missingTransform()); }

  BagPlay play() const override { return {kScansInFlight, 0, true}; }
  BagHandlers senders(ros::NodeHandle handle, const Gate& gate) override {
    const auto scans = advertise<sensor_msgs::LaserScan>(handle, input_.topic, kInFlight);
    return {{topic_, sender<sensor_msgs::LaserScan>(scans, gate, HeaderStamp())}};
  }

 private:
  std::string base_frame_;
  std::optional<LaserInput> laser_;
};

const InputBindingRegistrar<slam::LaserSweep, LaserBinding, LaserInBag> kLaserBinding;

}  // namespace
}  // namespace slam_ros
