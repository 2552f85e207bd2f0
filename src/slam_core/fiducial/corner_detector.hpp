// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core/mat.hpp>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/common/settings.hpp"
#include "slam_core/contract/id_range.hpp"
#include "slam_core/fiducial/marker_detection.hpp"

namespace slam::fiducial {

/// The policy that finds markers in an image: their ids and corners (Olson 2011; Garrido-Jurado et
/// al. 2014). One thread at a time.
class CornerDetector {
 public:
  virtual ~CornerDetector() = default;

  /// Reads its own section. @throw ConfigError listing all faults
  virtual void configure(Settings& settings) = 0;
  /// Appends what is in the image (8 bit gray) to `found`; rejects what it read with doubt.
  virtual void detect(const cv::Mat& gray, std::vector<MarkerDetection>& found) = 0;
  /// The ids of families without an offset of their own begin here. To be called before
  /// configure().
  void startIdsAt(LandmarkId first) { first_id_ = first; }
  /// The ids that it can find. They are known after configure().
  const std::vector<IdRange>& ids() const { return ids_; }

 protected:
  /// @return the id at which those of a family begin @param offsets as the configuration gives them
  std::int64_t offsetOf(const std::string& family,
                        const std::map<std::string, std::int64_t>& offsets) const {
    const auto found = offsets.find(family);
    return found == offsets.end() ? first_id_ : found->second;
  }

  void use(std::vector<IdRange> ids) { ids_ = std::move(ids); }

 private:
  LandmarkId first_id_ = 0;
  std::vector<IdRange> ids_;
};

}  // namespace slam::fiducial
