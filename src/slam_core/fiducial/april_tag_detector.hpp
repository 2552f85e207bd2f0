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

struct AprilTagConfig {
  static constexpr const char* kSection = "apriltag";

  enum class Refinement { kEdges, kLibrary, kNone };

  std::vector<std::string> families = {"36h11"};
  std::map<std::string, std::int64_t> id_offsets;

  double quad_decimate = 1.0;
  double quad_sigma = 0.0;
  double decode_sharpening = 0.25;
  Refinement corner_refinement = Refinement::kEdges;
  int threads = 1;
  int max_hamming = 1;
  double min_margin = 20.0;

  void describe(Fields& fields);
};

/// AprilTags by the library of their authors (Olson 2011; Wang and Olson 2016), several families at
/// once. Rejected: "hamming", "low_margin".
class AprilTagDetector final : public CornerDetector {
 public:
  AprilTagDetector();
  ~AprilTagDetector() override;

  void configure(Settings& settings) override;
  void configure(const AprilTagConfig& config);  ///< @throw ConfigError
  void detect(const cv::Mat& gray, std::vector<MarkerDetection>& found) override;

 private:
  struct Library;

  AprilTagConfig config_;
  std::unique_ptr<Library> library_;
};

}  // namespace slam::fiducial
