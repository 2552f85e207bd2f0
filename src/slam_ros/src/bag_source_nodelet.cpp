// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ros/ros.h>
// ros.h comes first: nodelet.h only declares what it uses
#include <nodelet/nodelet.h>
#include <signal.h>
#include <slam_msgs/Progress.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "slam_ros/after_load.hpp"
#include "slam_ros/bag_clock.hpp"
#include "slam_ros/bag_inputs.hpp"
#include "slam_ros/bag_transforms.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/flow_window.hpp"
#include "slam_ros/input_publishers.hpp"
#include "slam_ros/parameters_from_ros.hpp"
#include "slam_ros/queue_sizes.hpp"
#include "slam_ros/report_failure.hpp"
#include "slam_ros/settings_from_ros.hpp"

namespace slam_ros {
namespace {

constexpr FlowWindow::Timeout kPatience(5000);
const ros::WallDuration kPoll(0.05);
// what is acknowledged, beside "motion" and "observations"
constexpr const char* kScans = "scans";
constexpr const char* kPointMapScans = "scans for the point map";
constexpr const char* kPointMapMotion = "motion for the point map";
constexpr const char* kPointMapPose = "poses for the point map";

}  // namespace

struct BagSourceConfig {
  static constexpr const char* kSection = "";

  std::string bag;
  double rate = 0.0;
  bool publish_clock = true;
  bool exit_at_end = true;
  bool odometry_tf = true;
  bool pointmap = false;
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
    window_.stop();
    if (thread_.joinable()) thread_.join();
  }

 private:
  void onInit() override {
    reportFailure(getName(), [this] {
      config_ = parametersFromRos<BagSourceConfig>(getPrivateNodeHandle());
      auto settings = settingsFromRos(getNodeHandle());
      const auto product = settings.read<slam::ProductConfig>();
      slam::loadLibraries(product.libraries);
      auto needs = needsOf(product);
      needs.topics = settings.read<TopicsConfig>();
      needs.frames = settings.read<slam::FramesConfig>();
      topics_ = needs.topics;
      map_frame_ = frameId(needs.frames.map);
      bag_ = std::make_unique<BagReader>(config_.bag);
      std::vector<Remap> remaps;
      for (const auto& text : config_.remaps) remaps.push_back(parseRemap(text));
      inputs_ = findInputs(*bag_, needs, remaps);
      setAnswers(needs);
      const bool has_landmarks = inputs_.hasImages() || !inputs_.observations.empty();
      if (needs.of_backend.count("scan") > 0 && has_landmarks)
        max_ahead_ = slam::durationFromSeconds(product.source_timeout / 2);
      for (const auto& note : inputs_.notes) NODELET_INFO_STREAM(note);
      for (const auto& warning : inputs_.warnings) NODELET_WARN_STREAM(warning);
      clock_ = std::make_unique<BagClock>(getNodeHandle(), config_.rate, config_.publish_clock);
      connect(getNodeHandle());
    });
    // acknowledgements would wait while the queue is off
    start_.emplace([this] { thread_ = std::thread([this] { play(); }); });
  }

  void connect(ros::NodeHandle handle) {
    publishers_.emplace(handle, topics_, inputs_, [this](const std::string& input, auto stamp) {
      const auto answers = answers_.find(input);
      return answers == answers_.end() ? waitForRoom(input, stamp)
                                       : waitForRoomOf(answers->second, stamp);
    });
    if (inputs_.hasImages()) inputs_of_few_.insert("observations");
    if (inputs_.ceiling.hasImages()) inputs_of_few_.insert("motion");
    for (const auto& input : inputs_of_few_) window_.limit(input, kImagesInFlight);
    for (const auto* input : {kScans, kPointMapScans}) window_.limit(input, kScansInFlight);
    if (hasAnswer(kScans, "motion")) window_.limit("motion", kScansInFlight);
    tf_ = handle.advertise<tf2_msgs::TFMessage>("/tf", kInFlight);
    progress_ = handle.subscribe("progress", 10 * kInFlight, &BagSourceNodelet::onProgress, this);
    if (config_.pointmap)
      point_map_progress_ = handle.subscribe("pointmap/progress", 10 * kInFlight,
                                             &BagSourceNodelet::onPointMapProgress, this);
  }

  /// The back-end acknowledges what it takes itself; of what others take, what they make of it.
  void setAnswers(const InputNeeds& needs) {
    const auto set = [&](const std::string& port, const std::string& input) {
      auto& answers = answers_[input];
      if (needs.of_odometry.count(port) > 0) answers.push_back("motion");
      if (needs.of_detector.count(port) > 0) answers.push_back("observations");
      if (needs.of_backend.count(port) > 0) answers.push_back(input);
    };
    set("scan", kScans);
    for (const auto& port : needs.others) set(port.name, port.name);
    auto& of_scans = answers_[kScans];
    // in one process with the point map it is the product's nodelet that takes them
    if (of_scans.empty() && !config_.pointmap) of_scans.push_back(kScans);
    if (config_.pointmap) of_scans.insert(of_scans.begin(), kPointMapScans);
  }

