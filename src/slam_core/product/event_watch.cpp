// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/event_watch.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

#include "slam_core/geometry/angle.hpp"
#include "slam_core/models/moved_pose.hpp"

namespace slam {
namespace {

/// The quantile 0.999 of the chi-square distribution with three degrees of freedom.
constexpr double kGate = 16.27;

/// @return how far a pose is from the predicted one, in the map frame
Eigen::Vector3d correctionOf(const PoseEstimate& predicted, const Pose2& pose) {
  Eigen::Vector3d e = pose.vector() - predicted.pose.vector();
  e.z() = wrapAngle(e.z());
  return e;
}

}  // namespace

void EventsConfig::describe(Fields& fields) {
  fields.add("jump_position", &jump_position, "a step that corrects the pose by less is no event")
      .unit("m")
      .in(Range::atLeast(0));
  fields.add("jump_heading", &jump_heading, "unless it turns the pose by more than this")
      .unit("rad")
      .in(Range::atLeast(0));
}

void EventWatch::predict(const Motion& motion) {
  if (pose_) pose_ = moved(*pose_, motion);
}

void EventWatch::complete(StepReport& report, const Capabilities& backend) {
  report.is_relocated = relocation_.has_value();
  if (pose_ && (report.has_motion || relocation_)) {
    const auto e = correctionOf(*pose_, report.pose.pose);
    report.correction = {e.head<2>().norm(), std::abs(e.z())};
  }
  addOwn(report, backend);
  addJump(report);
  addTrust(report);
  for (auto& event : report.events) event.stamp = report.stamp;
  pose_ = report.pose;
  relocation_.reset();
}

void EventWatch::addOwn(StepReport& report, const Capabilities& backend) const {
  const auto* reporter = backend.find<EventReporter>();
  if (reporter == nullptr) return;
  for (auto& event : reporter->events()) {
    const bool may_be_small = event.kind != Event::Kind::kLoopClosed;
    if (may_be_small || isLarge(event.distance, event.turn)) report.events.push_back(event);
  }
}

/// What a back-end has explained is not reported twice.
void EventWatch::addJump(StepReport& report) const {
  if (!report.correction) return;
  const auto [distance, turn] = *report.correction;
  Event event{Event::Kind::kJump, distance, turn, "", {}};
  if (relocation_) {
    event.reason = *relocation_;
  } else {
    if (!report.events.empty() || !isLarge(distance, turn)) return;
    const auto e = correctionOf(*pose_, report.pose.pose);
    if (e.dot(pose_->covariance.ldlt().solve(e)) <= kGate) return;
    event.reason = "the pose was corrected by more than its uncertainty";
  }
  report.events.push_back(event);
}

/// A doubt lasts for a second at least, so that the trust does not flicker.
void EventWatch::addTrust(StepReport& report) {
  constexpr auto kHold = std::chrono::seconds(1);
  if (report.trust == Trust::kDoubtful) doubted_ = report.stamp;
  const bool is_held = doubted_ && report.stamp - *doubted_ < kHold;
  if (report.trust == Trust::kConfident && trust_ != Trust::kConfident && is_held)
    report.trust = Trust::kDoubtful;
  addLoss(report);
  const bool was_doubtful = trust_ == Trust::kDoubtful,
             is_doubtful = report.trust == Trust::kDoubtful;
  if (is_doubtful && !was_doubtful)
    report.events.push_back({Event::Kind::kDoubtful, 0.0, 0.0, report.doubt, {}});
  if (was_doubtful && report.trust == Trust::kConfident)
    report.events.push_back(
        {Event::Kind::kConfident, 0.0, 0.0, "nothing speaks against the pose any more", {}});
  trust_ = report.trust;
}

void EventWatch::addLoss(StepReport& report) {
  const bool is_lost = report.trust == Trust::kLost;
  if (is_lost == lost_since_.has_value()) return;
  if (is_lost) {
    lost_since_ = report.stamp;
    report.events.push_back({Event::Kind::kLost, 0.0, 0.0, report.doubt, {}});
    return;
  }
  const double time = seconds(report.stamp - *std::exchange(lost_since_, std::nullopt));
  report.events.push_back({Event::Kind::kFound,
                           0.0,
                           0.0,
                           fmt::format("what is seen fits the map again, after {:.1f} s", time),
                           {}});
}

bool EventWatch::isLarge(double distance, double turn) const {
  return distance > config_.jump_position || turn > config_.jump_heading;
}

}  // namespace slam
