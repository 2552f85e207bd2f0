// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/odometry_sensitivity.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "slam_core/common/random.hpp"

namespace slam {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// A linear Kalman filter of a pose between known landmarks, with a share more odometry noise.
struct KalmanFilter {
  double more = 0.0;
  Vector3d x = Vector3d::Zero();
  Matrix3d P = Matrix3d::Zero();

  void predict(const PosePrediction& step) {
    x = step.F * x;
    P = step.F * P * step.F.transpose() + (1.0 + more) * step.Q;
  }
  JointInnovation update(const Eigen::MatrixX3d& H, const MatrixXd& R, const Eigen::VectorXd& z) {
    JointInnovation group{z - H * x, H * P * H.transpose() + R, R, H};
    const MatrixXd K = P * H.transpose() * group.S.inverse();
    x += K * group.nu;
    P -= K * H * P;
    return group;
  }
};

class OdometrySensitivityTest : public testing::Test {
 protected:
  PosePrediction step() {
    PosePrediction step;
    step.F(0, 2) = 0.2 * random_.gaussian();
    step.F(1, 2) = 0.2 * random_.gaussian();
    step.Q << 4e-5, 0, 0, 0, 1e-5, 5e-6, 0, 5e-6, 2e-5;
    return step;
  }
  MatrixXd gaussian(Eigen::Index rows, Eigen::Index columns) {
    MatrixXd result(rows, columns);
    for (Eigen::Index i = 0; i < result.size(); ++i) result.data()[i] = random_.gaussian();
    return result;
  }

  RandomStream random_{7, 0};
};

TEST_F(OdometrySensitivityTest, IsTheNumericDerivativeOfTheFilter) {
  constexpr double kShare = 1e-5;
  KalmanFilter fewer{-kShare}, as_believed{}, more{kShare};
  OdometrySensitivity sensitivity;
  for (int i = 0; i < 60; ++i) {
    const auto motion = step();
    for (auto* filter : {&fewer, &as_believed, &more}) filter->predict(motion);
    sensitivity.predict(motion);
    const Vector3d e = (more.x - fewer.x) / (2.0 * kShare);
    const Matrix3d D = (more.P - fewer.P) / (2.0 * kShare);
    EXPECT_LT((sensitivity.mean() - e).norm(), 1e-5 * (1e-3 + e.norm())) << "step " << i;
    EXPECT_LT((sensitivity.covariance() - D).norm(), 1e-5 * D.norm()) << "step " << i;
    const Eigen::MatrixX3d H = gaussian(6, 3);
    const MatrixXd R = 25e-4 * MatrixXd::Identity(6, 6);
    const Eigen::VectorXd z = 0.05 * gaussian(6, 1);
    for (auto* filter : {&fewer, &more}) filter->update(H, R, z);
    sensitivity.update(as_believed.update(H, R, z));
  }
}

TEST_F(OdometrySensitivityTest, KeepsWhatASingleLandmarkDoesNotShow) {
  OdometrySensitivity sensitivity;
  sensitivity.predict({Matrix3d::Identity(), Matrix3d::Identity()});
  Eigen::MatrixX3d H(2, 3);
  H << 1, 0, 0, 0, 1, 0;
  const MatrixXd R = MatrixXd::Identity(2, 2);
  sensitivity.update({Eigen::Vector2d(1.0, 0.0), 2.0 * R, R, H});
  const Vector3d left(0.25, 0.25, 1.0);
  EXPECT_LT((sensitivity.covariance() - Matrix3d(left.asDiagonal())).norm(), 1e-8);
  EXPECT_LT((sensitivity.mean() - Vector3d(0.25, 0.0, 0.0)).norm(), 1e-8);
}

TEST_F(OdometrySensitivityTest, ForgetsWhatWasBeforeAPoseThatIsSet) {
  OdometrySensitivity sensitivity;
  sensitivity.predict(step());
  const auto Q = step().Q;
  sensitivity.predict({Matrix3d::Zero(), Q});
  EXPECT_EQ(sensitivity.covariance(), Q);
  EXPECT_EQ(sensitivity.mean(), Vector3d::Zero());
}

}  // namespace
}  // namespace slam
