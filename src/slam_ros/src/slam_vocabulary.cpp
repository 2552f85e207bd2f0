// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <iostream>
#include <string>
#include <vector>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/mono_graph/orb_extractor.hpp"
#include "slam_core/mono_graph/vocabulary.hpp"
#include "slam_ros/bag_reader.hpp"
#include "slam_ros/command_line.hpp"
#include "slam_ros/image_conversions.hpp"

namespace {

namespace mono_graph = slam::mono_graph;

struct Options {
  std::vector<std::string> bags;
  std::string topic = "/camera/image_raw", out;
  int every = 5, features = 500, branching = 10, depth = 4;
  std::uint64_t seed = 1;
};

using Descriptors = std::vector<std::vector<mono_graph::Descriptor>>;

/// Describes some of the images that it is given.
class ImageSampler {
 public:
  ImageSampler(const Options& options, Descriptors& images)
      : every_(options.every), orb_(options.features, 1.0), images_(images) {}

  template <class Message>
  slam_ros::BagHandler handler() {
    return slam_ros::onMessage<Message>([this](const Message& message) {
      if (seen_++ % every_ != 0) return;
      const auto image = slam_ros::fromMsg(message);
      if (image.gray.empty()) return;
      images_.emplace_back();
      orb_.describe(image.gray, images_.back());
    });
  }

 private:
  int every_, seen_ = 0;
  mono_graph::OrbExtractor orb_;
  Descriptors& images_;
};

void addImages(const std::string& path, const Options& options, Descriptors& images) {
  const slam_ros::BagReader bag(path);
  ImageSampler sampler(options, images);
  if (const auto* raw = bag.find(options.topic))
    return bag.read({{raw->name, sampler.handler<sensor_msgs::Image>()}});
  if (const auto* compressed = bag.find(options.topic + "/compressed"))
    return bag.read({{compressed->name, sampler.handler<sensor_msgs::CompressedImage>()}});
  throw std::runtime_error("the bag " + path + " has no topic " + options.topic +
                           ", nor a compressed one: give another with --topic");
}

void train(const Options& options) {
  Descriptors images;
  for (const auto& bag : options.bags) addImages(bag, options, images);
  if (images.empty()) throw std::runtime_error("the bags have no image that can be used");
  const auto vocabulary =
      mono_graph::Vocabulary::trained(images, options.branching, options.depth, options.seed);
  slam::writeFileAtomically(options.out, vocabulary.bytes());
  std::cout << fmt::format("{}: {} words of {} images\n", options.out, vocabulary.countOfWords(),
                           images.size());
}

}  // namespace

int main(int argc, char** argv) {
  slam_ros::CommandLine line(
      "slam_vocabulary",
      "Trains the vocabulary of visual words by which the back-end mono_graph recognises places, "
      "of the images of a camera in bags. The same bags and seed give the same file.");
  Options options;
  line.add("BAG", options.bags, "bags with images").required();
  line.add("--out", options.out, "the file to write").required();
  line.add("--topic", options.topic, "of the camera's images");
  line.add("--every", options.every, "take each so many-th image").between(1, 1000);
  line.add("--branching", options.branching, "children of a node of the tree").between(2, 100);
  line.add("--depth", options.depth, "levels of the tree").between(1, 8);
  line.add("--seed", options.seed, "of the random numbers");
  return line.run(argc, argv, [&] { train(options); });
}
