// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>
#include <ros/topic_manager.h>
#include <signal.h>
#include <slam_msgs/Progress.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>
#include <thread>
#include <vector>

#include "slam_ros/after_load.hpp"
#include "slam_ros/bag_clock.hpp"
#include "slam_ros/bag_flow.hpp"
#include "slam_ros/bag_inputs.hpp"
#include "slam_ros/bag_transforms.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/odometry_edge.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/settings_from_ros.hpp"

namespace slam_ros {
namespace {

const ros::WallDuration kPoll(0.05);

}  // namespace

struct BagSourceConfig {
  static constexpr const char* kSection = "";

  std::string bag;
  double rate = 0.0;
  bool publish_clock = true;
  bool exit_at_end = true;
  bool odometry_tf = true;
  bool pointmap = false;
  bool components = false;
  std::vector<std::string> remaps;

  void describe(slam::Fields& fields) {
    fields.add("bag", &bag, "the recorded data");
    fields.add("rate", &rate, "times the recorded speed; 0: as fast as the back-end takes it")
        .unit("1")
        .in(slam::Range::atLeast(0));
    fields.add("publish_clock", &publish_clock, "/clock from the bag's times");
    fields.add("exit_at_end", &exit_at_end, "ends the process when the bag is through");
    fields.add("odometry_tf", &odometry_tf,
               "the bag's transform of the odometry too; not where the product publishes it");
    fields.add("pointmap", &pointmap, "scans wait for the point map's nodelet too");
    fields.add("components", &components, "the product's components are nodelets of their own");
    fields.add("remaps", &remaps, "input:=topic of the bag");
  }
};

/// Plays a bag to the product's inputs and sends no more than the back-end has acknowledged, so
/// that nothing is dropped however fast it goes.
class BagSourceNodelet : public nodelet::Nodelet {
 public:
  ~BagSourceNodelet() override {
    start_.reset();
    stop_ = true;
    if (flow_) flow_->stop();
    if (thread_.joinable()) thread_.join();
  }

 private:
  void onInit() override {
    reportFailure(getName(), [this] {
      config_ = parametersFromRos<BagSourceConfig>(getPrivateNodeHandle());
      auto settings = settingsFromRos(getNodeHandle());
      slam::ProductConfig product;
      slam::readProduct(settings, product);
      const BagContext context{settings.read<TopicsConfig>(), settings.read<slam::FramesConfig>(),
                               GivenMounts(settings)};
      frames_ = context.frames;
      topics_ = context.topics;
      bag_ = std::make_unique<BagReader>(config_.bag);
      inputs_.emplace(*bag_, slam::createComponents(product), context, parseRemaps(config_.remaps));
      for (const auto& note : inputs_->notes()) NODELET_INFO_STREAM(note);
      for (const auto& warning : inputs_->warnings()) NODELET_WARN_STREAM(warning);
      flow_.emplace(
          *inputs_,
          BagFlow::Options{config_.pointmap, slam::durationFromSeconds(product.source_timeout),
                           [this](const auto& warning) { NODELET_WARN_STREAM(warning); }});
      clock_ = std::make_unique<BagClock>(getNodeHandle(), config_.rate, config_.publish_clock);
      connect(getNodeHandle());
    });
    // acknowledgements would wait while the queue is off
    start_.emplace([this] { thread_ = std::thread([this] { play(); }); });
  }

  void connect(ros::NodeHandle handle) {
    senders_ = inputs_->senders(
        handle, [this](const BagInputs::Found& input) { return flow_->gateOf(input); });
    tf_ = handle.advertise<tf2_msgs::TFMessage>("/tf", kInFlight);
    progress_ = subscribe(handle, "progress", &BagFlow::acknowledge);
    if (config_.pointmap)
      point_map_progress_ = subscribe(handle, "pointmap/progress", &BagFlow::acknowledgeOfPointMap);
  }

  ros::Subscriber subscribe(ros::NodeHandle& handle, const std::string& topic,
                            void (BagFlow::*take)(const slam_msgs::Progress&)) {
    return handle.subscribe<slam_msgs::Progress>(
        topic, 10 * kInFlight,
        [this, take](const slam_msgs::ProgressConstPtr& message) { ((*flow_).*take)(*message); });
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
    if (const auto lost = flow_->finish(); lost > 1)
      NODELET_WARN_STREAM(lost << " messages at the bag's end were not acknowledged");
    NODELET_INFO_STREAM(bag_->path() << " is through");
    // as Ctrl-C does: the manager unloads the nodelets, which completes their files
    if (config_.exit_at_end && !stop_) ::kill(::getpid(), SIGINT);
  }

