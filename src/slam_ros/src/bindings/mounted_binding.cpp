// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <optional>

#include "slam_ros/after_load.hpp"
#include "slam_ros/input_bindings.hpp"
#include "slam_ros/mounted_input.hpp"

// A laser's scans and an IMU's readings, each with the sensor's mount.

namespace slam_ros {
namespace {

struct Laser {
  using Message = sensor_msgs::LaserScan;
  using Data = slam::LaserSweep;
  using Input = LaserInput;
  static constexpr const char* kWaiting = "waiting for scans on ";
  static constexpr std::size_t kSent = kScansInFlight;  ///< before one is acknowledged
};

struct Imu {
  using Message = sensor_msgs::Imu;
  using Data = slam::ImuReading;
  using Input = ImuInput;
  static constexpr const char* kWaiting = "waiting for an IMU on ";
  static constexpr std::size_t kSent = kInFlight;
};

template <class Sensor>
class MountedBinding final : public InputBinding {
 public:
  MountedBinding(const InputContext& context, const slam::InputPort& port)
      : topic_(context.topics.of(port.name)),
        robot_file_has_mount_(context.mounts.has(port.name)),
        input_(frameId(context.frames.base), sinks(context, port)) {
    context.handle.resolveName(topic_);  // throws now what subscribing would throw later
    start_.emplace([this, handle = context.handle, pass = context.pass] {
      const auto take = [this](const auto& message) { input_.take(message); };
      transforms_ = subscribeThrough<tf2_msgs::TFMessage>(pass, handle, "/tf_static", kQueue, take);
      data_ = subscribeThrough<typename Sensor::Message>(pass, handle, topic_, kQueue, take);
    });
  }
  ~MountedBinding() override {
    start_.reset();
    data_.shutdown();
    transforms_.shutdown();
  }

  const std::string& topic() const override { return topic_; }
  std::string waiting() const override {
    if (!input_.hasData()) return Sensor::kWaiting + topic_;
    const auto transform = robot_file_has_mount_ ? "" : input_.missingTransform();
    return transform.empty() ? "" : "waiting for the transform " + transform + " on /tf_static";
  }

 private:
  typename Sensor::Input::Sinks sinks(const InputContext& context, const slam::InputPort& port) {
    const auto put = [this, name = port.name, put = context.put](const auto& data) {
      put(name, slam::kindOf<std::decay_t<decltype(data)>>(), &data, topic_);
    };
    const auto take = [this, put](const typename Sensor::Data& data) {
      noteArrival();
      put(data);
    };
    return {take, put};
  }

  std::string topic_;
  bool robot_file_has_mount_;  ///< else it comes as a transform
  typename Sensor::Input input_;
  ros::Subscriber data_, transforms_;
  std::optional<AfterLoad> start_;
};

template <class Sensor>
class MountedInBag final : public TopicInBag {
 public:
  MountedInBag(const BagContext& context, const std::string& port)
      : TopicInBag(inputOf<typename Sensor::Message>(port, context.topics.of(port))),
        base_frame_(frameId(context.frames.base)),
        robot_file_has_mount_(context.mounts.has(port)) {}

  BagHandlers readers(const BagSinks& sinks) override {
    const auto put = [sinks](const auto& data) { sinks.give(data); };
    sensor_.emplace(base_frame_, typename Sensor::Input::Sinks{put, put});
    sensor_->take(sinks.static_transforms);
    const auto take = [this](const typename Sensor::Message& message) { sensor_->take(message); };
    return {{topic_, onMessage<typename Sensor::Message>(take)}};
  }
  std::string lacking() const override {
    return robot_file_has_mount_ ? "" : sensor_->lackOfMount();
  }

  BagPlay play() const override { return {Sensor::kSent, 0, true}; }
  BagHandlers senders(ros::NodeHandle handle, const Gate& gate) override {
    using Message = typename Sensor::Message;
    const auto data = advertise<Message>(handle, input_.topic, kInFlight);
    return {{topic_, sender<Message>(data, gate, HeaderStamp())}};
  }

 private:
  std::string base_frame_;
  bool robot_file_has_mount_;
  std::optional<typename Sensor::Input> sensor_;
};

template <class Sensor>
using MountedRegistrar =
    InputBindingRegistrar<typename Sensor::Data, MountedBinding<Sensor>, MountedInBag<Sensor>>;

const MountedRegistrar<Laser> kLaserBinding;
const MountedRegistrar<Imu> kImuBinding;

}  // namespace
}  // namespace slam_ros
