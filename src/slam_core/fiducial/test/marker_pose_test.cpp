// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/marker_pose.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "slam_core/fiducial/range_bearing.hpp"
#include "slam_core/fiducial/test/marker_picture.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_core/geometry/test/numeric_jacobian.hpp"

namespace slam::fiducial {
namespace {

constexpr double kSize = 0.16, kSigma = 0.3;

Corners seenBy(const CameraModel& camera, const Eigen::Isometry3d& T_camera_marker) {
  Corners corners;
  const auto square = cornersOfSquare(kSize);
  for (std::size_t i = 0; i < 4; ++i) corners[i] = *camera.project(T_camera_marker * square[i]);
  return corners;
}

TEST(MarkerPose, HasTheJacobianOfItsReprojectionError) {
  const CameraModel camera(test::vgaCalibration());
  const auto pose = test::facing({0.2, -0.1, 1.2}, 0.7, 0.4);
  const Corners corners = seenBy(camera, test::facing({0.21, -0.1, 1.2}, 0.6, 0.4));
  const SquareView view{camera, corners, cornersOfSquare(kSize)};
  Eigen::Matrix<double, 8, 6> J;
  ASSERT_TRUE(reprojectionError(view, pose, &J));
  const auto numeric = slam::test::numericJacobian(
      [&](const Eigen::VectorXd& step) -> Eigen::VectorXd {
        return *reprojectionError(view, moved(pose, step));
      },
      Eigen::VectorXd::Zero(6),
      [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return a - b; });
  EXPECT_TRUE(J.isApprox(numeric, 1e-6)) << J << "\n\n" << numeric;
}

TEST(MarkerPose, RefinesToWhereTheGradientVanishes) {
  const CameraModel camera(test::vgaCalibration());
  const auto truth = test::facing({0.2, -0.1, 1.2}, 0.7, 0.4);
  Corners corners = seenBy(camera, truth);
  corners[2] += Eigen::Vector2d(0.8, -0.5);
  const SquareView view{camera, corners, cornersOfSquare(kSize)};
  const auto refined = refinePose(view, truth);
  ASSERT_TRUE(refined);
  Eigen::Matrix<double, 8, 6> J;
  const auto error = reprojectionError(view, refined->T_camera_marker, &J);
  EXPECT_NEAR(error->squaredNorm(), refined->squared_error, 1e-12);
  EXPECT_LT((J.transpose() * *error).norm(), 1e-3 * J.norm());
  EXPECT_LT(refined->squared_error, reprojectionError(view, truth)->squaredNorm());
}

TEST(MarkerPose, KeepsBothSolutionsTheBetterOneFirst) {
  const CameraModel camera(test::vgaCalibration());
  const auto truth = test::facing({0.1, 0.0, 0.6}, 0.7, 0.3);
  const auto pose = estimatePose(camera, seenBy(camera, truth), kSize, kSigma);
  ASSERT_TRUE(pose);
  EXPECT_LT(pose->reprojectionError(), 1e-6);
  EXPECT_TRUE(pose->solutions[0].T_camera_marker.isApprox(truth, 1e-6));
  EXPECT_GT(pose->solutions[1].squared_error, 1.0);
  EXPECT_NEAR(pose->obliqueness(), 0.7, 1e-6);
}

TEST(MarkerPose, IsNotDisturbedByTheWrongOfTwoOrientations) {
  // far away both orientations explain the corners, and noise decides which one does it better
  const CameraModel camera(test::vgaCalibration());
  const auto truth = test::facing({0.3, 0.1, 3.5}, 0.6, M_PI / 2);
  const auto corners = seenBy(camera, truth);
  const Eigen::Vector3d normal = truth.linear().col(2);
  int flipped = 0;
  double worst = 0.0;
  for (std::uint32_t run = 0; run < 300; ++run) {
    RandomStream random(5, run);
    Corners noisy = corners;
    for (auto& corner : noisy)
      corner += kSigma * Eigen::Vector2d(random.gaussian(), random.gaussian());
    const auto pose = estimatePose(camera, noisy, kSize, kSigma);
    ASSERT_TRUE(pose);
    const auto& solutions = pose->solutions;
    const auto agreement = [&](std::size_t i) {
      return solutions[i].T_camera_marker.linear().col(2).dot(normal);
    };
    if (agreement(1) > agreement(0)) ++flipped;
    const Eigen::Vector3d error = pose->position - truth.translation();
    worst = std::max(worst, error.dot(pose->covariance.inverse() * error));
  }
  EXPECT_GT(flipped, 10) << "the scene does not show what it is for";
  EXPECT_LT(worst, 21.1) << "no error beyond the 99.99 % ellipsoid";
}

TEST(MarkerPose, IsNoneForCornersThatNoSquareHas) {
  auto calibration = test::vgaCalibration();
  calibration.distortion = {-0.5, 0, 0, 0, 0};  // sees up to 286 px from the middle
  const CameraModel camera(calibration);
  const Eigen::Vector2d a(300, 200), b(340, 200), c(340, 240), d(300, 240), away(0, 600);
  EXPECT_TRUE(estimatePose(camera, {a, b, c, d}, kSize, kSigma));
  EXPECT_FALSE(estimatePose(camera, {a, a, a, a}, kSize, kSigma));
  EXPECT_FALSE(estimatePose(camera, {a, b, c, NAN * d}, kSize, kSigma));
  EXPECT_FALSE(estimatePose(camera, {a + away, b + away, c + away, d + away}, kSize, kSigma))
      << "outside of what the lens shows";
}

TEST(MarkerPose, HasALargeErrorForCornersThatAreNoSquare) {
  const CameraModel camera(test::vgaCalibration());
  const auto pose = estimatePose(
      camera, {Eigen::Vector2d(300, 200), {380, 200}, {330, 215}, {300, 280}}, kSize, kSigma);
  ASSERT_TRUE(pose);
  EXPECT_GT(pose->reprojectionError(), 2.0);
}

/// Ways to mount a camera: roll, pitch, yaw of its optical frame in the base frame [rad].
struct Mounting {
  const char* name;
  Eigen::Vector3d roll_pitch_yaw;
};

class MarkerPoseMonteCarlo : public testing::TestWithParam<Mounting> {
 protected:
  struct Result {
    double coverage;    ///< share of errors within the 95 % ellipse
    double range_bias;  ///< mean error of the range over the range
    int rejected;
  };

