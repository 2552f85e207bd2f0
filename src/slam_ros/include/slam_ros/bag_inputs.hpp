// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>
#include <slam_msgs/LandmarkObservationArray.h>
#include <slam_msgs/Motion.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "slam_core/contract/ports.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_ros/bag_binding.hpp"
#include "slam_ros/bag_reader.hpp"
#include "slam_ros/topics_config.hpp"

namespace slam_ros {

/// Where the images of a camera stand in a bag.
struct BagCamera {
  std::string image, compressed_image;  ///< one of them at most
  std::string camera_info;

  bool hasImages() const { return !image.empty() || !compressed_image.empty(); }
};

/// Where a product's inputs stand in a bag. An empty topic: that input does not come from the bag.
struct BagInputs : BagCamera {
  std::string motion, odom, observations, scan;
  std::string tf;  ///< the odometry is an edge of this topic
  std::string odom_frame, base_frame;
  /// Where data of further kinds stand, by input.
  struct Other {
    std::string topic;
    slam::Kind kind;
  };
  std::map<std::string, Other> others;
  BagCamera ceiling;                  ///< that looks at the ceiling
  std::vector<std::string> notes;     ///< a sentence each: other names, components left out
  std::vector<std::string> warnings;  ///< a sentence each: what the run will suffer from
};

/// Takes what a camera's topics hold.
struct CameraSinks {
  std::function<void(const sensor_msgs::Image&)> image;
  std::function<void(const sensor_msgs::CompressedImage&)> compressed_image;
  std::function<void(const sensor_msgs::CameraInfo&)> camera_info;
};

/// Takes what the bag's inputs hold, in bag order.
struct InputSinks : CameraSinks {
  std::function<void(const slam_msgs::Motion&)> motion;
  std::function<void(const nav_msgs::Odometry&)> odom;
  std::function<void(const slam_msgs::LandmarkObservationArray&)> observations;
  std::function<void(const sensor_msgs::LaserScan&)> scan;
  CameraSinks ceiling;
  /// Makes what takes the messages of an input of a further kind.
  std::function<BagHandler(const std::string& input, slam::Kind kind, const BagBinding& binding)>
      other;
};

/// What of a product tells which inputs it needs.
struct InputNeeds {
  TopicsConfig topics;
  slam::FramesConfig frames;
  bool images = false;                  ///< it makes observations of images
  bool wheels = true;                   ///< its odometry takes in that of the wheels
  bool ceiling = false;                 ///< its odometry looks at the ceiling
  bool scans = false;                   ///< it cannot do without a laser
  bool motion = true;                   ///< its back-end steps on motion
  std::vector<slam::InputPort> others;  ///< inputs of further kinds that a message brings
  bool landmarks = true;                ///< it cannot do without landmarks, else they are welcome
  /// Names of inputs by who takes them: the back-end, the odometry source, the detector, modules.
  std::set<std::string> of_backend, of_odometry, of_detector, of_modules;

  /// Nobody but the odometry source takes it.
  bool isOfOdometryAlone(const std::string& input) const;
};

/// All inputs that products have, and those of further kinds.
std::vector<Input> inputsOf(const TopicsConfig& topics,
                            const std::vector<slam::InputPort>& others = {});

/// What a product needs by the ports of its components, but for the names of topics and frames.
/// @throw slam::ConfigError
InputNeeds needsOf(const slam::ProductConfig& product);

/// Motion in the bag comes before what the odometry source takes, unless others take that as well;
/// odometry comes before the edge odom -> base of /tf. Observations come before images, where both
/// are of the name asked for raw ones before compressed ones.
/// @throw TopicError when an input the product needs is missing (with what the bag has) or cannot
/// be told
BagInputs findInputs(const BagReader& bag, const InputNeeds& needs,
                     const std::vector<Remap>& remaps);

/// The handlers that feed the sinks; for BagReader::read().
BagHandlers handlersFor(const BagInputs& inputs, const InputSinks& sinks);

}  // namespace slam_ros
