// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/camera_subscriber.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/input_binding.hpp"

namespace slam_ros {
namespace {

/// Images, raw or compressed, with the camera's calibration and mount.
class CameraBinding final : public InputBinding {
 public:
  CameraBinding(const InputContext& context, const slam::InputPort& port) {
    const auto put = [this, name = port.name, put = context.put](const auto& data) {
      put(name, slam::kindOf<std::decay_t<decltype(data)>>(), &data, topic());
    };
    const auto take = [this, put](const slam::Image& image) {
      noteArrival();
      put(image);
    };
    camera_.emplace(
        context.handle,
        CameraSubscriber::Options{context.topics.of(port.name), context.options.image_transport,
                                  frameId(context.frames.base)},
        CameraInput::Sinks{take, put, put}, context.pass);
  }
  ~CameraBinding() override { camera_->stop(); }
  const std::string& topic() const override { return camera_->topic(); }
  std::string waiting() const override { return camera_->waiting(); }

 private:
  std::optional<CameraSubscriber> camera_;
};

const InputBindingRegistrar<slam::Image, CameraBinding> kCameraBinding;

}  // namespace
}  // namespace slam_ros
