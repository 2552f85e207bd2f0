// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/imu/imu_gate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "slam_core/common/test/faults.hpp"

namespace slam {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Eigen::Isometry3d turnedBy(double angle, const Eigen::Vector3d& axis) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(angle, axis));
}

class ImuGateTest : public testing::Test {
 protected:
  ImuGateTest() { gate.configure(ImuConfig()); }

  static ImuReading readingAt(double s, const Eigen::Vector3d& rate = {0.1, 0.2, 0.3}) {
    ImuReading reading;
    reading.stamp = Stamp(durationFromSeconds(s));
    reading.frame = "imu_link";
    reading.angular_velocity = rate;
    return reading;
  }
  static ImuMount mount(const Eigen::Isometry3d& T = Eigen::Isometry3d::Identity(),
                        const std::string& frame = "imu_link") {
    return {frame, T};
  }
  /// The stamps [s] that come out.
  std::vector<double> drain() {
    std::vector<double> stamps;
    for (next(); gate.sample(); next()) stamps.push_back(seconds(gate.sample()->stamp - Stamp()));
    return stamps;
  }
  Status next() { return gate.execute(); }
  ImuSample sampleOf(const ImuReading& reading) {
    gate.set(reading);
    next();
    return gate.sample().value();
  }
  /// The sentence that the gate reports of a reading that it rejects.
  std::string refusalOf(const ImuReading& reading, const std::string& reason) {
    const auto before = gate.counters()[reason];
    gate.set(reading);
    const auto status = next();
    EXPECT_FALSE(gate.sample());
    EXPECT_EQ(gate.counters()[reason], before + 1);
    EXPECT_GT(gate.dropped(), 0u);
    return status.message;
  }

  ImuGate gate;
};

bool says(const std::string& sentence, const std::string& words) {
  return sentence.find(words) != std::string::npos;
}

TEST_F(ImuGateTest, HoldsReadingsUntilTheMountIsKnown) {
  for (const double s : {1.0, 1.5, 2.5}) gate.set(readingAt(s));
  const auto status = next();
  EXPECT_TRUE(says(status.message, "how the IMU of frame 'imu_link' is mounted"));
  EXPECT_TRUE(says(status.message, "imu.sensor_pose"));
  EXPECT_FALSE(gate.sample());
  EXPECT_EQ(gate.held()["no_mount"], 3u);
  gate.set(mount());
  EXPECT_EQ(drain(), (std::vector<double>{1.0, 1.5, 2.5}));
  EXPECT_EQ(gate.dropped(), 0u);
}

TEST_F(ImuGateTest, HoldsNoMoreThanItsCapacity) {
  for (std::size_t i = 0; i <= ImuGate::kCapacity + 5; ++i)
    gate.set(readingAt(0.01 * static_cast<double>(i)));
  drain();
  EXPECT_EQ(gate.counters()["no_mount"], 6u);
  gate.set(mount());
  EXPECT_EQ(drain().size(), ImuGate::kCapacity);
}

TEST_F(ImuGateTest, DoesNotWaitForAnotherImu) {
  gate.set(mount());
  auto other = readingAt(1.0);
  other.frame = "camera_imu";
  gate.set(other);
  gate.set(readingAt(1.1));
  EXPECT_EQ(drain(), std::vector<double>{1.1});
  EXPECT_EQ(gate.counters()["no_mount"], 1u);
}

TEST_F(ImuGateTest, SeesTheRobotTurnWhateverTheMount) {
  const Eigen::Vector3d of_base(0.0, 0.0, 0.7);
  const Eigen::Isometry3d mounts[] = {turnedBy(M_PI, Eigen::Vector3d::UnitX()),    // upside down
                                      turnedBy(M_PI_2, Eigen::Vector3d::UnitY()),  // upright
                                      turnedBy(0.3, Eigen::Vector3d(1, 1, 0.5).normalized())};
  for (const auto& T : mounts) {
    gate.set(mount(T));
    const Eigen::Vector3d measured = T.linear().transpose() * of_base;
    const auto sample = sampleOf(readingAt(1.0, measured));
    EXPECT_LT((sample.angular_velocity - of_base).norm(), 1e-12);
  }
}

TEST_F(ImuGateTest, TakesTheRobotFilesMountBeforeThePublishedOne) {
  ImuConfig config;
  config.sensor_pose = {0, 0, 0, M_PI, 0, 0};
  gate.configure(config);
  gate.set(mount());
  EXPECT_NEAR(sampleOf(readingAt(1.0)).angular_velocity.z(), -0.3, 1e-12);
  config.sensor_pose = {0, 0, 0};
  EXPECT_TRUE(test::oneSays(test::faultsOf([&] { gate.configure(config); }),
                            {"imu.sensor_pose", "3 values"}));
}

