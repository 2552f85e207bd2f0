// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/contract/registry.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_sim/marker_stand.hpp"
#include "slam_sim/studio.hpp"

// Fiducial detectors on rendered images of a marker whose pose is known.

namespace slam {
namespace {

constexpr int kWindow = 280;  // images are cut to this around the optical axis [px]
/// Of a marker that the border cuts the detectors put corners up to 7.6 px inside of the image.
constexpr double kBorder = 8.0;  // [px]
constexpr double kDegree = M_PI / 180.0;

/// Range and bearing may be off by this on average.
constexpr double kRangeBias = 0.01;     // of the range
constexpr double kBearingBias = 0.001;  // [rad]

/// Standard deviation of a corner in these images [px]. Little of it is the images' noise: it
/// depends on where in a pixel the edges lie and on how much the lens bends them.
constexpr double kCornerSigma = 0.06;

std::unique_ptr<LandmarkDetector> makeDetector(const std::string& name) {
  loadLibraries({});
  auto detector = Registry<LandmarkDetector>::instance().create(name);
  Settings settings(
      {"product", {}}, {"robot", {}},
      {"fiducial.marker_size=" + std::to_string(sim::MarkerStand::kSize),
       "fiducial.corner_sigma=" + std::to_string(kCornerSigma), "fiducial.sigma_range_relative=0",
       "fiducial.border=" + std::to_string(kBorder)});
  detector->configure(settings);
  return detector;
}

class RenderedMarkers : public testing::TestWithParam<const char*> {
 protected:
  sim::MarkerStand stand(const CameraCalibration& calibration,
                         const sim::CameraOptics& optics = {}) const {
    return {makeDetector(GetParam()), calibration, optics};
  }
};

/// Errors over many views.
struct Errors {
  int views = 0, seen = 0, covered = 0;
  double range = 0.0, bearing = 0.0;  ///< sums, the range's over the range

  double rangeBias() const { return range / seen; }
  double bearingBias() const { return bearing / seen; }
  double coverage() const { return static_cast<double>(covered) / seen; }

