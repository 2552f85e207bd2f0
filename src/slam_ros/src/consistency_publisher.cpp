// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/consistency_publisher.hpp"

#include "slam_ros/conversions.hpp"

namespace slam_ros {
namespace {

using Source = slam::ConsistencyMonitor::Source;

constexpr Source kSources[] = {Source::kRange, Source::kBearing, Source::kMotion};
constexpr std::size_t kMostPending = 100;

}  // namespace

ConsistencyPublisher::ConsistencyPublisher(ros::NodeHandle handle, Diagnostics& diagnostics,
                                           const slam::ConsistencyMonitor& monitor)
    : monitor_(monitor), publisher_(handle.advertise<slam_msgs::Consistency>("consistency", 100)) {
  diagnostics.add("consistency", [this](auto& status) { fill(status); });
}

void ConsistencyPublisher::subscribe(ros::NodeHandle handle) {
  subscriber_ = handle.subscribe("ground_truth/pose", 100, &ConsistencyPublisher::onTruth, this);
}

void ConsistencyPublisher::restart() {
  truth_.reset();
  pending_.clear();
  nees_ = -1.0;
  trust_ = slam::Trust::kUnknown;
  doubt_.clear();
}

void ConsistencyPublisher::onTruth(const geometry_msgs::PoseStamped& message) {
  const auto pose = fromMsg(message.pose);
  if (pose.isFinite()) truth_.add(fromRos(message.header.stamp), pose);
  flush();
}

void ConsistencyPublisher::publish(const slam::StepReport& report) {
  if (!report.hasTrigger()) return;
  trust_ = report.trust;
  doubt_ = report.doubt;
  pending_.push_back({messageOf(report), report.stamp, report.pose});
  flush();
}

void ConsistencyPublisher::flush() {
  while (!pending_.empty()) {
    auto& [message, stamp, pose] = pending_.front();
    if (truth_.isExpected(stamp) && pending_.size() <= kMostPending) return;
    message.nees = nees_ = truth_.nees(stamp, pose).value_or(-1.0);
    publisher_.publish(message);
    pending_.pop_front();
  }
}

slam_msgs::Consistency ConsistencyPublisher::messageOf(const slam::StepReport& report) const {
  slam_msgs::Consistency message;
  message.header.stamp = toRos(report.stamp);
  message.trust = slam::nameOf(report.trust, slam::namesOfTrust());
  message.doubt = report.doubt;
  message.nis = report.statistics.nis;
  message.nis_dof = static_cast<std::uint32_t>(report.statistics.nis_dof);
  message.nis_mean = monitor_.nisMean();
  const auto bounds = monitor_.nisBounds();
  message.nis_bounds = {bounds[0], bounds[1]};
  message.updates = static_cast<std::uint32_t>(monitor_.updates());
  for (const auto source : kSources) {
    message.sources.push_back(slam::ConsistencyMonitor::name(source));
    message.factors.push_back(monitor_.factors()[source].sigma);
    message.uncertainties.push_back(monitor_.factors()[source].uncertainty);
  }
  message.finding = monitor_.finding();
  return message;
}

void ConsistencyPublisher::fill(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  const auto finding = monitor_.finding();
  const bool is_faulty = monitor_.fault() != slam::ConsistencyMonitor::Fault::kNone;
  if (trust_ == slam::Trust::kLost)
    status.summary(DiagnosticStatus::ERROR, "the robot is lost: " + doubt_);
  else if (trust_ == slam::Trust::kDoubtful)
    status.summary(DiagnosticStatus::WARN, "the pose is in doubt: " + doubt_);
  else if (!finding.empty())
    status.summary(is_faulty ? DiagnosticStatus::WARN : DiagnosticStatus::OK, finding);
  else
    status.summary(DiagnosticStatus::OK, monitor_.updates() == 0
                                             ? "nothing to judge by"
                                             : "errors match the reported covariance");
  status.add("trust", slam::nameOf(trust_, slam::namesOfTrust()));
  status.add("updates", monitor_.updates());
  status.add("NIS per degree of freedom", monitor_.nisMean());
  for (const auto source : kSources)
    status.addf(std::string(slam::ConsistencyMonitor::name(source)) + " sigma, true over believed",
                "%.2f +- %.2f", monitor_.factors()[source].sigma,
                monitor_.factors()[source].uncertainty);
  if (nees_ >= 0.0) status.add("NEES of the pose", nees_);
}

}  // namespace slam_ros
