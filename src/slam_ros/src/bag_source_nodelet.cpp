// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>
#include <signal.h>
#include <slam_msgs/Progress.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <pluginlib/class_list_macros.hpp>
#include <thread>

#include "slam_ros/bag_clock.hpp"
#include "slam_ros/bag_inputs.hpp"
#include "slam_ros/bag_transforms.hpp"
#include "slam_ros/camera_topics.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/flow_window.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/settings_from_ros.hpp"

namespace slam_ros {
namespace {

constexpr FlowWindow::Timeout kPatience(2000);
const ros::WallDuration kPoll(0.05), kSettle(0.3);

struct BagSourceConfig {
  static constexpr const char* kSection = "";

  std::string bag;
  double rate = 0.0;
  bool publish_clock = true;
  bool exit_at_end = true;
  std::vector<std::string> remaps;

  void describe(slam::Fields& fields) {
    fields.add("bag", &bag, "the recorded data");
    fields.add("rate", &rate, "times the recorded speed; 0: as fast as the back-end takes it")
        .unit("1")
        .in(slam::Range::atLeast(0));
    fields.add("publish_clock", &publish_clock, "/clock from the bag's times");
    fields.add("exit_at_end", &exit_at_end, "ends the process when the bag is through");
    fields.add("remaps", &remaps, "input:=topic of the bag");
  }
};

}  // namespace

/// Plays a bag to the product's inputs and sends no more than the back-end has acknowledged, so
/// that nothing is dropped however fast it goes.
class BagSourceNodelet : public nodelet::Nodelet {
 public:
  ~BagSourceNodelet() override {
    stop_ = true;
    window_.stop();
    if (thread_.joinable()) thread_.join();
  }

 private:
  void onInit() override {
    reportFailure(getName(), [this] {
      config_ = parametersFromRos<BagSourceConfig>(getPrivateNodeHandle());
      auto settings = settingsFromRos(getNodeHandle());
      const InputNeeds needs{settings.read<TopicsConfig>(), settings.read<slam::FramesConfig>(),
                             settings.read<slam::ProductConfig>().usesImages()};
      topics_ = needs.topics;
      map_frame_ = frameId(needs.frames.map);
      bag_ = std::make_unique<BagReader>(config_.bag);
      std::vector<Remap> remaps;
      for (const auto& text : config_.remaps) remaps.push_back(parseRemap(text));
      inputs_ = findInputs(*bag_, needs, remaps);
      for (const auto& note : inputs_.notes) NODELET_INFO_STREAM(note);
      for (const auto& warning : inputs_.warnings) NODELET_WARN_STREAM(warning);
      clock_ = std::make_unique<BagClock>(getNodeHandle(), config_.rate, config_.publish_clock);
      connect(getNodeHandle());
    });
    thread_ = std::thread([this] { play(); });
  }

  void connect(ros::NodeHandle handle) {
    if (!inputs_.motion.empty())
      motion_ = handle.advertise<slam_msgs::Motion>(topics_.motion, kInFlight);
    else
      odom_ = handle.advertise<nav_msgs::Odometry>(topics_.odom, kInFlight);
    const auto camera = cameraTopics(topics_.camera);
    if (!inputs_.image.empty())
      observations_ = handle.advertise<sensor_msgs::Image>(camera.raw, kImageQueue);
    else if (!inputs_.compressed_image.empty())
      observations_ =
          handle.advertise<sensor_msgs::CompressedImage>(camera.compressed, kImageQueue);
    else
      observations_ =
          handle.advertise<slam_msgs::LandmarkObservationArray>(topics_.observations, kInFlight);
    if (!inputs_.camera_info.empty())
      camera_info_ = handle.advertise<sensor_msgs::CameraInfo>(camera.info, kQueue);
    if (inputs_.hasImages()) window_.limit("observations", kImagesInFlight);
    tf_ = handle.advertise<tf2_msgs::TFMessage>("/tf", kInFlight);
    progress_ = handle.subscribe("progress", 10 * kInFlight, &BagSourceNodelet::onProgress, this);
  }

  void onProgress(const slam_msgs::Progress& message) {
    window_.acknowledged("motion", fromRos(message.motion));
    window_.acknowledged("observations", fromRos(message.observations));
  }

