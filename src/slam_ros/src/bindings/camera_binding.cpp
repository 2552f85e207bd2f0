// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <mutex>
#include <optional>

#include "slam_ros/after_load.hpp"
#include "slam_ros/camera_input.hpp"
#include "slam_ros/camera_topics.hpp"
#include "slam_ros/input_bindings.hpp"

// Images, raw or compressed, with the camera's calibration and mount.

namespace slam_ros {
namespace {

/// Both kinds of images are subscribed; the one that comes first stays.
class CameraBinding final : public InputBinding {
 public:
  CameraBinding(const InputContext& context, const slam::InputPort& port)
      : topics_(cameraTopics(context.topics.of(port.name))),
        pass_(context.pass),
        robot_file_has_mount_(context.mounts.has(port.name)),
        input_(frameId(context.frames.base), sinks(context, port)) {
    for (const auto& topic : {topics_.raw, topics_.compressed, topics_.info})
      context.handle.resolveName(topic);  // throws now what subscribing would throw later
    start_.emplace([this, handle = context.handle, transport = context.options.image_transport] {
      subscribe(handle, transport);
    });
  }
  ~CameraBinding() override {
    start_.reset();
    for (auto* subscriber : {&raw_, &compressed_, &info_, &transforms_}) subscriber->shutdown();
  }

  const std::string& topic() const override { return topics_.raw; }
  std::string waiting() const override {
    if (!input_.hasImage())
      return "waiting for images on " + topics_.raw + " or " + topics_.compressed;
    if (!input_.hasCalibration()) return "waiting for the camera's calibration on " + topics_.info;
    const auto transform = robot_file_has_mount_ ? "" : input_.missingTransform();
    if (!transform.empty()) return "waiting for the transform " + transform + " on /tf_static";
    return "";
  }

 private:
  CameraInput::Sinks sinks(const InputContext& context, const slam::InputPort& port) {
    const auto put = [this, name = port.name, put = context.put](const auto& data) {
      put(name, slam::kindOf<std::decay_t<decltype(data)>>(), &data, topic());
    };
    const auto take = [this, put](const slam::Image& image) {
      noteArrival();
      put(image);
    };
    return {take, put, put};
  }

  void subscribe(ros::NodeHandle handle, ImageTransport transport) {
    const std::lock_guard lock(kind_);
    const auto take = [this](const auto& message) { input_.take(message); };
    transforms_ = subscribeThrough<tf2_msgs::TFMessage>(pass_, handle, "/tf_static", kQueue, take);
    info_ = subscribeThrough<sensor_msgs::CameraInfo>(pass_, handle, topics_.info, kQueue, take);
    if (transport != ImageTransport::kCompressed)
      raw_ = subscribeImages<sensor_msgs::Image>(handle, topics_.raw, compressed_);
    if (transport != ImageTransport::kRaw)
      compressed_ = subscribeImages<sensor_msgs::CompressedImage>(handle, topics_.compressed, raw_);
  }

  template <class Message>
  ros::Subscriber subscribeImages(ros::NodeHandle handle, const std::string& topic,
                                  ros::Subscriber& other) {
    return subscribeThrough<Message>(pass_, handle, topic, kImageQueue,
                                     [this, &other](const Message& message) {
                                       {
                                         const std::lock_guard lock(kind_);
                                         other.shutdown();
                                       }
                                       input_.take(message);
                                     });
  }

  CameraTopics topics_;
  Pass pass_;
  bool robot_file_has_mount_;  ///< else it comes as a transform
  CameraInput input_;
  std::mutex kind_;  ///< held while it is found which of raw_ and compressed_ there are
  ros::Subscriber raw_, compressed_, info_, transforms_;
  std::optional<AfterLoad> start_;
};

/// Raw images come before compressed ones where both are of the name asked for.
class CameraInBag final : public BagInput {
 public:
  CameraInBag(const BagContext& context, const std::string& port)
      : CameraInBag(cameraTopics(context.topics.of(port)), port, context) {}

  std::vector<Input> names() const override { return {raw_, compressed_, info_}; }
  Remap meaningOf(Remap remap, const std::vector<BagTopic>& topics) const override;
  std::string howToAsk() const override {
    return "--remap " + raw_.name + ":=TOPIC has it look at that camera's images instead";
  }

  bool find(BagSearch& bag) override {
    const bool only_compressed = !bag.isNamed(raw_) && bag.isNamed(compressed_);
    images_ = only_compressed ? "" : bag.topic(raw_);
    is_raw_ = !images_.empty();
    if (!is_raw_) images_ = bag.topic(compressed_);
    calibration_ = images_.empty() ? "" : findCalibration(bag);
    return !images_.empty();
  }
  std::string need() const override { return needOf(raw_) + " or " + needOf(compressed_); }
  std::vector<std::string> topics() const override {
    if (calibration_.empty()) return {images_};
    return {images_, calibration_};
  }

