// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/april_tag_detector.hpp"

#include <apriltag/apriltag.h>
#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagStandard41h12.h>

#include <algorithm>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/fiducial/edge_refinement.hpp"
#include "slam_core/fiducial/fiducial_detector.hpp"
#include "slam_core/fiducial/id_ranges.hpp"

namespace slam::fiducial {
namespace {

const Registrar<LandmarkDetector, FiducialDetectorWith<AprilTagDetector>> kAprilTagRegistrar(
    "apriltag");
const SectionRegistrar<AprilTagConfig> kAprilTagSectionRegistrar;

/// Smaller than any tag; the library's tiles of 4 px need a few of them.
constexpr int kSmallestImage = 16;
/// How far off the library's corners may be, in the image in which it looks for squares [px].
constexpr double kAprilTagCornerError = 1.0;

struct FamilyFunctions {
  apriltag_family_t* (*create)();
  void (*destroy)(apriltag_family_t*);
};
const std::map<std::string, FamilyFunctions> kFamilies = {
    {"16h5", {tag16h5_create, tag16h5_destroy}},
    {"25h9", {tag25h9_create, tag25h9_destroy}},
    {"36h11", {tag36h11_create, tag36h11_destroy}},
    {"Standard41h12", {tagStandard41h12_create, tagStandard41h12_destroy}}};

std::vector<std::string> familyNames() {
  std::vector<std::string> names;
  for (const auto& entry : kFamilies) names.push_back(entry.first);
  return names;
}

using FamilyPointer = std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)>;
using DetectorPointer = std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t*)>;
using DetectionsPointer = std::unique_ptr<zarray_t, void (*)(zarray_t*)>;

/// The library puts the centre of the upper left pixel at (0.5, 0.5) and lists the corners the
/// other way round, from the lower left one.
Corners cornersOf(const apriltag_detection_t& detection) {
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i)
    corners[i] = {detection.p[3 - i][0] - 0.5, detection.p[3 - i][1] - 0.5};
  return corners;
}

}  // namespace

void AprilTagConfig::describe(Fields& fields) {
  fields.add("families", &families, "families of tags to look for").oneOf(familyNames()).ofRobot();
  fields.add("id_offsets", &id_offsets, "by family, what is added to the ids of its tags")
      .in(Range::atLeast(0))
      .ofRobot();
  fields
      .add("quad_decimate", &quad_decimate,
           "squares are looked for in an image this many times smaller: faster, but not as far")
      .unit("1")
      .in(Range::closed(1, 8));
  fields
      .add("quad_sigma", &quad_sigma,
           "the image in which squares are looked for is blurred by this; below 0 it is sharpened")
      .unit("px")
      .in(Range::closed(-5, 5));
  fields.add("decode_sharpening", &decode_sharpening, "of the bits of small tags")
      .unit("1")
      .in(Range::closed(0, 10));
  fields.add(
      "corner_refinement", &corner_refinement,
      {{"edges", Refinement::kEdges},
       {"library", Refinement::kLibrary},
       {"none", Refinement::kNone}},
      "how corners are found within a pixel: as ArUco's, by the library's refine_edges, or not");
  fields.add("threads", &threads, "threads of the detector").in(Range::closed(1, 64));
  fields.add("max_hamming", &max_hamming, "tags with more wrong bits are rejected")
      .in(Range::closed(0, 2));
  fields
      .add("min_margin", &min_margin,
           "tags whose bits lie nearer to the threshold between black and white are rejected")
      .unit("gray levels")
      .in(Range::closed(0, 255));
}

struct AprilTagDetector::Library {
  struct Family {
    FamilyPointer pointer;
    std::int64_t offset;
  };
  std::vector<Family> families;  // outlive the detector that refers to them
  DetectorPointer detector{apriltag_detector_create(), apriltag_detector_destroy};
  cv::Mat scratch;  ///< a copy for what the library does in place

  std::int64_t offsetOf(const apriltag_family_t* family) const {
    return std::find_if(families.begin(), families.end(),
                        [&](const Family& entry) { return entry.pointer.get() == family; })
        ->offset;
  }
};

AprilTagDetector::AprilTagDetector() = default;
AprilTagDetector::~AprilTagDetector() = default;

void AprilTagDetector::configure(Settings& settings) { configure(settings.read<AprilTagConfig>()); }

void AprilTagDetector::configure(const AprilTagConfig& config) {
  validate(config);
  if (config.families.empty())
    throw ConfigError("apriltag.families: the list is empty; name one at least");
  auto library = std::make_unique<Library>();
  std::vector<IdRange> ranges;
  for (const auto& name : config.families) {
    const auto& functions = kFamilies.at(name);
    FamilyPointer family(functions.create(), functions.destroy);
    ranges.push_back(
        {name, offsetOf(name, config.id_offsets), static_cast<std::int64_t>(family->ncodes)});
    library->families.push_back({std::move(family), ranges.back().offset});
  }
  requireUniqueIds(AprilTagConfig::kSection, ranges, config.id_offsets);
  auto& detector = *library->detector;
  for (const auto& family : library->families)
    apriltag_detector_add_family(&detector, family.pointer.get());
  detector.quad_decimate = static_cast<float>(config.quad_decimate);
  detector.quad_sigma = static_cast<float>(config.quad_sigma);
  detector.decode_sharpening = config.decode_sharpening;
  detector.refine_edges = config.corner_refinement == AprilTagConfig::Refinement::kLibrary;
  detector.nthreads = config.threads;
  config_ = config;
  library_ = std::move(library);
  use(std::move(ranges));
}

void AprilTagDetector::detect(const cv::Mat& gray, std::vector<MarkerDetection>& found) {
  if (std::min(gray.cols, gray.rows) < kSmallestImage * config_.quad_decimate) return;
  const bool blurred_in_place = config_.quad_sigma != 0.0 && config_.quad_decimate == 1.0;
  if (blurred_in_place) gray.copyTo(library_->scratch);
  const cv::Mat& pixels = blurred_in_place ? library_->scratch : gray;
  image_u8_t image = {pixels.cols, pixels.rows, static_cast<int32_t>(pixels.step[0]), pixels.data};
  const DetectionsPointer detections(apriltag_detector_detect(library_->detector.get(), &image),
                                     apriltag_detections_destroy);
  for (int i = 0; i < zarray_size(detections.get()); ++i) {
    apriltag_detection_t* detection = nullptr;
    zarray_get(detections.get(), i, &detection);
    MarkerDetection marker;
    marker.id = library_->offsetOf(detection->family) + detection->id;
    marker.corners = cornersOf(*detection);
    marker.hamming = detection->hamming;
    marker.margin = static_cast<double>(detection->decision_margin);
    if (config_.corner_refinement == AprilTagConfig::Refinement::kEdges) {
      const bool is_reversed = detection->family->reversed_border;
      refineByEdges(gray, marker.corners, kAprilTagCornerError * config_.quad_decimate,
                    is_reversed ? Contrast::kWhiteOnBlack : Contrast::kBlackOnWhite);
    }
    if (marker.hamming > config_.max_hamming) marker.rejection = "hamming";
    if (marker.margin < config_.min_margin) marker.rejection = "low_margin";
    found.push_back(marker);
  }
}

}  // namespace slam::fiducial
