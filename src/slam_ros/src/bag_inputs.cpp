// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_inputs.hpp"

#include <fmt/format.h>
#include <ros/message_traits.h>

#include <algorithm>
#include <iterator>

#include "slam_core/common/nearest_name.hpp"
#include "slam_core/models/filter_pose.hpp"
#include "slam_core/product/product_components.hpp"
#include "slam_ros/bag_transforms.hpp"
#include "slam_ros/camera_topics.hpp"
#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

template <class Message>
Input input(const std::string& name, const std::string& topic) {
  return {name, topic, ros::message_traits::DataType<Message>::value(),
          ros::message_traits::MD5Sum<Message>::value()};
}

/// Searches the bag for one input after the other and notes what it finds.
class Search {
 public:
  Search(const BagReader& bag, const std::vector<Input>& inputs, const std::vector<Remap>& remaps)
      : bag_(bag), inputs_(inputs), remaps_(remaps) {
    checkRemaps(remaps_, inputs, bag.topics());
  }

  /// The bag's topic for an input, or an empty name.
  std::string topic(const std::string& name, std::vector<std::string>& notes) const {
    const auto match = matchTopic(entry(name), inputs_, bag_.topics(), remaps_);
    if (match && !match->note.empty()) notes.push_back(match->note);
    return match ? match->topic : "";
  }

  bool isRemapped(const std::string& name) const {
    return std::any_of(remaps_.begin(), remaps_.end(), [&](const auto& remap) {
      return sameTopic(remap.from, name) || sameTopic(remap.to, name);
    });
  }

  /// Whether the bag has the input under its own name or a remapped one: its type need not tell.
  bool isNamed(const std::string& name) const {
    const auto& wanted = entry(name);
    const auto* topic = bag_.find(wanted.topic);
    return isRemapped(name) ||
           (topic != nullptr && topic->messages > 0 && topic->type == wanted.type);
  }

  bool knows(const std::string& name) const {
    return std::any_of(inputs_.begin(), inputs_.end(),
                       [&](const auto& input) { return input.name == name; });
  }

  std::string need(const std::string& name) const {
    return fmt::format("'{}' ({})", entry(name).topic, entry(name).type);
  }

 private:
  const Input& entry(const std::string& name) const {
    return *std::find_if(inputs_.begin(), inputs_.end(),
                         [&](const auto& input) { return input.name == name; });
  }

  const BagReader& bag_;
  const std::vector<Input>& inputs_;
  std::vector<Remap> remaps_;
};

/// What one camera's inputs are called.
struct CameraNames {
  const char *image, *compressed, *info;
};
constexpr CameraNames kCamera{"camera", "camera/compressed", "camera_info"};
constexpr CameraNames kCeilingCamera{"ceiling_camera", "ceiling_camera/compressed",
                                     "ceiling_camera_info"};

/// A camera that is remapped to compressed images, also where only they have the name's beginning,
/// is the input for those.
std::vector<Remap> forCompressedImages(std::vector<Remap> remaps, const CameraNames& names,
                                       const BagReader& bag) {
  const auto type = ros::message_traits::DataType<sensor_msgs::CompressedImage>::value();
  for (auto& remap : remaps) {
    auto& camera = sameTopic(remap.to, names.image) ? remap.to : remap.from;
    auto& topic = &camera == &remap.to ? remap.from : remap.to;
    if (!sameTopic(camera, names.image)) continue;
    if (bag.find(topic) == nullptr) {
      if (const auto compressed = cameraTopics(topic).compressed; bag.find(compressed) != nullptr)
        topic = compressed;
    }
    if (const auto* found = bag.find(topic); found != nullptr && found->type == type)
      camera = names.compressed;
  }
  return remaps;
}

BagCamera findCamera(const BagReader& bag, const Search& search, const CameraNames& names,
                     BagInputs& inputs) {
  BagCamera camera;
  const bool only_compressed = !search.isNamed(names.image) && search.isNamed(names.compressed);
  if (!only_compressed) camera.image = search.topic(names.image, inputs.notes);
  if (camera.image.empty()) camera.compressed_image = search.topic(names.compressed, inputs.notes);
  if (!camera.hasImages()) return camera;
  const auto& image = camera.image.empty() ? camera.compressed_image : camera.image;
  const auto* sibling = bag.find(cameraTopics(image).info);
  // another camera's calibration would be worse than none: the type alone does not tell
  if (search.isRemapped(names.info))
    camera.camera_info = search.topic(names.info, inputs.notes);
  else if (sibling != nullptr && sibling->messages > 0)
    camera.camera_info = sibling->name;
  else
    inputs.warnings.push_back(fmt::format(
        "the bag has no {} that calibrates the camera {}: nothing can be seen in its images; name "
        "the topic with --remap {}:=TOPIC",
        cameraTopics(image).info, image, names.info));
  return camera;
}