TEST_F(ImuGateTest, ReadsADriverThatCountsInDegrees) {
  ImuConfig config;
  config.units = ImuConfig::Units::kDegrees;
  gate.configure(config);
  gate.set(mount());
  auto reading = readingAt(1.0, {0, 0, 90});
  reading.covariance = 4.0 * Eigen::Matrix3d::Identity();
  const auto sample = sampleOf(reading);
  EXPECT_NEAR(sample.angular_velocity.z(), M_PI_2, 1e-12);
  EXPECT_NEAR(sample.covariance(2, 2), 4.0 * std::pow(M_PI / 180.0, 2), 1e-12);
}

TEST_F(ImuGateTest, TurnsTheCovarianceWithTheMountWhereItIsOne) {
  gate.set(mount(turnedBy(M_PI_2, Eigen::Vector3d::UnitX())));
  auto reading = readingAt(1.0);
  reading.covariance = Eigen::Vector3d(1e-4, 2e-4, 3e-4).asDiagonal();
  EXPECT_NEAR(sampleOf(reading).covariance(2, 2), 2e-4, 1e-12);
  for (const double bad : {-1.0, kNaN, std::numeric_limits<double>::infinity(), 1e30}) {
    reading.covariance(0, 0) = bad;
    const auto sample = sampleOf(reading);
    EXPECT_TRUE(sample.covariance.isZero()) << bad;
    EXPECT_NEAR(sample.angular_velocity.z(), 0.2, 1e-12) << "the rate counts all the same";
  }
}

TEST_F(ImuGateTest, LeavesOutWhatIsNoAngularVelocity) {
  gate.set(mount());
  EXPECT_TRUE(says(refusalOf(readingAt(1.0, {0, kNaN, 0}), "bad_reading"), "not a number"));
  EXPECT_TRUE(says(refusalOf(readingAt(1.1, {0, 0, 1e9}), "bad_reading"), "no gyro measures"));
  sampleOf(readingAt(1.2));
}

TEST_F(ImuGateTest, ChecksWhatADriverCountsInDegreesInRadians) {
  ImuConfig config;
  config.units = ImuConfig::Units::kDegrees;
  gate.configure(config);
  gate.set(mount());
  const auto rate_of = [](double degrees) { return Eigen::Vector3d(0, 0, degrees); };
  EXPECT_TRUE(says(refusalOf(readingAt(1.0, rate_of(1.8e8)), "bad_reading"), "3.14159e+06 rad/s"));
  EXPECT_NEAR(sampleOf(readingAt(1.1, rate_of(36000))).angular_velocity.z(), 200 * M_PI, 1e-9);
}

TEST_F(ImuGateTest, LeavesOutZerosOfAnImuThatSaysThatItHasNoGyro) {
  gate.set(mount());
  auto reading = readingAt(1.0, Eigen::Vector3d::Zero());
  sampleOf(reading);  // a gyro may measure zero
  reading.covariance(0, 0) = -1.0;
  EXPECT_TRUE(says(refusalOf(reading, "no_gyro"), "it has no gyro"));
  EXPECT_EQ(gate.dropped(), 1u);
  reading.angular_velocity.x() = 1e-3;  // a driver that knows no covariance
  sampleOf(reading);
}

TEST_F(ImuGateTest, LeavesOutReadingsWhoseMountIsNone) {
  Eigen::Isometry3d broken = Eigen::Isometry3d::Identity();
  broken.linear() *= 2.0;
  gate.set(mount(broken));
  EXPECT_TRUE(says(refusalOf(readingAt(1.0), "bad_mount"), "its rotation is no rotation"));
  gate.set(mount());
  sampleOf(readingAt(1.1));
}

TEST_F(ImuGateTest, GoesOnFromASavedState) {
  for (const double s : {1.0, 1.5}) gate.set(readingAt(s));
  next();
  ArchiveWriter writer;
  gate.saveState(writer);
  const auto state = writer.take();
  ImuGate other;
  other.configure(ImuConfig());
  ArchiveReader reader(state);
  other.restoreState(reader);
  EXPECT_EQ(other.held()["no_mount"], 2u);
  other.set(mount());
  other.execute();
  EXPECT_EQ(other.sample()->stamp, Stamp(durationFromSeconds(1.0)));
}

}  // namespace
}  // namespace slam
