// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>
#include <ros/ros.h>
#include <slam_msgs/LandmarkObservationArray.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>

#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>

#include "slam_core/product/product_components.hpp"
#include "slam_ros/camera_subscriber.hpp"
#include "slam_ros/clock_watch.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/detections_publisher.hpp"
#include "slam_ros/diagnostics.hpp"
#include "slam_ros/latency_window.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/settings_from_ros.hpp"
#include "slam_ros/topics_config.hpp"
#include "slam_ros/transport_config.hpp"

namespace slam_frontend {

/// Images in, `observations` out, by the detector that the product names.
class FiducialDetectorNodelet : public nodelet::Nodelet {
 public:
  ~FiducialDetectorNodelet() override {
    if (camera_) camera_->stop();  // no callback may find what it needs gone
    diagnostics_.reset();
  }

 private:
  void onInit() override {
    slam_ros::reportFailure(getName(), [this] { initialise(getNodeHandle()); });
  }

  void initialise(ros::NodeHandle handle) {
    auto settings = slam_ros::settingsFromRos(handle);
    const auto product = settings.read<slam::ProductConfig>();
    const auto topics = settings.read<slam_ros::TopicsConfig>();
    const auto transport =
        slam_ros::parametersFromRos<slam_ros::TransportConfig>(getPrivateNodeHandle()).transport;
    slam::loadLibraries(product.libraries);
    detector_ = slam::makeDetector(product);
    if (!detector_) {
      NODELET_INFO("the product looks at no images");
      return;
    }
    detector_->configure(settings);
    observations_ = handle.advertise<slam_msgs::LandmarkObservationArray>(topics.observations,
                                                                          slam_ros::kQueue);
    detections_.emplace(handle);
    const auto take = [this](const auto& input) { this->take(input); };
    const auto frames = settings.read<slam::FramesConfig>();
    camera_.emplace(handle,
                    slam_ros::CameraSubscriber::Options{topics.camera, transport,
                                                        slam_ros::frameId(frames.base)},
                    slam_ros::CameraInput::Sinks{take, take, take});
    diagnostics_.emplace(handle, getPrivateNodeHandle(), getName(),
                         slam_ros::Diagnostics::Sources{[this] { return detector_->counters(); },
                                                        [this] { return camera_->waiting(); },
                                                        [this] { return speed(); }});
  }

  template <class Input>
  void take(const Input& input) {
    if (clock_.hasJumpedBack()) detector_->reset();
    detector_->set(input);
    const auto& array = detector_->observations();
    do {
      diagnostics_->report(camera_->topic(), detector_->execute());
      if (array) publish(*array);
    } while (array);
  }

  void publish(const slam::LandmarkObservationArray& array) {
    observations_.publish(
        boost::make_shared<slam_msgs::LandmarkObservationArray>(slam_ros::toMsg(array)));
    latency_.add(camera_->arrival(), slam_ros::LatencyWindow::Clock::now());
    detections_->publish(*detector_, array);
  }

  std::vector<std::pair<std::string, std::string>> speed() const {
    if (latency_.empty()) return {};
    return {{"rate [1/s]", fmt::format("{:.2f}", latency_.rate())},
            {"latency p50 [ms]", fmt::format("{:.2f}", latency_.milliseconds(0.5))},
            {"latency p99 [ms]", fmt::format("{:.2f}", latency_.milliseconds(0.99))}};
  }

  std::unique_ptr<slam::LandmarkDetector> detector_;
  slam_ros::ClockWatch clock_;
  slam_ros::LatencyWindow latency_;
  ros::Publisher observations_;
  std::optional<slam_ros::DetectionsPublisher> detections_;
  std::optional<slam_ros::CameraSubscriber> camera_;
  std::optional<slam_ros::Diagnostics> diagnostics_;
};

}  // namespace slam_frontend

PLUGINLIB_EXPORT_CLASS(slam_frontend::FiducialDetectorNodelet, nodelet::Nodelet)
