// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <slam_msgs/Progress.h>

#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "slam_ros/bag_inputs.hpp"
#include "slam_ros/flow_window.hpp"

namespace slam_ros {

/// Holds back the messages of a bag until those before them have been acknowledged, so that nothing
/// is dropped at any speed. The back-end acknowledges the messages that it takes itself; for
/// messages that other components take, it acknowledges their output. One thread sends, another one
/// delivers the acknowledgements.
class BagFlow {
 public:
  struct Options {
    bool has_point_map = false;       ///< in a nodelet of its own, which acknowledges as well
    slam::Duration source_timeout{};  ///< of the product
    std::function<void(const std::string& sentence)> warn;
    FlowWindow::Timeout patience{5000};  ///< without any acknowledgement
  };

  /// @param inputs outlive this
  BagFlow(const BagInputs& inputs, Options options);

  /// The gate that a message of the input must pass. The message waits there, and is refused after
  /// stop() was called.
  BagInput::Gate gateOf(const BagInputs::Found& found);

  void acknowledge(const slam_msgs::Progress& message);
  void acknowledgeOfPointMap(const slam_msgs::Progress& message);

  /// Waits until all has been acknowledged that can be. @return how many messages were not
  std::size_t finish();
  /// Ends all waiting, now and later.
  void stop();

 private:
  std::vector<std::string> answersTo(const BagInputs::Found& found) const;
  bool isWaitedFor(const BagInputs::Found& found, const slam::DataFlow::Part& maker) const;
  void limit(const BagInputs::Found& found);
  void expectOfPointMap(const slam_msgs::Progress& message);
  void waitForSlowest(slam::Stamp stamp);
  bool waitForRoom(const std::string& answer, slam::Stamp stamp);

  const BagInputs& inputs_;
  Options options_;
  FlowWindow window_{kInFlight};
  std::map<std::string, std::size_t> limits_;  ///< of answers, if they are not the usual one
  /// The limits of answers to data that may wait for their sensor, until the first such wait was in
  /// vain.
  std::map<std::string, std::size_t> held_;
  std::optional<slam::Duration> max_ahead_;  ///< of stamps, if several triggers wait together
  bool has_chain_ = false;                   ///< of components, one behind another
  std::optional<slam::Stamp> last_motion_;   ///< that was sent, if there is a chain
  std::atomic<bool> stopped_{false};
  slam_msgs::Progress told_, point_map_told_;  ///< last, by back-end and point map
};

}  // namespace slam_ros
