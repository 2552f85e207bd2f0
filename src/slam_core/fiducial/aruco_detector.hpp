// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/fiducial/corner_detector.hpp"

namespace slam::fiducial {

struct ArucoConfig {
  static constexpr const char* kSection = "aruco";

  enum class Refinement { kContour, kEdges, kNone, kSubpix };

  std::vector<std::string> dictionaries = {"DICT_APRILTAG_36h11"};
  std::map<std::string, std::int64_t> id_offsets;

  Refinement corner_refinement = Refinement::kEdges;
  double min_distance_rate = 0.02;
  double error_correction_rate = 0.6;

  void describe(Fields& fields);
};

/// Square markers by OpenCV's ArUco module (Garrido-Jurado et al. 2014), any predefined dictionary.
/// Each further dictionary costs as much time as the first.
class ArucoDetector final : public CornerDetector {
 public:
  ArucoDetector();
  ~ArucoDetector() override;

  void configure(Settings& settings) override;
  void configure(const ArucoConfig& config);  ///< @throw ConfigError
  void detect(const cv::Mat& gray, std::vector<MarkerDetection>& found) override;

 private:
  struct Library;

  std::unique_ptr<Library> library_;
};

}  // namespace slam::fiducial