/// An input that the odometry source shares with others and that the bag has, or an empty name: the
/// source makes motion of it, whatever else the bag carries.
std::string sharedWithOdometry(const Search& search, const InputNeeds& needs) {
  std::vector<std::string> notes;
  for (const auto& input : needs.of_odometry)
    if (!needs.isOfOdometryAlone(input) && search.knows(input) &&
        !search.topic(input, notes).empty())
      return input;
  return "";
}

void findOdometry(const BagReader& bag, const Search& search, const InputNeeds& needs,
                  BagInputs& inputs) {
  inputs.motion = search.topic("motion", inputs.notes);
  const auto shared = inputs.motion.empty() ? "" : sharedWithOdometry(search, needs);
  if (!shared.empty()) {
    inputs.notes.push_back(
        fmt::format("the motion that the bag carries is left out: the odometry source makes it of "
                    "the input '{}', which others take as well",
                    shared));
    inputs.motion.clear();
  }
  if (!inputs.motion.empty()) {
    inputs.notes.push_back("the bag carries motion: the odometry component is left out");
    return;
  }
  if (needs.ceiling) inputs.ceiling = findCamera(bag, search, kCeilingCamera, inputs);
  if (!needs.wheels) return;
  inputs.odom = search.topic("odom", inputs.notes);
  if (!inputs.odom.empty()) return;
  inputs.tf = findOdometryEdge(bag, inputs.odom_frame, inputs.base_frame);
  if (!inputs.tf.empty())
    inputs.notes.push_back(fmt::format("odometry is taken from the transform {} -> {} of {}",
                                       inputs.odom_frame, inputs.base_frame, inputs.tf));
}

}  // namespace

std::vector<Input> inputsOf(const TopicsConfig& topics,
                            const std::vector<slam::InputPort>& others) {
  const auto camera = cameraTopics(topics.camera), ceiling = cameraTopics(topics.ceiling_camera);
  std::vector<Input> inputs = {
      input<slam_msgs::Motion>("motion", topics.motion),
      input<nav_msgs::Odometry>("odom", topics.odom),
      input<slam_msgs::LandmarkObservationArray>("observations", topics.observations),
      input<sensor_msgs::Image>(kCamera.image, camera.raw),
      input<sensor_msgs::CompressedImage>(kCamera.compressed, camera.compressed),
      input<sensor_msgs::CameraInfo>(kCamera.info, camera.info),
      input<sensor_msgs::Image>(kCeilingCamera.image, ceiling.raw),
      input<sensor_msgs::CompressedImage>(kCeilingCamera.compressed, ceiling.compressed),
      input<sensor_msgs::CameraInfo>(kCeilingCamera.info, ceiling.info),
      input<sensor_msgs::LaserScan>("scan", topics.scan)};
  for (const auto& port : others) {
    const auto* binding = BagBindings::instance().find(port.kind);
    inputs.push_back({port.name, topics.of(port.name), binding->type, binding->md5sum});
  }
  return inputs;
}

namespace {

/// A message brings it, and it is none of the kinds that all products know.
bool isOther(const slam::InputPort& port) {
  return port.kind != slam::kindOf<slam::Motion>() &&
         port.kind != slam::kindOf<slam::FilterPose>() &&
         port.kind != slam::kindOf<slam::LandmarkObservationArray>() &&
         BagBindings::instance().find(port.kind) != nullptr;
}

std::set<std::string> namesOf(const slam::ProductConfig& product, const slam::ProductPart& part) {
  std::set<std::string> names;
  for (const auto& input : slam::inputsOf(product, part)) names.insert(input.name);
  return names;
}

void setTakers(const slam::ProductConfig& product, InputNeeds& needs) {
  using Extent = slam::ProductPart::Extent;
  needs.of_backend = namesOf(product, {Extent::kBackend, ""});
  needs.of_odometry = namesOf(product, {Extent::kOdometry, ""});
  needs.of_detector = namesOf(product, {Extent::kDetector, ""});
  for (const auto& [name, is_wanted] : product.modules)
    if (is_wanted) needs.of_modules.merge(namesOf(product, {Extent::kModule, name}));
}

}  // namespace

bool InputNeeds::isOfOdometryAlone(const std::string& input) const {
  return of_odometry.count(input) > 0 &&
         of_backend.count(input) + of_detector.count(input) + of_modules.count(input) == 0;
}

InputNeeds needsOf(const slam::ProductConfig& product) {
  const auto inputs = slam::inputsOf(product);
  const auto find = [&](const char* name) {
    return std::find_if(inputs.begin(), inputs.end(),
                        [&](const auto& input) { return input.name == name; });
  };
  const auto has = [&](const char* name) { return find(name) != inputs.end(); };
  InputNeeds needs;
  needs.images = has("camera");
  needs.scans = has("scan");
  needs.landmarks = has("observations") && find("observations")->is_mandatory;
  needs.wheels = has("odom");
  needs.ceiling = has("ceiling_camera");
  needs.motion = has("motion");
  std::copy_if(inputs.begin(), inputs.end(), std::back_inserter(needs.others), isOther);
  setTakers(product, needs);
  return needs;
}