  void play() {
    try {
      publishStaticTransforms();
      if (!waitForSubscribers()) return;
      bag_->read(handlers(), [this](std::size_t) { return !stop_; });
    } catch (const std::exception& error) {
      // the run's files must not look complete
      NODELET_FATAL_STREAM(error.what());
      std::_Exit(EXIT_FAILURE);
    }
    if (stop_) return;
    if (!window_.waitUntilEmpty(kPatience) && !stop_ && window_.inFlight() > 1)
      NODELET_WARN_STREAM(window_.inFlight() << " messages at the bag's end were not acknowledged");
    NODELET_INFO_STREAM(bag_->path() << " is through");
    // as Ctrl-C does: the manager unloads the nodelets, which completes their files
    if (config_.exit_at_end && !stop_) ::kill(::getpid(), SIGINT);
  }

  void publishStaticTransforms() {
    const auto transforms = staticTransforms(*bag_, map_frame_);
    if (transforms.transforms.empty()) return;
    tf_static_ = getNodeHandle().advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
    tf_static_.publish(transforms);
  }

  /// @return false when the nodelet is unloaded before they are there
  bool waitForSubscribers() {
    const auto begin = ros::WallTime::now();
    bool told = false;
    while (!stop_) {
      const auto missing = missingPartner();
      if (missing.empty()) break;
      if (!told && ros::WallTime::now() - begin > ros::WallDuration(5)) {
        NODELET_WARN_STREAM("waiting for " << missing);
        told = true;
      }
      kPoll.sleep();
    }
    kSettle.sleep();  // the back-end takes its subscriptions one after the other
    return !stop_;
  }

  std::string missingPartner() const {
    const auto& odometry = inputs_.motion.empty() ? odom_ : motion_;
    std::vector<const ros::Publisher*> needed = {&odometry, &observations_};
    if (!inputs_.camera_info.empty()) needed.push_back(&camera_info_);
    for (const auto* publisher : needed)
      if (publisher->getNumSubscribers() == 0) return "a subscriber of " + publisher->getTopic();
    return progress_.getNumPublishers() == 0 ? "a back-end that publishes " + progress_.getTopic()
                                             : "";
  }

  BagHandlers handlers() {
    InputSinks sinks;
    sinks.motion = [this](const auto& message) { send(motion_, "motion", message.end, message); };
    sinks.odom = [this](const auto& message) {
      send(odom_, "motion", message.header.stamp, message);
    };
    // of every image comes an array, which is what is acknowledged
    const auto observe = [this](const auto& message) {
      send(observations_, "observations", message.header.stamp, message);
    };
    sinks.observations = observe;
    sinks.image = observe;
    sinks.compressed_image = observe;
    sinks.camera_info = [this](const auto& message) { camera_info_.publish(message); };
    auto handlers = handlersFor(inputs_, sinks);
    if (const auto* tf = bag_->find("tf"); tf != nullptr && holdsTransforms(*tf)) {
      handlers[tf->name] = [pass = passTransforms(),
                            odometry = handlers[tf->name]](const rosbag::MessageInstance& message) {
        pass(message);
        if (odometry) odometry(message);
      };
    }
    for (auto& entry : handlers)
      entry.second = [this, handler = entry.second](const rosbag::MessageInstance& message) {
        clock_->waitUntil(message.getTime(), stop_);
        handler(message);
      };
    return handlers;
  }

  /// All transforms but those into the map, which are the back-end's.
  BagHandler passTransforms() {
    return onMessage<tf2_msgs::TFMessage>([this](const tf2_msgs::TFMessage& message) {
      const auto kept = withoutMap(message, map_frame_);
      if (!kept.transforms.empty()) tf_.publish(kept);
    });
  }

  template <class Message>
  void send(const ros::Publisher& publisher, const std::string& input, const ros::Time& stamp,
            const Message& message) {
    if (!window_.waitForRoom(input, kPatience) && !stop_) {
      NODELET_WARN_STREAM_THROTTLE(10, publisher.getTopic()
                                           << ": nothing was acknowledged for 2 s; going on");
      window_.clear();
    }
    if (stop_) return;
    window_.sent(input, fromRos(stamp));
    publisher.publish(boost::make_shared<const Message>(message));  // by pointer within the manager
  }

  BagSourceConfig config_;
  TopicsConfig topics_;
  std::string map_frame_;
  std::unique_ptr<BagReader> bag_;
  BagInputs inputs_;
  std::unique_ptr<BagClock> clock_;
  FlowWindow window_{kInFlight};
  std::atomic<bool> stop_{false};
  ros::Publisher motion_, odom_, tf_, tf_static_, camera_info_;
  ros::Publisher observations_;  ///< or the images that they are made of
  ros::Subscriber progress_;
  std::thread thread_;
};

}  // namespace slam_ros

PLUGINLIB_EXPORT_CLASS(slam_ros::BagSourceNodelet, nodelet::Nodelet)
