// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace slam_ros {

/// The origin of a run: version and commit of the programs, date, command line and bag, as
/// `slam_run` passes them on. metrics.json and config.yaml have it under the key `run`.
class RunOrigin {
 public:
  /// An unknown origin: it does not change the files.
  RunOrigin() = default;
  /// @param text an object of JSON; empty: nothing is known
  /// @throw std::invalid_argument if it is none
  explicit RunOrigin(const std::string& text);

  /// @param metrics the content of metrics.json
  std::string addedToMetrics(const std::string& metrics) const;
  /// Without date and command line, so that the same run writes the same bytes.
  /// @param config the content of config.yaml
  std::string addedToConfig(const std::string& config) const;
  /// Adds it to both files of a complete run, which have no origin yet.
  void addToFolder(const std::string& folder) const;

 private:
  std::string text_;  ///< empty: nothing is known
};

}  // namespace slam_ros