  BagHandlers readers(const BagSinks& sinks) override {
    const auto put = [sinks](const auto& data) { sinks.give(data); };
    input_.emplace(base_frame_, CameraInput::Sinks{put, put, put});
    input_->take(sinks.static_transforms);
    const auto take = [this](const auto& message) { input_->take(message); };
    return handlers(is_raw_ ? onMessage<sensor_msgs::Image>(take)
                            : onMessage<sensor_msgs::CompressedImage>(take),
                    onMessage<sensor_msgs::CameraInfo>(take));
  }
  std::string lacking() const override {
    if (!input_->hasCalibration()) return images_ + " came without the camera's calibration";
    if (const auto fault = input_->fault(); !fault.empty())
      return images_ + " cannot be used: " + fault;
    return robot_file_has_mount_ ? "" : input_->lackOfMount();
  }

  BagPlay play() const override { return {kImagesInFlight, kImagesHeld, true}; }
  BagHandlers senders(ros::NodeHandle handle, const Gate& gate) override {
    const auto images =
        is_raw_ ? imageSender<sensor_msgs::Image>(handle, raw_.topic, gate)
                : imageSender<sensor_msgs::CompressedImage>(handle, compressed_.topic, gate);
    if (calibration_.empty()) return handlers(images, {});
    const auto info = advertise<sensor_msgs::CameraInfo>(handle, info_.topic, kQueue);
    const auto always = [](slam::Stamp) { return true; };
    return handlers(images, sender<sensor_msgs::CameraInfo>(info, always, HeaderStamp()));
  }

 private:
  CameraInBag(const CameraTopics& topics, const std::string& port, const BagContext& context)
      : raw_(inputOf<sensor_msgs::Image>(port, topics.raw)),
        compressed_(inputOf<sensor_msgs::CompressedImage>(port + "/compressed", topics.compressed)),
        info_(inputOf<sensor_msgs::CameraInfo>(port + "_info", topics.info)),
        base_frame_(frameId(context.frames.base)),
        robot_file_has_mount_(context.mounts.has(port)) {}

  std::string findCalibration(BagSearch& bag) const;
  BagHandlers handlers(BagHandler of_images, BagHandler of_calibration) const {
    BagHandlers handlers{{images_, std::move(of_images)}};
    if (!calibration_.empty()) handlers[calibration_] = std::move(of_calibration);
    return handlers;
  }
  template <class Message>
  BagHandler imageSender(ros::NodeHandle& handle, const std::string& topic, const Gate& gate) {
    return sender<Message>(advertise<Message>(handle, topic, kImageQueue), gate, HeaderStamp());
  }

  Input raw_, compressed_, info_;
  std::string base_frame_;
  bool robot_file_has_mount_;
  std::string images_, calibration_;  ///< topics of the bag
  bool is_raw_ = true;                ///< the images are
  std::optional<CameraInput> input_;
};

/// Who remaps a camera to compressed images means the input for those. Their topic may also be
/// given without its ending, where the bag has no raw images of that name.
Remap CameraInBag::meaningOf(Remap remap, const std::vector<BagTopic>& topics) const {
  auto& camera = sameTopic(remap.to, raw_.name) ? remap.to : remap.from;
  auto& topic = &camera == &remap.to ? remap.from : remap.to;
  if (!sameTopic(camera, raw_.name)) return remap;
  if (findTopic(topics, topic) == nullptr) {
    if (const auto compressed = cameraTopics(topic).compressed; findTopic(topics, compressed))
      topic = compressed;
  }
  if (const auto* found = findTopic(topics, topic); found && found->type == compressed_.type)
    camera = compressed_.name;
  return remap;
}

/// The topic of the bag, or an empty name. A calibration is never found by its type alone, since
/// that of another camera would be worse than none.
std::string CameraInBag::findCalibration(BagSearch& bag) const {
  if (bag.isRemapped(info_)) return bag.topic(info_);
  const auto beside = cameraTopics(images_).info;
  const auto* sibling = bag.find(beside);
  if (sibling != nullptr && sibling->messages > 0) return sibling->name;
  bag.warnings.push_back(
      fmt::format("the bag has no {} that calibrates the camera {}: nothing can be seen in its "
                  "images; name the topic with --remap {}:=TOPIC",
                  beside, images_, info_.name));
  return "";
}

const InputBindingRegistrar<slam::Image, CameraBinding, CameraInBag> kCameraBinding;

}  // namespace
}  // namespace slam_ros
