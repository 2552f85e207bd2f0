// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "slam_core/camera/camera_model.hpp"
#include "slam_sim/marker_family.hpp"
#include "slam_sim/marker_texture.hpp"
#include "slam_sim/studio.hpp"
#include "tag_reader.hpp"

namespace slam::sim {
namespace {

using Eigen::Vector2d;

/// Mean and RMS difference of read from projected corners over views of one marker.
struct Offsets {
  Vector2d sum = Vector2d::Zero(), squares = Vector2d::Zero();
  int corners = 0, missed = 0;

  Vector2d mean() const { return sum / corners; }
  Vector2d rms() const { return (squares / corners).cwiseSqrt(); }
};

std::array<Vector2d, 4> projected(const Marker& marker, const Eigen::Isometry3d& T_world_camera,
                                  const CameraModel& model) {
  const auto corners = cornersOf(marker, T_world_camera);
  std::array<Vector2d, 4> pixels;
  for (std::size_t k = 0; k < 4; ++k) pixels[k] = model.project(corners[k]).value();
  return pixels;
}

/// @param convention what the library adds to pixels whose centres are integers
Offsets measure(const std::string& family, const CameraCalibration& calibration,
                const Vector2d& convention) {
  constexpr std::int64_t kId = 7;
  const World world = studioWorld(family, kId);
  CameraOptics optics;
  optics.noise_sigma = 1.0;
  const CameraRenderer camera(std::make_shared<const Scene>(world), calibration, optics);
  const CameraModel model(calibration);
  Offsets offsets;
  for (double distance : {0.6, 1.1, 1.6}) {
    for (double obliqueness : {0.0, 0.35, -0.6}) {
      for (const Vector2d& aside :
           {Vector2d(-0.25, 0.1), Vector2d(0.02, -0.03), Vector2d(0.17, -0.12)}) {
        const auto T_world_camera = cameraBefore(distance, obliqueness, aside);
        const auto truth = projected(world.markers[0], T_world_camera, model);
        const auto read =
            readMarkers(camera.render(standing(T_world_camera), RandomStream(1, 0)), family);
        // Small families are also read where there is nothing.
        const auto found = std::find_if(read.begin(), read.end(), [&](const ReadMarker& marker) {
          return marker.id == kId && (marker.corners[0] - truth[0]).norm() < 5.0;
        });
        if (found == read.end()) ++offsets.missed;
        for (std::size_t k = 0; k < 4 && found != read.end(); ++k) {
          const Vector2d off = found->corners[k] - convention - truth[k];
          offsets.sum += off;
          offsets.squares += off.cwiseAbs2();
          ++offsets.corners;
        }
      }
    }
  }
  return offsets;
}

CameraCalibration withoutDistortion() {
  auto calibration = studioCalibration();
  calibration.distortion.assign(5, 0.0);
  return calibration;
}

void expectExact(const Offsets& offsets, int most_missed) {
  ASSERT_GT(offsets.corners, 0);
  EXPECT_LE(offsets.missed, most_missed);
  EXPECT_LT(offsets.mean().cwiseAbs().maxCoeff(), 0.05) << offsets.mean().transpose();
  EXPECT_LT(offsets.rms().maxCoeff(), 0.25) << offsets.rms().transpose();
}

class AprilTagRendering : public testing::TestWithParam<const char*> {};

// libapriltag's pixel (0, 0) has its centre at (0.5, 0.5). No distortion here: the library fits
// straight lines to the edges, which the lens bends (0.4 px outward for tags of 160 px).
TEST_P(AprilTagRendering, PutsTheCornersWhereTheLibraryFindsThem) {
  expectExact(measure(GetParam(), withoutDistortion(), {0.5, 0.5}), 1);
}

INSTANTIATE_TEST_SUITE_P(Families, AprilTagRendering,
                         testing::Values("36h11", "25h9", "16h5", "Standard41h12"));

class ArucoRendering : public testing::TestWithParam<const char*> {};

// OpenCV's corners are refined each by itself, so that the lens may bend the edges. Its corner
// refinement is off to the inside, the same on all four corners.
TEST_P(ArucoRendering, PutsTheCornersWhereTheLibraryFindsThemThroughADistortingLens) {
  expectExact(measure(GetParam(), studioCalibration(), {0.0, 0.0}), 6);
}

INSTANTIATE_TEST_SUITE_P(Dictionaries, ArucoRendering,
                         testing::Values("DICT_4X4_50", "DICT_5X5_100", "DICT_ARUCO_ORIGINAL"));

TEST(MarkerTexture, IsReadByTheFamilysLibraryUpright) {
  for (const std::string family :
       {"36h11", "25h9", "16h5", "Standard41h12", "DICT_4X4_50", "DICT_5X5_100", "DICT_6X6_250",
        "DICT_7X7_1000", "DICT_ARUCO_ORIGINAL", "DICT_APRILTAG_36h11"}) {
    const World world = studioWorld(family, 3);
    const auto T_world_camera = cameraBefore(0.9, 0.1);
    const auto image = studioCamera(world).render(standing(T_world_camera), RandomStream(1, 0));
    const auto read = readMarkers(image, family);
    const auto truth =
        projected(world.markers[0], T_world_camera, CameraModel(studioCalibration()));
    const auto there = std::count_if(read.begin(), read.end(), [&](const ReadMarker& marker) {
      return marker.id == 3 && (marker.corners[0] - truth[0]).norm() < 2.0;
    });
    EXPECT_EQ(there, 1) << family << ": not read, or another corner is the first";
  }
}

TEST(MarkerTexture, HasEveryFamilyItsFirstAndLastMarker) {
  for (const MarkerFamily& family : markerFamilies()) {
    for (const std::int64_t id : {std::int64_t{0}, family.ids - 1}) {
      const auto pattern = markerPattern(family.name, id);
      EXPECT_EQ(pattern.cells.cols, 2 * pattern.border_first + pattern.border_cells) << family.name;
      for (int i = 0; i < pattern.cells.cols; ++i) {  // the margin
        EXPECT_EQ(pattern.cells.at<std::uint8_t>(0, i), 255) << family.name;
        EXPECT_EQ(pattern.cells.at<std::uint8_t>(i, pattern.cells.cols - 1), 255) << family.name;
      }
    }
    EXPECT_THROW(markerPattern(family.name, family.ids), std::invalid_argument);
    EXPECT_THROW(markerPattern(family.name, -1), std::invalid_argument);
  }
  EXPECT_THROW(markerPattern("36h12", 0), std::invalid_argument);
}

TEST(CameraRays, PassThroughTheirPixelsAndFillThem) {
  const auto calibration = studioCalibration();
  const CameraModel model(calibration);
  const CameraRays rays(calibration, 8);
  for (const int tile : {0, 39, 617, 1199}) {
    const int column = tile % rays.columns() * CameraRays::kTileEdge;
    const int row = tile / rays.columns() * CameraRays::kTileEdge;
    for (const int pixel : {0, 15, 100, 255}) {
      std::set<int> columns_hit, rows_hit;
      for (int sample = 0; sample < rays.samples(); ++sample) {
        const Vector2d at =
            model.project({rays.x(tile, sample)[pixel], rays.y(tile, sample)[pixel], 1.0}).value();
        const Vector2d part = at - Vector2d(column + pixel % 16 - 0.5, row + pixel / 16 - 0.5);
        EXPECT_GT(part.minCoeff(), -1e-3);
        EXPECT_LT(part.maxCoeff(), 1.0 + 1e-3);
        // Strata of this pixel: one sample in each eighth, wherever the eighths begin.
        columns_hit.insert(static_cast<int>(std::lround(part.x() * 8.0)));
        rows_hit.insert(static_cast<int>(std::lround(part.y() * 8.0)));
      }
      EXPECT_GE(columns_hit.size(), 8U);
      EXPECT_GE(rows_hit.size(), 8U);
    }
  }
}

TEST(CameraRenderer, RefusesACameraThatCannotBe) {
  const auto scene = std::make_shared<const Scene>(studioWorld("36h11", 0));
  CameraCalibration blind = studioCalibration();
  blind.fx = blind.fy = 0.0;
  EXPECT_THROW(CameraRenderer(scene, blind, {}), std::invalid_argument);
  CameraOptics optics;
  optics.samples = 0;
  EXPECT_THROW(CameraRenderer(scene, studioCalibration(), optics), std::invalid_argument);
  optics = {};
  optics.noise_sigma = -1.0;
  EXPECT_THROW(CameraRenderer(scene, studioCalibration(), optics), std::invalid_argument);
}

}  // namespace
}  // namespace slam::sim
