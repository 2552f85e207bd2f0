// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_steps.hpp"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationBearingRange.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "horizontal_reading.hpp"
#include "import_error.hpp"
#include "rawlog_lasers.hpp"

namespace slam::eval {

namespace {

using mrpt::obs::CActionCollection;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CActionRobotMovement3D;
using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationBearingRange;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CSensoryFrame;
using Object = mrpt::serialization::CSerializable::Ptr;

/// MRPT counts 100 ns since 1601. @return [ns] since 1970; 0: missing, or no time that ROS can hold
std::int64_t toNanoseconds(mrpt::Clock::time_point time) {
  constexpr std::int64_t kUnixEpoch = 116'444'736'000'000'000;
  constexpr std::int64_t kLatest = 10'000'000ll * std::numeric_limits<std::uint32_t>::max();
  const std::int64_t since_1970 = time.time_since_epoch().count() - kUnixEpoch;
  return since_1970 > 0 && since_1970 < kLatest ? since_1970 * 100 : 0;
}

Eigen::Matrix3d covarianceOf(const CObservationBearingRange& observation,
                             const CObservationBearingRange::TMeasurement& measurement) {
  if (observation.validCovariances) return measurement.covariance.asEigen();
  const Eigen::Vector3d sigmas(observation.sensor_std_range, observation.sensor_std_yaw,
                               observation.sensor_std_pitch);
  return sigmas.cwiseAbs2().asDiagonal();
}

bool isPositiveDefinite(const Eigen::Matrix2d& m) {
  return m.allFinite() && m(0, 0) > 0.0 && m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0) > 0.0;
}

std::array<double, 4> toArray(const Eigen::Matrix2d& m) {
  if (!isPositiveDefinite(m)) return {-1.0, 0.0, 0.0, 0.0};
  return {m(0, 0), m(0, 1), m(1, 0), m(1, 1)};
}

RawlogLog::Odometry toOdometry(const mrpt::poses::CPose2D& pose) {
  RawlogLog::Odometry odometry;
  odometry.x = pose.x();
  odometry.y = pose.y();
  odometry.theta = pose.phi();
  return odometry;
}

bool isFinite(const RawlogLog::Odometry& o) {
  return std::isfinite(o.x) && std::isfinite(o.y) && std::isfinite(o.theta) &&
         std::isfinite(o.vx) && std::isfinite(o.vy) && std::isfinite(o.omega);
}

/// Walks through the objects and turns each into steps.
class StepMaker {
 public:
  explicit StepMaker(const std::string& path) : path_(path) {}

  RawlogSteps make(const std::vector<Object>& objects) {
    findActions(objects);
    for (const Object& object : objects) add(object);
    result_.left_out_odometry += pending_actions_;
    result_.lasers = lasers_.all();
    if (!has_odometry_) {
      throw ImportError(path_ +
                        " holds no planar odometry (CActionRobotMovement2D or "
                        "CObservationOdometry): there is nothing to import");
    }
    return std::move(result_);
  }

 private:
  void findActions(const std::vector<Object>& objects) {
    for (const Object& object : objects) {
      const auto actions = std::dynamic_pointer_cast<CActionCollection>(object);
      if (!actions) continue;
      if (actions->getActionByClass<CActionRobotMovement2D>()) {
        result_.has_actions = true;
      } else if (actions->getActionByClass<CActionRobotMovement3D>()) {
        throw ImportError(path_ +
                          " holds motion in space (CActionRobotMovement3D); only planar "
                          "logs can be imported");
      }
    }
  }