  Eigen::Matrix3d rotation() const {
    const auto& rpy = GetParam().roll_pitch_yaw;
    return (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
        .toRotationMatrix();
  }

  Result run(const Eigen::Isometry3d& truth, int runs, std::uint64_t seed) const {
    const CameraModel camera(test::vgaCalibration());
    const auto corners = seenBy(camera, truth);
    const auto R = rotation();
    const Eigen::Vector2d place = (R * truth.translation()).head<2>();
    const double range = place.norm(), bearing = std::atan2(place.y(), place.x());
    Result result{0, 0, 0};
    for (int k = 0; k < runs; ++k) {
      RandomStream random(seed, static_cast<std::uint64_t>(k));
      Corners noisy = corners;
      for (auto& corner : noisy)
        corner += kSigma * Eigen::Vector2d(random.gaussian(), random.gaussian());
      const auto pose = estimatePose(camera, noisy, kSize, kSigma);
      const auto z = pose ? rangeAndBearing(pose->position, pose->covariance, R, 0.1)
                          : std::optional<LandmarkObservation>();
      if (!z) {
        ++result.rejected;
        continue;
      }
      const Eigen::Vector2d error(z->range - range, wrapAngle(z->bearing - bearing));
      constexpr double kChiSquare95 = 5.991;  // two degrees of freedom
      if (error.dot(z->covariance.inverse() * error) <= kChiSquare95) result.coverage += 1.0;
      result.range_bias += error.x() / range;
    }
    const int used = std::max(1, runs - result.rejected);
    return {result.coverage / used, result.range_bias / used, result.rejected};
  }
};

TEST_P(MarkerPoseMonteCarlo, CoversTheTruthAsOftenAsItSaysAndIsUnbiased) {
  constexpr int kRuns = 1000;
  double coverage_sum = 0.0, worst = 1.0, best = 0.0;
  int scenes = 0;
  for (const double distance : {0.5, 1.0, 2.0, 3.0, 4.0}) {
    for (const double obliqueness : {0.0, 0.2, 0.5, 0.9, 1.22}) {
      for (const double side : {0.0, 0.35}) {
        const Eigen::Vector3d direction(side, 0.4 * side, 1.0);
        const auto truth =
            test::facing(distance * direction.normalized(), obliqueness, 0.8 * scenes);
        const auto result = run(truth, kRuns, 100 + static_cast<std::uint64_t>(scenes));
        SCOPED_TRACE(testing::Message() << GetParam().name << ", " << distance << " m, oblique "
                                        << obliqueness << " rad, aside " << side);
        EXPECT_EQ(result.rejected, 0);
        EXPECT_LT(std::abs(result.range_bias), 0.01);
        EXPECT_GT(result.coverage, 0.91) << "3 % and what 1000 runs leave to chance";
        EXPECT_LT(result.coverage, 0.985);
        coverage_sum += result.coverage;
        worst = std::min(worst, result.coverage);
        best = std::max(best, result.coverage);
        ++scenes;
      }
    }
  }
  EXPECT_NEAR(coverage_sum / scenes, 0.95, 0.01);
  RecordProperty("coverage", std::to_string(coverage_sum / scenes));
  RecordProperty("worst_and_best", std::to_string(worst) + " " + std::to_string(best));
}

INSTANTIATE_TEST_SUITE_P(Mountings, MarkerPoseMonteCarlo,
                         testing::Values(Mounting{"ahead", {-M_PI / 2, 0, -M_PI / 2}},
                                         Mounting{"up_45_degrees", {-M_PI / 4, 0, -M_PI / 2}},
                                         Mounting{"to_the_left_tilted", {-1.4, 0.3, 0.0}},
                                         Mounting{"back_on_its_head", {M_PI / 2, 0, -M_PI / 2}}),
                         [](const auto& mounting) { return std::string(mounting.param.name); });

}  // namespace
}  // namespace slam::fiducial
