// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/conversions.hpp"
#include "slam_ros/input_binding.hpp"
#include "slam_ros/laser_subscriber.hpp"

namespace slam_ros {
namespace {

/// A laser's scans with its mount.
class LaserBinding final : public InputBinding {
 public:
  LaserBinding(const InputContext& context, const slam::InputPort& port) {
    const auto put = [this, name = port.name, put = context.put](const auto& data) {
      put(name, slam::kindOf<std::decay_t<decltype(data)>>(), &data, topic());
    };
    const auto take = [this, put](const slam::LaserSweep& sweep) {
      noteArrival();
      put(sweep);
    };
    laser_.emplace(context.handle,
                   LaserSubscriber::Options{context.topics.of(port.name),
                                            frameId(context.frames.base), context.has_laser_mount},
                   LaserInput::Sinks{take, put}, context.pass);
  }
  ~LaserBinding() override { laser_->stop(); }
  const std::string& topic() const override { return laser_->topic(); }
  std::string waiting() const override { return laser_->waiting(); }

 private:
  std::optional<LaserSubscriber> laser_;
};

const InputBindingRegistrar<slam::LaserSweep, LaserBinding> kLaserBinding;

}  // namespace
}  // namespace slam_ros
