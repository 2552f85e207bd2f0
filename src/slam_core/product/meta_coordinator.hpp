// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

#include "slam_core/product/product_components.hpp"

namespace slam {

/// The whole product in one process (thesis Fig. 4.4): creates the components the product names,
/// passes raw inputs through the front-end to the estimator. Components know nothing of one
/// another.
class MetaCoordinator {
 public:
  /// A fresh start. @throw ConfigError listing the faults of all sections
  void configure(Settings& settings);

  /// Nothing comes of it where the product looks at the ceiling instead.
  void set(OdometrySample sample);
  /// Of the camera that looks at the ceiling: an Image, its CameraCalibration or CameraMount.
  /// Nothing comes of them where the odometry is the wheels'.
  template <class Input>
  void setForOdometry(const Input& input);
  /// Of the camera that looks for landmarks. Nothing comes of these three where the product looks
  /// at no images.
  void set(const Image& image) { setForDetector(image); }
  void set(const CameraCalibration& calibration) { setForDetector(calibration); }
  void set(const CameraMount& mount) { setForDetector(mount); }
  /// Of the laser. Nothing comes of these two where the product uses no scans.
  void set(LaserSweep sweep);
  void set(const LaserMount& mount);
  /// For data that already carry what a component would make.
  void set(const Motion& motion);
  void set(const LandmarkObservationArray& observations) { parts_.estimator.set(observations); }
  /// In force at once, as Estimator::set(). The point map begins anew: this one has another frame.
  Status set(const MapState& map);

  /// Called with every motion that the odometry source makes, its frames completed.
  std::function<void(const Motion&)> on_motion;
  /// Called with every array that the detector makes.
  std::function<void(const LandmarkObservationArray&)> on_detections;

  /// Whether anything comes of scans.
  bool usesScans() const { return parts_.estimator.usesScans() || parts_.point_map; }

  /// One step, as Estimator::execute(), and when none is due the point map's turn; a warning of
  /// these others comes first.
  Status execute();

  Estimator& estimator() { return parts_.estimator; }
  const Estimator& estimator() const { return parts_.estimator; }
  const OdometrySource& odometry() const { return *parts_.odometry; }
  /// Of the product's images; null where it looks at none.
  const LandmarkDetector* detector() const { return parts_.detector.get(); }
  /// Null where the product has none.
  const point_map::PointMap* pointMap() const { return parts_.point_map.get(); }
  const FramesConfig& frames() const { return parts_.frames; }
  /// Of the front-end ("odometry_...", "detector_...", "laser_..."), the point map ("pointmap_...")
  /// and the estimator.
  Counters counters() const;
  std::uint64_t dropped() const;
  /// Of the laser, waiting for its mount.
  std::size_t heldScans() const { return parts_.laser.held(); }

  void reset();

 private:
  template <class Input>
  void setForDetector(const Input& input);
  void takeMotions();
  void takeScans();
  void updatePointMap();
  void note(const Status& status);

  ProductComponents parts_;
  Status front_end_status_;
};

}  // namespace slam
