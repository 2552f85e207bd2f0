// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>
#include <vector>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/mono_graph/orb_extractor.hpp"
#include "slam_core/mono_graph/vocabulary.hpp"
#include "slam_ros/bag_reader.hpp"
#include "slam_ros/image_conversions.hpp"

namespace {

namespace mono_graph = slam::mono_graph;

constexpr int kFailed = 1, kWrongUse = 2;

int fail(const std::string& sentence, int code) {
  std::cerr << "slam_vocabulary: " << sentence << std::endl;
  return code;
}

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
  CLI::App app(
      "Trains the vocabulary of visual words by which the back-end mono_graph recognises places, "
      "of "
      "the images of a camera in bags. The same bags and seed give the same file.",
      "slam_vocabulary");
  Options options;
  app.add_option("BAG", options.bags, "bags with images")->required();
  app.add_option("--out", options.out, "the file to write")->required();
  app.add_option("--topic", options.topic, "of the camera's images");
  app.add_option("--every", options.every, "take each so many-th image")
      ->check(CLI::Range(1, 1000));
  app.add_option("--branching", options.branching, "children of a node of the tree")
      ->check(CLI::Range(2, 100));
  app.add_option("--depth", options.depth, "levels of the tree")->check(CLI::Range(1, 8));
  app.add_option("--seed", options.seed, "of the random numbers");
  try {
    app.parse(argc, argv);
    train(options);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail(std::string(error.what()) + "; --help lists the arguments", kWrongUse);
  } catch (const std::exception& error) {
    return fail(error.what(), kFailed);
  }
  return 0;
}
