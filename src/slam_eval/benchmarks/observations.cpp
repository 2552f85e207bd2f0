// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes what a product's landmark detector sees in a bag as a bag of observations, so that many
// runs of a back-end need not detect the same landmarks again.

#include <stdexcept>
#include <vector>

#include "slam_core/common/settings.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_ros/bag_file.hpp"
#include "slam_ros/bag_inputs.hpp"
#include "slam_ros/bag_transforms.hpp"
#include "slam_ros/command_line.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/product_files.hpp"
#include "slam_ros/topics_config.hpp"

namespace {

using slam::LandmarkObservationArray;

/// A run of a product on a bag, of which only what its detector sees is kept. The whole product
/// runs, since what a bag's inputs are follows from what all components need.
class DetectorRun {
 public:
  /// @throw std::exception with a sentence
  DetectorRun(const std::string& product, const std::string& bag) : bag_(bag) {
    slam::Settings settings(slam::loadConfigFile(slam_ros::productFile(product)),
                            slam::loadConfigFile(slam_ros::robotFile(bag_.robot())), {});
    topics_ = settings.read<slam_ros::TopicsConfig>();
    mounts_ = slam_ros::GivenMounts(settings);
    product_.configure(settings);
    product_.listen<LandmarkObservationArray>(
        "observations", [this](const auto& array) { seen_.push_back(array); });
  }

  const std::vector<LandmarkObservationArray>& seen() {
    const auto& parts = product_.components();
    slam_ros::BagInputs inputs(bag_, parts, {topics_, parts.frames, mounts_}, {});
    const auto transforms = slam_ros::staticTransforms(bag_, parts.frames.map);
    bag_.read(inputs.readers([&](const slam_ros::BagInputs::Found& input) {
      slam_ros::BagSinks sinks;
      sinks.static_transforms = transforms;
      sinks.put = [this, &input](const slam::Datum& value, slam::Stamp) {
        product_.put(input.port, value.kind(), value.value());
        do product_.execute();
        while (product_.estimator().report());
      };
      return sinks;
    }));
    return seen_;
  }
  const std::string& topic() const { return topics_.observations; }

 private:
  slam_ros::BagReader bag_;
  slam_ros::TopicsConfig topics_;
  slam_ros::GivenMounts mounts_;
  slam::MetaCoordinator product_;
  std::vector<LandmarkObservationArray> seen_;
};

void write(const std::string& path, const std::string& topic,
           const std::vector<LandmarkObservationArray>& seen) {
  if (seen.empty()) throw std::runtime_error("the detector of this product saw nothing in the bag");
  slam_ros::BagFile bag(path);
  for (const auto& array : seen) {
    const auto message = slam_ros::toMsg(array);
    bag.write(topic, message.header.stamp, message);
  }
  bag.complete();
}

}  // namespace

int main(int argc, char** argv) {
  slam_ros::CommandLine line("slam_eval_observations",
                             "Writes the observations that a product's detector makes of a bag.");
  std::string product, bag, out;
  line.add("PRODUCT", product, "a product with a landmark detector").required();
  line.add("BAG", bag, "the recorded data").required();
  line.add("OUT", out, "the bag that takes the observations").required();
  return line.run(argc, argv, [&] {
    DetectorRun run(product, bag);
    write(out, run.topic(), run.seen());
  });
}