  void add(const Object& object) {
    if (const auto actions = std::dynamic_pointer_cast<CActionCollection>(object)) {
      addActions(*actions);
    } else if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object)) {
      addFrame(*frame);
    } else if (const auto observation = std::dynamic_pointer_cast<CObservation>(object)) {
      if (addObservation(observation)) ++result_.frames;
    } else {
      ++result_.other_objects;
    }
  }

  void addActions(const CActionCollection& actions) {
    const auto motion = actions.getActionByClass<CActionRobotMovement2D>();
    if (!motion) return;
    pose_ = pose_ + motion->poseChange->getMeanVal();
    if (!isFinite(toOdometry(pose_)))
      throw ImportError(path_ + " holds a motion that is no number");
    ++pending_actions_;
    has_odometry_ = true;
  }

  void addFrame(const CSensoryFrame& frame) {
    bool ticked = false;
    for (const auto& observation : frame) ticked = addObservation(observation) || ticked;
    if (!ticked && !frame.empty()) {
      result_.steps.push_back(makeTick((*frame.begin())->timestamp));
    }
    if (!frame.empty()) ++result_.frames;
  }

  /// @return whether the clock ticked
  bool addObservation(const CObservation::Ptr& observation) {
    if (const auto odometry = std::dynamic_pointer_cast<CObservationOdometry>(observation)) {
      addOdometry(*odometry);
      return false;
    }
    if (const auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(observation))
      return addScan(*scan);
    const auto bearings = std::dynamic_pointer_cast<CObservationBearingRange>(observation);
    if (!bearings) {
      ++result_.other_objects;
      return false;
    }
    RawlogStep step = makeTick(bearings->timestamp);
    step.sighting = makeSighting(*bearings);
    result_.steps.push_back(std::move(step));
    return true;
  }

  bool addScan(const CObservation2DRangeScan& observation) {
    auto reading = toReading(observation);
    if (!reading) {
      ++result_.left_out_scans;
      return false;
    }
    RawlogStep step = makeTick(observation.timestamp);
    step.scan = RawlogLog::Scan{0, lasers_.add(observation), std::move(*reading)};
    result_.steps.push_back(std::move(step));
    return true;
  }

  RawlogStep makeTick(mrpt::Clock::time_point time) {
    RawlogStep step;
    step.stamp = toNanoseconds(time);
    step.frame = result_.frames;
    step.ends_frame = true;
    if (result_.has_actions) step.odometry = toOdometry(pose_);
    if (result_.steps.empty()) result_.begins_with_action = pending_actions_ > 0;
    pending_actions_ = 0;
    return step;
  }

  void addOdometry(const CObservationOdometry& observation) {
    if (result_.has_actions) {
      ++result_.left_out_odometry;
      return;
    }
    RawlogStep step;
    step.stamp = toNanoseconds(observation.timestamp);
    step.frame = result_.frames;
    step.odometry = toOdometry(observation.odometry);
    if (observation.hasVelocities) {
      step.odometry->vx = observation.velocityLocal.vx;
      step.odometry->vy = observation.velocityLocal.vy;
      step.odometry->omega = observation.velocityLocal.omega;
    }
    if (!isFinite(*step.odometry))
      throw ImportError(path_ + " holds an odometry that is no number");
    has_odometry_ = true;
    result_.steps.push_back(std::move(step));
  }

  RawlogLog::Sighting makeSighting(const CObservationBearingRange& observation) {
    const mrpt::poses::CPose3D& sensor = observation.sensorLocationOnRobot;
    const mrpt::poses::CPose3D level(0.0, 0.0, 0.0, 0.0, sensor.pitch(), sensor.roll());
    const Eigen::Matrix3d level_rotation = level.getRotationMatrix().asEigen();
    RawlogLog::Sighting sighting;
    sighting.frame = result_.frames;
    sighting.sensor = observation.sensorLabel.empty() ? "landmark_sensor" : observation.sensorLabel;
    sighting.x = sensor.x();
    sighting.y = sensor.y();
    sighting.theta = sensor.yaw();
    for (const auto& measurement : observation.sensedData) {
      const Eigen::Vector3d spherical(measurement.range, measurement.yaw, measurement.pitch);
      const HorizontalReading reading =
          toHorizontal(level_rotation, spherical, covarianceOf(observation, measurement));
      if (!spherical.allFinite() || measurement.range <= 0.0f || reading.range <= 0.0) {
        ++result_.left_out_readings;
        continue;
      }
      const std::int64_t id = measurement.landmarkID < 0 ? -1 : measurement.landmarkID;
      sighting.readings.push_back(
          {id, reading.range, reading.bearing, toArray(reading.covariance)});
    }
    return sighting;
  }

  std::string path_;
  RawlogSteps result_;
  RawlogLasers lasers_;
  mrpt::poses::CPose2D pose_;
  std::size_t pending_actions_ = 0;  // since the last frame
  bool has_odometry_ = false;
};

}  // namespace

RawlogSteps makeRawlogSteps(const std::vector<Object>& objects, const std::string& path) {
  return StepMaker(path).make(objects);
}

}  // namespace slam::eval
