// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace slam_ros {

/// Where a run comes from: version and commit of the programs, date, command line and bag, as
/// `slam_run` names them, for metrics.json and config.yaml, which have it under the name `run`.
class RunOrigin {
 public:
  /// An origin of which nothing is known: it leaves both files as they are.
  RunOrigin() = default;
  /// @param text an object of JSON; empty: nothing is known
  /// @throw std::invalid_argument where it is none
  explicit RunOrigin(const std::string& text);

  /// @param metrics the content of metrics.json
  std::string addedToMetrics(const std::string& metrics) const;
  /// Without date and command line: the same run writes the same bytes.
  /// @param config the content of config.yaml
  std::string addedToConfig(const std::string& config) const;
  /// Adds it to both files of a run that is complete, which have none yet.
  void addToFolder(const std::string& folder) const;

 private:
  std::string text_;  ///< empty: nothing is known
};

}  // namespace slam_ros
