// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "slam_core/models/odometry_sample.hpp"
#include "slam_ros/after_load.hpp"
#include "slam_ros/input_bindings.hpp"
#include "slam_ros/odometry_edge.hpp"

// A wheel driver's odometry: its topic or the transform odom -> base of /tf, which is all that some
// robots tell.

namespace slam_ros {
namespace {

constexpr std::uint32_t kOdometryQueue = 1000;
constexpr char kTransforms[] = "/tf";

/// Empty, or a clause on the pose that could not be used.
std::string faultOf(const nav_msgs::Odometry& message) {
  const auto fault = saysNoPose(message) ? "" : poseFault(message);
  return fault.empty() ? "" : fault + "; its twist is used";
}

/// The transform is taken as long as nobody publishes the topic. Once that has a message, /tf is
/// left alone. Of odometry whose transform we publish ourselves only the topic counts, or what
/// others publish.
class OdometryBinding final : public InputBinding {
 public:
  OdometryBinding(const InputContext& context, const slam::InputPort& port)
      : name_(port.name),
        context_(context),
        topic_(context.topics.of(port.name)),
        edge_(frameId(context.frames.odom), frameId(context.frames.base)),
        source_(topic_) {
    context_.handle.resolveName(topic_);  // throws now what subscribing would throw later
    start_.emplace([this] { subscribe(); });
  }
  ~OdometryBinding() override {
    start_.reset();
    odom_.shutdown();
    tf_.shutdown();
  }

  /// Where the last message came from, or the topic that is waited for.
  const std::string& topic() const override { return source_; }
  std::string waiting() const override {
    if (got_message_) return "";
    const auto or_edge = context_.options.odometry_from_tf ? " or as the transform " + edge() : "";
    return "waiting for odometry on " + topic_ + or_edge;
  }

 private:
  void subscribe() {
    odom_ =
        subscribeThrough<nav_msgs::Odometry>(context_.pass, context_.handle, topic_, kOdometryQueue,
                                             [this](const auto& message) { onOdom(message); });
    if (context_.options.odometry_from_tf)
      tf_ = context_.handle.subscribe(kTransforms, kOdometryQueue, &OdometryBinding::onTransforms,
                                      this);
  }

  void onOdom(const nav_msgs::Odometry& message) {
    tf_.shutdown();
    got_message_ = true;
    source_ = topic_;
    take(message);
  }

  void onTransforms(const ros::MessageEvent<const tf2_msgs::TFMessage>& event) {
    const bool is_own = event.getPublisherName() == ros::this_node::getName();
    if (context_.options.publishes_odometry_edge && is_own) return;
    context_.pass(kTransforms, [&] { take(*event.getMessage()); });
  }

  void take(const tf2_msgs::TFMessage& message) {
    if (odom_.getNumPublishers() > 0 || !edge_.isIn(message)) return;
    if (!got_message_)
      ROS_INFO_STREAM("nobody publishes " << odom_.getTopic()
                                          << ": odometry is taken from the transform " << edge());
    got_message_ = true;
    source_ = kTransforms;
    edge_.take(message, [this](const auto& odometry) { take(odometry); });
  }

  void take(const nav_msgs::Odometry& message) {
    noteArrival();
    if (const auto fault = faultOf(message); !fault.empty()) context_.warn(topic() + ": " + fault);
    const auto sample = fromMsg(message);
    context_.put(name_, slam::kindOf<slam::OdometrySample>(), &sample, topic());
  }

  std::string edge() const {
    return frameId(context_.frames.odom) + " -> " + frameId(context_.frames.base);
  }

  std::string name_;
  InputContext context_;
  std::string topic_;
  OdometryEdge edge_;
  std::string source_;
  bool got_message_ = false;
  ros::Subscriber odom_, tf_;
  std::optional<AfterLoad> start_;
};

/// The topic comes before the transform.
class OdometryInBag final : public TopicInBag {
 public:
  OdometryInBag(const BagContext& context, const std::string& port)
      : TopicInBag(inputOf<nav_msgs::Odometry>(port, context.topics.of(port))),
        odom_frame_(frameId(context.frames.odom)),
        base_frame_(frameId(context.frames.base)) {}

  bool find(BagSearch& bag) override {
    is_edge_ = false;
    if (TopicInBag::find(bag)) return true;
    if (!edge_topic_) edge_topic_ = topicOfEdge(bag);
    topic_ = *edge_topic_;
    is_edge_ = !topic_.empty();
    if (is_edge_)
      bag.notes.push_back(fmt::format("odometry is taken from the transform {} -> {} of {}",
                                      odom_frame_, base_frame_, topic_));
    return is_edge_;
  }
  std::string need() const override {
    return fmt::format("{}, or the transform {} -> {} in /tf", TopicInBag::need(), odom_frame_,
                       base_frame_);
  }

  BagHandlers readers(const BagSinks& sinks) override {
    return handlers([sinks](const nav_msgs::Odometry& message) {
      if (const auto fault = faultOf(message); !fault.empty()) {
        sinks.count("odometry_without_pose");
        sinks.warn("odometry: " + fault);
      }
      sinks.give(fromMsg(message));
    });
  }
  BagHandlers senders(ros::NodeHandle handle, const Gate& gate) override {
    const auto publisher = advertise<nav_msgs::Odometry>(handle, input_.topic, kInFlight);
    return handlers([publisher, gate](const nav_msgs::Odometry& message) {
      if (gate(HeaderStamp()(message)))
        publisher.publish(boost::make_shared<const nav_msgs::Odometry>(message));
    });
  }

 private:
  /// The one of the bag's /tf that holds the transform, or an empty name.
  std::string topicOfEdge(const BagSearch& bag) const {
    const OdometryEdge edge(odom_frame_, base_frame_);
    for (const auto& topic : bag.topics()) {
      if (!sameTopic(topic.name, "tf") || !holdsTransforms(topic)) continue;
      bool found = false;
      const auto look = [&](const tf2_msgs::TFMessage& message) {
        found = found || edge.isIn(message);
      };
      bag.read({{topic.name, onMessage<tf2_msgs::TFMessage>(look)}},
               [&](std::size_t) { return !found; });
      if (found) return topic.name;
    }
    return "";
  }

  template <class Take>
  BagHandlers handlers(Take take) const {
    if (!is_edge_) return {{topic_, onMessage<nav_msgs::Odometry>(take)}};
    return {
        {topic_, onMessage<tf2_msgs::TFMessage>([edge = OdometryEdge(odom_frame_, base_frame_),
                                                 take](const tf2_msgs::TFMessage& message) mutable {
           edge.take(message, take);
         })}};
  }

  std::string odom_frame_, base_frame_;
  std::optional<std::string> edge_topic_;  ///< looked for once, since that reads the transforms
  bool is_edge_ = false;                   ///< topic_ holds transforms
};

const InputBindingRegistrar<slam::OdometrySample, OdometryBinding, OdometryInBag> kOdometryBinding;

}  // namespace
}  // namespace slam_ros
