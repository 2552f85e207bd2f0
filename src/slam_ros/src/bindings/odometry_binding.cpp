// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/odometry_sample.hpp"
#include "slam_ros/after_load.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/input_binding.hpp"
#include "slam_ros/odometry_subscriber.hpp"

namespace slam_ros {
namespace {

/// A wheel driver's odometry: its topic, or the transform that is all that some robots tell.
class OdometryBinding final : public InputBinding {
 public:
  OdometryBinding(const InputContext& context, const slam::InputPort& port)
      : name_(port.name),
        put_(context.put),
        warn_(context.warn),
        odom_(
            context.handle,
            OdometrySubscriber::Options{context.topics.of(port.name), context.frames.odom,
                                        context.frames.base, context.options.odometry_from_tf,
                                        context.options.publishes_odometry_edge},
            [this](const nav_msgs::Odometry& message) { take(message); }, context.pass) {
    start_.emplace([this] { odom_.subscribe(); });
  }
  ~OdometryBinding() override {
    start_.reset();
    odom_.shutdown();
  }
  const std::string& topic() const override { return odom_.source(); }
  std::string waiting() const override { return odom_.waiting(); }

 private:
  void take(const nav_msgs::Odometry& message) {
    noteArrival();
    const auto fault = saysNoPose(message) ? "" : poseFault(message);
    if (!fault.empty()) warn_(topic() + ": " + fault + "; its twist is used");
    const auto sample = fromMsg(message);
    put_(name_, slam::kindOf<slam::OdometrySample>(), &sample, topic());
  }

  std::string name_;
  InputContext::Put put_;
  std::function<void(const std::string&)> warn_;
  OdometrySubscriber odom_;
  std::optional<AfterLoad> start_;
};

const InputBindingRegistrar<slam::OdometrySample, OdometryBinding> kOdometryBinding;

}  // namespace
}  // namespace slam_ros
