// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/image.hpp"
#include "slam_core/contract/landmark_detector.hpp"
#include "slam_core/contract/map_module.hpp"
#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/filter_pose.hpp"

// A library of components that a product cannot join with others, or has never seen.

namespace slam_odd {

/// A kind of data that nothing in slam_ros knows.
struct InertialSample {
  slam::Stamp stamp;
};

namespace {

/// An odometry source of whatever its class describes; it makes no motion.
class Source : public slam::OdometrySource {
 public:
  void configure(slam::Settings&) override {}
  slam::Status execute() override { return slam::Status::ok(); }
  const std::optional<slam::Motion>& motion() const override { return motion_; }
  slam::Counters counters() const override { return {}; }
  void reset() override {}

 protected:
  template <class T>
  static slam::InputPort& takes(slam::Ports& ports, const std::string& name) {
    return ports.takes<T>(name, "data", [](const T&) {});
  }

 private:
  std::optional<slam::Motion> motion_;
};

class InertialSource final : public Source {
 public:
  void describe(slam::Ports& ports) override {
    takes<InertialSample>(ports, "imu");
    ports.makes<slam::Motion>("motion", motion());
  }
};

class SteeredSource final : public Source {
 public:
  void describe(slam::Ports& ports) override {
    takes<InertialSample>(ports, "observation");
    ports.makes<slam::Motion>("motion", motion());
  }
};

class ContentSource final : public Source {
 public:
  void describe(slam::Ports& ports) override {
    takes<slam::OdometrySample>(ports, "rear_odom");
    takes<InertialSample>(ports, "imu").optional();
    ports.makes<slam::Motion>("motion", motion());
  }
};

class DrivenSource final : public Source {
 public:
  void describe(slam::Ports& ports) override {
    takes<slam::OdometrySample>(ports, "rear_odom");
    ports.makes<slam::Motion>("motion", motion());
  }
};

class BlindSource final : public Source {
 public:
  void describe(slam::Ports& ports) override { ports.makes<slam::Motion>("motion", motion()); }
};

/// A detector that tells how the robot moves as well.
class MovingDetector final : public slam::LandmarkDetector {
 public:
  void describe(slam::Ports& ports) override {
    ports.takes<slam::Image>("camera", "images", [](const slam::Image&) {});
    ports.makes<slam::LandmarkObservationArray>("observations", observations_);
    ports.makes<slam::Motion>("motion", motion_);
  }
  void configure(slam::Settings&) override {}
  slam::Status execute() override { return slam::Status::ok(); }
  const std::optional<slam::LandmarkObservationArray>& observations() const override {
    return observations_;
  }
  slam::Counters counters() const override { return {}; }
  void reset() override {}

 private:
  std::optional<slam::LandmarkObservationArray> observations_;
  std::optional<slam::Motion> motion_;
};

/// A detector that looks at what the back-end makes of its own observations.
class PeekingDetector final : public slam::LandmarkDetector {
 public:
  void describe(slam::Ports& ports) override {
    ports.takes<slam::FilterPose>("pose", "poses", [](const slam::FilterPose&) {});
    ports.makes<slam::LandmarkObservationArray>("observations", observations_);
  }
  void configure(slam::Settings&) override {}
  slam::Status execute() override { return slam::Status::ok(); }
  const std::optional<slam::LandmarkObservationArray>& observations() const override {
    return observations_;
  }
  slam::Counters counters() const override { return {}; }
  void reset() override {}

 private:
  std::optional<slam::LandmarkObservationArray> observations_;
};

/// A module that makes nothing.
class EchoMap final : public slam::MapModule {
 public:
  void describe(slam::Ports& ports) override {
    ports.takes<slam::FilterPose>("pose", "poses", [](const slam::FilterPose&) {});
  }
  void configure(slam::Settings&) override {}
  slam::Status execute() override { return slam::Status::ok(); }
  slam::Counters counters() const override { return {}; }
  void reset() override {}
  std::string sentence() const override { return "nothing at all"; }
  void save(const std::string&) const override {}
};

const slam::Registrar<slam::MapModule, EchoMap> kEchoMap("echo_map");
const slam::Registrar<slam::OdometrySource, InertialSource> kInertial("inertial");
const slam::Registrar<slam::OdometrySource, SteeredSource> kSteered("steered");
const slam::Registrar<slam::OdometrySource, ContentSource> kContent("content");
const slam::Registrar<slam::OdometrySource, DrivenSource> kDriven("driven");
const slam::Registrar<slam::OdometrySource, BlindSource> kBlind("blind");
const slam::Registrar<slam::LandmarkDetector, MovingDetector> kMoving("moving");
const slam::Registrar<slam::LandmarkDetector, PeekingDetector> kPeeking("peeking");

}  // namespace
}  // namespace slam_odd