namespace {

/// Whether nobody needs an input, since the bag carries what is made of it.
bool isLeftOut(const std::string& input, const BagInputs& inputs, const InputNeeds& needs) {
  return !inputs.motion.empty() && needs.isOfOdometryAlone(input);
}

/// What the product cannot do without, a text each.
std::vector<std::string> missingOf(const BagInputs& inputs, const InputNeeds& needs,
                                   const Search& search) {
  const auto images = [&](const CameraNames& names) {
    return search.need(names.image) + " or " + search.need(names.compressed);
  };
  std::vector<std::string> missing;
  const bool has_odometry = !inputs.odom.empty() || !inputs.tf.empty();
  if (needs.motion && inputs.motion.empty() && needs.wheels && !has_odometry)
    missing.push_back(fmt::format("odometry: {}, or the transform {} -> {} in /tf",
                                  search.need("odom"), inputs.odom_frame, inputs.base_frame));
  if (needs.motion && inputs.motion.empty() && needs.ceiling && !inputs.ceiling.hasImages())
    missing.push_back("images of the ceiling: " + images(kCeilingCamera));
  if (needs.scans && inputs.scan.empty() && !isLeftOut("scan", inputs, needs))
    missing.push_back("laser scans: " + search.need("scan"));
  if (needs.landmarks && inputs.observations.empty() && !inputs.hasImages())
    missing.push_back("landmarks: " + search.need("observations") +
                      (needs.images ? ", or images: " + images(kCamera) : ""));
  for (const auto& port : needs.others)
    if (port.is_mandatory && inputs.others.count(port.name) == 0 &&
        !isLeftOut(port.name, inputs, needs))
      missing.push_back(port.sentence + ": " + search.need(port.name));
  return missing;
}

}  // namespace

BagInputs findInputs(const BagReader& bag, const InputNeeds& needs,
                     const std::vector<Remap>& remaps) {
  const auto all = inputsOf(needs.topics, needs.others);
  const Search search(
      bag, all,
      forCompressedImages(forCompressedImages(remaps, kCamera, bag), kCeilingCamera, bag));
  BagInputs inputs;
  inputs.odom_frame = frameId(needs.frames.odom);
  inputs.base_frame = frameId(needs.frames.base);
  if (needs.motion) findOdometry(bag, search, needs, inputs);
  const bool asked_for_images =
      needs.images && (search.isRemapped(kCamera.image) || search.isRemapped(kCamera.compressed));
  if (!asked_for_images) inputs.observations = search.topic("observations", inputs.notes);
  if (needs.images && !inputs.observations.empty())
    inputs.notes.push_back(
        "the bag carries observations: the detector is left out; --remap camera:=TOPIC has it look "
        "at that camera's images instead");
  else if (needs.images)
    static_cast<BagCamera&>(inputs) = findCamera(bag, search, kCamera, inputs);
  if (needs.scans && !isLeftOut("scan", inputs, needs))
    inputs.scan = search.topic("scan", inputs.notes);
  for (const auto& port : needs.others) {
    if (isLeftOut(port.name, inputs, needs)) continue;
    if (const auto topic = search.topic(port.name, inputs.notes); !topic.empty())
      inputs.others.emplace(port.name, BagInputs::Other{topic, port.kind});
  }
  if (const auto missing = missingOf(inputs, needs, search); !missing.empty())
    throw TopicError(fmt::format("the bag {} lacks {}; it has {}", bag.path(),
                                 slam::join(missing, " and "), listTopics(bag.topics())));
  return inputs;
}

BagHandlers handlersFor(const BagInputs& inputs, const InputSinks& sinks) {
  BagHandlers handlers;
  const auto add = [&](const std::string& topic, auto message, const auto& sink) {
    if (!topic.empty()) handlers[topic] = onMessage<decltype(message)>(sink);
  };
  add(inputs.motion, slam_msgs::Motion(), sinks.motion);
  add(inputs.odom, nav_msgs::Odometry(), sinks.odom);
  add(inputs.observations, slam_msgs::LandmarkObservationArray(), sinks.observations);
  add(inputs.scan, sensor_msgs::LaserScan(), sinks.scan);
  const auto add_camera = [&](const BagCamera& camera, const CameraSinks& camera_sinks) {
    add(camera.image, sensor_msgs::Image(), camera_sinks.image);
    add(camera.compressed_image, sensor_msgs::CompressedImage(), camera_sinks.compressed_image);
    add(camera.camera_info, sensor_msgs::CameraInfo(), camera_sinks.camera_info);
  };
  add_camera(inputs, sinks);
  add_camera(inputs.ceiling, sinks.ceiling);
  for (const auto& [name, other] : inputs.others)
    handlers[other.topic] =
        sinks.other(name, other.kind, *BagBindings::instance().find(other.kind));
  if (!inputs.tf.empty())
    handlers[inputs.tf] = odometryOfEdge(inputs.odom_frame, inputs.base_frame, sinks.odom);
  return handlers;
}

}  // namespace slam_ros
