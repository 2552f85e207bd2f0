// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationBearingRange.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace slam::eval {

/// Writes a rawlog with MRPT, object by object; times are [s] since 1970, 0: no time.
class RawlogMaker {
 public:
  explicit RawlogMaker(const std::string& path) : file_(path) {}

  /// Motion by an increment in the robot frame.
  void action(double x, double y, double theta) {
    mrpt::obs::CActionRobotMovement2D motion;
    motion.computeFromOdometry(mrpt::poses::CPose2D(x, y, theta),
                               mrpt::obs::CActionRobotMovement2D::TMotionModelOptions());
    mrpt::obs::CActionCollection actions;
    actions.insert(motion);
    object(actions);
  }

  void frame(const mrpt::obs::CObservationBearingRange& observation) {
    mrpt::obs::CSensoryFrame frame;
    frame.insert(mrpt::obs::CObservationBearingRange::Create(observation));
    object(frame);
  }

  void frame(double time, float range = 2.0f, float yaw = 0.5f, int id = 3) {
    frame(bearingRange(time, range, yaw, id));
  }

  void object(const mrpt::serialization::CSerializable& object) {
    mrpt::serialization::archiveFrom(file_) << object;
  }

  void frame(const std::vector<mrpt::obs::CObservation2DRangeScan>& scans) {
    mrpt::obs::CSensoryFrame frame;
    for (const auto& scan : scans) frame.insert(mrpt::obs::CObservation2DRangeScan::Create(scan));
    object(frame);
  }

  /// Three beams over half a circle, from the right to the left; the last one saw nothing.
  static mrpt::obs::CObservation2DRangeScan scan(double time, const std::string& label = "front",
                                                 double yaw = 0.0) {
    mrpt::obs::CObservation2DRangeScan scan;
    scan.timestamp = clock(time);
    scan.sensorLabel = label;
    scan.sensorPose = mrpt::poses::CPose3D(0.5, 0.1, 0.3, yaw, 0.0, 0.0);
    scan.aperture = static_cast<float>(M_PI);
    scan.maxRange = 80.0f;
    const float ranges[] = {1.0f, 2.0f, 81.9f};
    const char valid[] = {1, 0, 0};
    scan.loadFromVectors(3, ranges, valid);
    return scan;
  }

  void observation(const mrpt::obs::CObservation& observation) { object(observation); }

  void odometry(double time, double x, double y, double theta) {
    mrpt::obs::CObservationOdometry odometry;
    odometry.timestamp = clock(time);
    odometry.odometry = mrpt::poses::CPose2D(x, y, theta);
    observation(odometry);
  }

  static mrpt::obs::CObservationBearingRange bearingRange(double time, float range = 2.0f,
                                                          float yaw = 0.5f, int id = 3) {
    mrpt::obs::CObservationBearingRange observation;
    observation.timestamp = clock(time);
    observation.sensor_std_range = 0.1f;
    observation.sensor_std_yaw = 0.02f;
    mrpt::obs::CObservationBearingRange::TMeasurement measurement{};
    measurement.range = range;
    measurement.yaw = yaw;
    measurement.landmarkID = id;
    observation.sensedData.push_back(measurement);
    return observation;
  }

 private:
  static mrpt::Clock::time_point clock(double time) {
    return time == 0.0 ? INVALID_TIMESTAMP : mrpt::Clock::fromDouble(time);
  }

  mrpt::io::CFileGZOutputStream file_;
};

}  // namespace slam::eval