  void publishStaticTransforms() {
    const auto transforms = staticTransforms(*bag_, frameId(frames_.map));
    if (transforms.transforms.empty()) return;
    tf_static_ = getNodeHandle().advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
    tf_static_.publish(boost::make_shared<const tf2_msgs::TFMessage>(transforms));
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
    return !stop_;
  }

  std::string missingPartner() const {
    for (const auto& found : inputs_->found()) {
      // without it images and scans would wait for their sensor's mount
      if (found.input->play().needs_transforms && isLonely(tf_static_))
        return "a subscriber of " + tf_static_.getTopic();
      for (const auto& publisher : found.input->publishers())
        if (isLonely(publisher)) return "a subscriber of " + publisher.getTopic();
    }
    if (const auto maker = missingMaker(); !maker.empty()) return maker;
    if (progress_.getNumPublishers() == 0)
      return "a back-end that publishes " + progress_.getTopic();
    if (point_map_progress_ && point_map_progress_.getNumPublishers() == 0)
      return "a point map that publishes " + point_map_progress_.getTopic();
    return "";
  }

  /// A component advertises what it makes once it takes in what it makes that of. What it makes
  /// before others are connected with it would be lost.
  std::string missingMaker() const {
    if (!config_.components) return "";
    ros::master::V_TopicInfo published;
    ros::master::getTopics(published);
    const auto isPublished = [&published](const std::string& topic) {
      return std::any_of(published.begin(), published.end(),
                         [&](const ros::master::TopicInfo& info) { return info.name == topic; });
    };
    for (const auto& part : inputs_->parts()) {
      if (!part.is_maker) continue;
      for (const auto& output : inputs_->flow().takenOutputs(part)) {
        const auto topic = getNodeHandle().resolveName(topics_.of(output.name));
        if (!isPublished(topic)) return "a component that publishes " + topic;
        if (isLonelyHere(topic)) return "a subscriber of " + topic;
      }
    }
    return "";
  }

  /// Whether this process publishes a topic that nobody subscribes to. The master knows of topics
  /// of other processes and machines, but not who is connected with them.
  static bool isLonelyHere(const std::string& topic) {
    const auto& topics = ros::TopicManager::instance();
    std::vector<std::string> advertised;
    topics->getAdvertisedTopics(advertised);
    return std::find(advertised.begin(), advertised.end(), topic) != advertised.end() &&
           topics->getNumSubscribers(topic) == 0;
  }

  static bool isLonely(const ros::Publisher& publisher) {
    return publisher && publisher.getNumSubscribers() == 0;
  }

  BagHandlers handlers() {
    auto handlers = senders_;
    if (const auto* tf = bag_->find("tf"); tf != nullptr && holdsTransforms(*tf)) {
      handlers[tf->name] = [pass = passTransforms(),
                            odometry = handlers[tf->name]](const BagMessage& message) {
        pass(message);
        if (odometry) odometry(message);
      };
    }
    for (auto& entry : handlers)
      entry.second = [this, handler = entry.second](const BagMessage& message) {
        clock_->waitUntil(message.time, stop_);
        handler(message);
      };
    return handlers;
  }

  /// All transforms but those that the product publishes itself.
  BagHandler passTransforms() {
    return onMessage<tf2_msgs::TFMessage>([this](const tf2_msgs::TFMessage& message) {
      auto kept = withoutMap(message, frameId(frames_.map));
      if (!config_.odometry_tf)
        kept = withoutEdge(kept, frameId(frames_.odom), frameId(frames_.base));
      if (!kept.transforms.empty()) tf_.publish(kept);
    });
  }

  BagSourceConfig config_;
  slam::FramesConfig frames_;
  TopicsConfig topics_;
  std::unique_ptr<BagReader> bag_;
  std::optional<BagInputs> inputs_;
  std::optional<BagFlow> flow_;
  BagHandlers senders_;
  std::unique_ptr<BagClock> clock_;
  std::atomic<bool> stop_{false};
  ros::Publisher tf_, tf_static_;
  ros::Subscriber progress_, point_map_progress_;
  std::thread thread_;
  std::optional<AfterLoad> start_;
};

}  // namespace slam_ros

PLUGINLIB_EXPORT_CLASS(slam_ros::BagSourceNodelet, nodelet::Nodelet)