  void add(const std::optional<LandmarkObservation>& z, const sim::MarkerTruth& truth) {
    constexpr double kChiSquare95 = 5.991;  // of two degrees of freedom
    ++views;
    if (!z) return;
    ++seen;
    const Eigen::Vector2d error(z->range - truth.range, z->bearing - truth.bearing);
    range += error.x() / truth.range;
    bearing += error.y();
    covered += error.dot(z->covariance.llt().solve(error)) < kChiSquare95 ? 1 : 0;
  }
};

/// @param velocity of the camera in its own frame [m per exposure]
Errors view(sim::MarkerStand& stand, double distance, double obliqueness, int views,
            std::uint64_t& frame, const Eigen::Vector3d& velocity = Eigen::Vector3d::Zero()) {
  const double aside = distance < 1.0 ? 0.08 : 0.15;
  Errors errors;
  for (int i = 0; i < views; ++i) {
    const auto T = sim::poseBefore(distance, obliqueness, aside, static_cast<std::uint64_t>(i));
    const sim::CameraPath path = [&](double part) {
      return T * Eigen::Translation3d((part - 0.5) * velocity);
    };
    errors.add(stand.look(path, frame++), stand.truth(T));
  }
  return errors;
}

void expectUnbiased(const Errors& errors) {
  EXPECT_LT(std::abs(errors.rangeBias()), kRangeBias);
  EXPECT_LT(std::abs(errors.bearingBias()), kBearingBias);
}

TEST_P(RenderedMarkers, RangeAndBearingAreUnbiasedOverDistanceAndObliqueness) {
  auto stand = this->stand(sim::studioWindow(kWindow, kWindow));
  std::uint64_t frame = 0;
  for (const double distance : {0.5, 1.0, 2.0, 3.0, 4.0, 5.0}) {
    for (const int obliqueness : {0, 30, 60, 70}) {
      SCOPED_TRACE(testing::Message() << distance << " m, " << obliqueness << " deg");
      const Errors errors = view(stand, distance, obliqueness * kDegree, 16, frame);
      if (distance <= 2.0 && obliqueness <= 60) {
        EXPECT_GE(errors.seen, errors.views - 2);
      }
      if (errors.seen > errors.views / 2) expectUnbiased(errors);
    }
  }
}

TEST_P(RenderedMarkers, RangeAndBearingAreUnbiasedInBlurredImages) {
  sim::CameraOptics optics;
  optics.defocus_sigma = 1.0;
  auto stand = this->stand(sim::studioWindow(kWindow, kWindow), optics);
  std::uint64_t frame = 0;
  for (const double distance : {0.7, 1.5}) {
    // 4 px across the image
    const Eigen::Vector3d sideways(4.0 * distance / 520.0, 0.0, 0.0);
    const Errors errors = view(stand, distance, 0.4, 24, frame, sideways);
    SCOPED_TRACE(distance);
    ASSERT_GT(errors.seen, errors.views / 2);
    expectUnbiased(errors);
  }
}

TEST_P(RenderedMarkers, CovarianceCoversTheTruthAsOftenAsItSays) {
  auto stand = this->stand(sim::studioWindow(192, 192));
  std::uint64_t frame = 0;
  Errors all;
  for (const double distance : {1.0, 1.5, 2.0, 3.0}) {
    for (const double obliqueness : {0.0, 0.5, 0.9}) {
      const Errors errors = view(stand, distance, obliqueness, 80, frame);
      all.seen += errors.seen;
      all.covered += errors.covered;
    }
  }
  ASSERT_GT(all.seen, 800);
  EXPECT_NEAR(all.coverage(), 0.95, 0.03);
}

TEST_P(RenderedMarkers, SmallOnesAreNotTooSure) {
  auto stand = this->stand(sim::studioWindow(192, 192));
  std::uint64_t frame = 0;
  Errors all;
  for (const double distance : {4.0, 4.5, 5.0, 5.5, 6.0})
    for (const double obliqueness : {0.0, 0.5, 0.9}) {
      const Errors errors = view(stand, distance, obliqueness, 40, frame);
      all.seen += errors.seen;
      all.covered += errors.covered;
    }
  ASSERT_GT(all.seen, 200);
  EXPECT_GT(all.coverage(), 0.92);
}

/// The smallest distance of a corner to the border, negative outside [px].
double distanceToBorder(const sim::MarkerTruth& truth, int width, int height) {
  double least = width;
  for (const auto& corner : truth.corners) {
    least =
        std::min({least, corner.x(), corner.y(), width - 1 - corner.x(), height - 1 - corner.y()});
  }
  return least;
}

TEST_P(RenderedMarkers, CutByTheBorderAreRejected) {
  auto stand = this->stand(sim::studioWindow(kWindow, kWindow));
  std::uint64_t frame = 0;
  int seen = 0;
  for (double aside = 0.12; aside < 0.3; aside += 0.0021) {
    for (const Eigen::Vector2d& direction :
         {Eigen::Vector2d(aside, 0.0), Eigen::Vector2d(0.0, -aside)}) {
      const auto T = sim::cameraBefore(0.8, 0.2, direction);
      const double inside = distanceToBorder(stand.truth(T), kWindow, kWindow);
      const auto z = stand.look(sim::standing(T), frame++);
      if (inside < kBorder - 1.0) {
        EXPECT_FALSE(z.has_value()) << inside << " px inside";
      }
      seen += z.has_value() ? 1 : 0;
    }
  }
  EXPECT_GT(seen, 10);
  EXPECT_GT(stand.counters()["image_border"], 0U);
}

INSTANTIATE_TEST_SUITE_P(Detectors, RenderedMarkers, testing::Values("apriltag", "aruco"));

}  // namespace
}  // namespace slam
