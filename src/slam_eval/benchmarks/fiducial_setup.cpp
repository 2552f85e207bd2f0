// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fiducial_setup.hpp"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include <opencv2/aruco.hpp>

#include "slam_core/contract/registry.hpp"
#include "slam_core/product/product_config.hpp"

namespace slam::eval {
namespace {

class BareAprilTag final : public BareDetector {
 public:
  explicit BareAprilTag(double quad_decimate) {
    apriltag_detector_add_family(detector_.get(), family_.get());
    detector_->quad_decimate = static_cast<float>(quad_decimate);
    detector_->nthreads = 1;
  }

  int detect(const cv::Mat& gray) override {
    image_u8_t image{gray.cols, gray.rows, static_cast<int32_t>(gray.step[0]), gray.data};
    zarray_t* found = apriltag_detector_detect(detector_.get(), &image);
    const int count = zarray_size(found);
    apriltag_detections_destroy(found);
    return count;
  }

 private:
  std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)> family_{tag36h11_create(),
                                                                           tag36h11_destroy};
  std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t*)> detector_{
      apriltag_detector_create(), apriltag_detector_destroy};
};

class BareAruco final : public BareDetector {
 public:
  int detect(const cv::Mat& gray) override {
    cv::aruco::detectMarkers(gray, dictionary_, corners_, ids_, parameters_);
    return static_cast<int>(ids_.size());
  }

 private:
  cv::Ptr<cv::aruco::Dictionary> dictionary_ =
      cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
  cv::Ptr<cv::aruco::DetectorParameters> parameters_ = cv::aruco::DetectorParameters::create();
  std::vector<std::vector<cv::Point2f>> corners_;
  std::vector<int> ids_;
};

}  // namespace

std::unique_ptr<LandmarkDetector> makeDetector(const std::string& name,
                                               const std::vector<std::string>& overrides) {
  auto all = overrides;
  all.push_back("fiducial.marker_size=0.16");
  Settings settings({"product", {}}, {"robot", {}}, all);
  loadLibraries({});
  auto detector = Registry<LandmarkDetector>::instance().create(name);
  detector->configure(settings);
  return detector;
}

std::unique_ptr<BareDetector> makeBareAprilTag(double quad_decimate) {
  return std::make_unique<BareAprilTag>(quad_decimate);
}

std::unique_ptr<BareDetector> makeBareAruco() { return std::make_unique<BareAruco>(); }

}  // namespace slam::eval
