// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/aruco_detector.hpp"

#include <algorithm>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/fiducial/edge_refinement.hpp"
#include "slam_core/fiducial/fiducial_detector.hpp"
#include "slam_core/fiducial/id_ranges.hpp"

namespace slam::fiducial {
namespace {

const Registrar<LandmarkDetector, FiducialDetectorWith<ArucoDetector>> kArucoRegistrar("aruco");
const SectionRegistrar<ArucoConfig> kArucoSectionRegistrar;

/// How far off corners of the library's polygons may be [px].
constexpr double kArucoCornerError = 3.0;

const std::map<std::string, cv::aruco::PREDEFINED_DICTIONARY_NAME> kDictionaries = {
    {"DICT_4X4_50", cv::aruco::DICT_4X4_50},
    {"DICT_4X4_100", cv::aruco::DICT_4X4_100},
    {"DICT_4X4_250", cv::aruco::DICT_4X4_250},
    {"DICT_4X4_1000", cv::aruco::DICT_4X4_1000},
    {"DICT_5X5_50", cv::aruco::DICT_5X5_50},
    {"DICT_5X5_100", cv::aruco::DICT_5X5_100},
    {"DICT_5X5_250", cv::aruco::DICT_5X5_250},
    {"DICT_5X5_1000", cv::aruco::DICT_5X5_1000},
    {"DICT_6X6_50", cv::aruco::DICT_6X6_50},
    {"DICT_6X6_100", cv::aruco::DICT_6X6_100},
    {"DICT_6X6_250", cv::aruco::DICT_6X6_250},
    {"DICT_6X6_1000", cv::aruco::DICT_6X6_1000},
    {"DICT_7X7_50", cv::aruco::DICT_7X7_50},
    {"DICT_7X7_100", cv::aruco::DICT_7X7_100},
    {"DICT_7X7_250", cv::aruco::DICT_7X7_250},
    {"DICT_7X7_1000", cv::aruco::DICT_7X7_1000},
    {"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
    {"DICT_APRILTAG_16h5", cv::aruco::DICT_APRILTAG_16h5},
    {"DICT_APRILTAG_25h9", cv::aruco::DICT_APRILTAG_25h9},
    {"DICT_APRILTAG_36h10", cv::aruco::DICT_APRILTAG_36h10},
    {"DICT_APRILTAG_36h11", cv::aruco::DICT_APRILTAG_36h11}};

cv::aruco::CornerRefineMethod methodOf(ArucoConfig::Refinement refinement) {
  using Refinement = ArucoConfig::Refinement;
  if (refinement == Refinement::kSubpix) return cv::aruco::CORNER_REFINE_SUBPIX;
  if (refinement == Refinement::kContour) return cv::aruco::CORNER_REFINE_CONTOUR;
  return cv::aruco::CORNER_REFINE_NONE;
}

template <class Value>
std::vector<std::string> namesOf(const std::map<std::string, Value>& map) {
  std::vector<std::string> names;
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

double perimeter(const std::vector<cv::Point2f>& corners) { return cv::arcLength(corners, true); }

/// Whether a marker was found a second time, in a contour around or inside this one.
bool isSameMarker(const std::vector<cv::Point2f>& a, const std::vector<cv::Point2f>& b) {
  const auto centre = [](const auto& c) { return 0.25F * (c[0] + c[1] + c[2] + c[3]); };
  return cv::norm(centre(a) - centre(b)) < std::max(perimeter(a), perimeter(b)) / 8.0;
}

/// Where the i-th marker is the inner one of two finds of the same.
bool isInnerOfTwo(const std::vector<std::vector<cv::Point2f>>& corners, const std::vector<int>& ids,
                  std::size_t i) {
  for (std::size_t k = 0; k < ids.size(); ++k) {
    if (k == i || ids[k] != ids[i] || !isSameMarker(corners[k], corners[i])) continue;
    const double mine = perimeter(corners[i]), other = perimeter(corners[k]);
    if (mine < other || (mine == other && k < i)) return true;
  }
  return false;
}

}  // namespace

void ArucoConfig::describe(Fields& fields) {
  fields.add("dictionaries", &dictionaries, "dictionaries of markers to look for")
      .oneOf(namesOf(kDictionaries))
      .ofRobot();
  fields.add("id_offsets", &id_offsets, "by dictionary, what is added to the ids of its markers")
      .in(Range::atLeast(0))
      .ofRobot();
  fields.add("corner_refinement", &corner_refinement,
             {{"contour", Refinement::kContour},
              {"edges", Refinement::kEdges},
              {"none", Refinement::kNone},
              {"subpix", Refinement::kSubpix}},
             "how corners are found within a pixel");
  fields
      .add("min_distance_rate", &min_distance_rate,
           "of two squares whose corners are nearer than this share of their perimeter only the "
           "larger is looked at")
      .unit("1")
      .in(Range::closed(0, 1));
  fields
      .add(
          "error_correction_rate", &error_correction_rate,
          "share of the wrong bits that the dictionary could correct, above which a marker is none")
      .unit("1")
      .in(Range::closed(0, 1));
}

struct ArucoDetector::Library {
  struct Dictionary {
    cv::Ptr<cv::aruco::Dictionary> pointer;
    std::int64_t offset;
    bool is_upside_down;  ///< OpenCV has the AprilTags the other way up than their authors

    /// DICT_5X5_100 begins with the markers of DICT_5X5_50.
    bool sharesMarkersWith(const Dictionary& other) const {
      const auto &a = *pointer, &b = *other.pointer;
      return a.markerSize == b.markerSize &&
             cv::norm(a.bytesList.row(0), b.bytesList.row(0), cv::NORM_L1) == 0.0;
    }
  };
  std::vector<Dictionary> dictionaries;
  cv::Ptr<cv::aruco::DetectorParameters> parameters = cv::aruco::DetectorParameters::create();
  bool refine_by_edges = false;
  // of the last image, kept for their memory
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
};

ArucoDetector::ArucoDetector() = default;
ArucoDetector::~ArucoDetector() = default;

void ArucoDetector::configure(Settings& settings) { configure(settings.read<ArucoConfig>()); }

void ArucoDetector::configure(const ArucoConfig& config) {
  validate(config);
  if (config.dictionaries.empty())
    throw ConfigError("aruco.dictionaries: the list is empty; name one at least");
  auto library = std::make_unique<Library>();
  std::vector<IdRange> ranges;
  for (const auto& name : config.dictionaries) {
    const auto dictionary = cv::aruco::getPredefinedDictionary(kDictionaries.at(name));
    ranges.push_back({name, offsetOf(name, config.id_offsets), dictionary->bytesList.rows});
    const bool is_april_tag = name.rfind("DICT_APRILTAG_", 0) == 0;
    library->dictionaries.push_back({dictionary, ranges.back().offset, is_april_tag});
    for (std::size_t i = 0; i + 1 < ranges.size(); ++i)
      if (ranges[i].family != name &&
          library->dictionaries[i].sharesMarkersWith(library->dictionaries.back()))
        throw ConfigError("aruco.dictionaries: " + ranges[i].family + " and " + name +
                          " hold the same markers, which would count twice; name the larger only");
  }
  requireUniqueIds(ArucoConfig::kSection, ranges, config.id_offsets);
  library->parameters->cornerRefinementMethod = methodOf(config.corner_refinement);
  library->parameters->minMarkerDistanceRate = config.min_distance_rate;
  library->refine_by_edges = config.corner_refinement == ArucoConfig::Refinement::kEdges;
  library->parameters->errorCorrectionRate = config.error_correction_rate;
  library_ = std::move(library);
  use(std::move(ranges));
}

void ArucoDetector::detect(const cv::Mat& gray, std::vector<MarkerDetection>& found) {
  auto& [dictionaries, parameters, refine_by_edges, corners, ids] = *library_;
  for (const auto& dictionary : dictionaries) {
    cv::aruco::detectMarkers(gray, dictionary.pointer, corners, ids, parameters);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (isInnerOfTwo(corners, ids, i)) continue;
      MarkerDetection marker;
      marker.id = dictionary.offset + ids[i];
      for (std::size_t k = 0; k < 4; ++k) {
        const auto& corner = corners[i][dictionary.is_upside_down ? (k + 2) % 4 : k];
        marker.corners[k] = {corner.x, corner.y};
      }
      if (refine_by_edges) refineByEdges(gray, marker.corners, kArucoCornerError);
      found.push_back(marker);
    }
  }
}

}  // namespace slam::fiducial