  bool hasAnswer(const std::string& input, const std::string& answer) const {
    const auto& answers = answers_.at(input);
    return std::find(answers.begin(), answers.end(), answer) != answers.end();
  }

  void onProgress(const slam_msgs::Progress& message) {
    if (config_.pointmap) expectOfPointMap(message);
    window_.acknowledged("motion", fromRos(message.motion));
    window_.acknowledged("observations", fromRos(message.observations));
    window_.acknowledged(kScans, fromRos(message.scans));
    for (std::size_t i = 0; i < std::min(message.inputs.size(), message.newest.size()); ++i)
      window_.acknowledged(message.inputs[i], fromRos(message.newest[i]));
  }

  /// What the back-end has had and has told must reach the point map as well.
  void expectOfPointMap(const slam_msgs::Progress& message) {
    // it may have been faster than this message
    if (message.motion > told_.motion && message.motion > point_map_told_.motion)
      window_.sent(kPointMapMotion, fromRos(message.motion));
    if (message.step > told_.step && message.step > point_map_told_.step)
      window_.sent(kPointMapPose, fromRos(message.step));
    told_ = message;
  }

  void onPointMapProgress(const slam_msgs::Progress& message) {
    point_map_told_ = message;
    window_.acknowledged(kPointMapScans, fromRos(message.scans));
    window_.acknowledged(kPointMapMotion, fromRos(message.motion));
    window_.acknowledged(kPointMapPose, fromRos(message.step));
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
    // without it images and scans would wait for their sensor's mount
    const bool has_mounts =
        inputs_.hasImages() || inputs_.ceiling.hasImages() || !inputs_.scan.empty();
    if (has_mounts && tf_static_ && tf_static_.getNumSubscribers() == 0)
      return "a subscriber of " + tf_static_.getTopic();
    const auto subscriber = publishers_->missingSubscriber();
    if (!subscriber.empty()) return subscriber;
    if (progress_.getNumPublishers() == 0)
      return "a back-end that publishes " + progress_.getTopic();
    if (point_map_progress_ && point_map_progress_.getNumPublishers() == 0)
      return "a point map that publishes " + point_map_progress_.getTopic();
    return "";
  }

  BagHandlers handlers() {
    auto handlers = handlersFor(inputs_, publishers_->sinks());
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
      auto kept = withoutMap(message, map_frame_);
      if (!config_.odometry_tf) kept = withoutEdge(kept, inputs_.odom_frame, inputs_.base_frame);
      if (!kept.transforms.empty()) tf_.publish(kept);
    });
  }

  /// For an input that several take. @return as waitForRoom()
  bool waitForRoomOf(const std::vector<std::string>& answers, slam::Stamp stamp) {
    return std::all_of(answers.begin(), answers.end(),
                       [&](const auto& answer) { return waitForRoom(answer, stamp); });
  }

  /// @return false when the nodelet is being unloaded
  bool waitForRoom(const std::string& input, slam::Stamp stamp) {
    // else the source that takes longest would be taken for a silent one
    if (max_ahead_ && !window_.waitForAllBefore(stamp - *max_ahead_, kPatience)) max_ahead_.reset();
    if (!window_.waitForRoom(input, kPatience) && !stop_) {
      if (inputs_of_few_.erase(input) > 0) {  // their calibration or mount may come later
        window_.limit(input, kImagesHeld);
        return waitForRoom(input, stamp);
      }
      NODELET_WARN_STREAM("nothing of the " << input << " sent was acknowledged for 5 s; going on");
      window_.clear();
    }
    if (!stop_) window_.sent(input, stamp);
    return !stop_;
  }

  BagSourceConfig config_;
  TopicsConfig topics_;
  std::string map_frame_;
  std::unique_ptr<BagReader> bag_;
  BagInputs inputs_;
  std::unique_ptr<BagClock> clock_;
  FlowWindow window_{kInFlight};
  std::optional<slam::Duration> max_ahead_;  ///< of stamps, where scans and landmarks wait together
  /// What is acknowledged for an input, where that is not the input itself alone.
  std::map<std::string, std::vector<std::string>> answers_;
  std::set<std::string> inputs_of_few_;  ///< of images that have not been waited for in vain
  std::atomic<bool> stop_{false};
  std::optional<InputPublishers> publishers_;
  ros::Publisher tf_, tf_static_;
  ros::Subscriber progress_, point_map_progress_;
  slam_msgs::Progress told_, point_map_told_;  ///< by the back-end and the point map, last
  std::thread thread_;
  std::optional<AfterLoad> start_;
};

}  // namespace slam_ros

PLUGINLIB_EXPORT_CLASS(slam_ros::BagSourceNodelet, nodelet::Nodelet)
