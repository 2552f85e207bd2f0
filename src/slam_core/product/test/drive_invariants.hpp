// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <map>
#include <optional>
#include <string>

#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/product/test/fault_world.hpp"

namespace slam::test {

/// What must hold after every step of a product, whatever it was given.
class DriveInvariants {
 public:
  /// @return what was broken first; empty where nothing was
  const std::string& broken() const { return broken_; }
  bool hold() const { return broken_.empty(); }
  void fail(const std::string& what) {
    if (hold()) broken_ = what;
  }

  /// Whether poses must not be wrong and sure of themselves.
  void expectHonesty(bool expects) { expects_honesty_ = expects; }

  /// Something else than a message may have set the state: counters and stamps may go back.
  void beginAnew() {
    last_.reset();
    is_counted_anew_ = true;
  }

  /// A message that the product is given next.
  void count(const Message& message) { given_ += isTrigger(message) ? 1 : 0; }

  void check(const Status& status) {
    if (status.level == Status::Level::kError) fail("an error: " + status.message);
  }

  void check(const StepReport& report, const FaultWorld::Truths& truths) {
    const auto& [pose, P] = report.pose;
    if (!pose.isFinite() || !P.allFinite()) return fail("a pose that is not finite");
    if ((P - P.transpose()).norm() > 1e-9 * P.norm()) fail("a covariance without symmetry");
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(P);
    if (eigen.eigenvalues()(0) < -1e-12 * eigen.eigenvalues()(2))
      fail(fmt::format("a covariance with the eigenvalue {}", eigen.eigenvalues()(0)));
    if (last_ && report.stamp < *last_ && !report.restarted) fail("a step back in time");
    last_ = report.stamp;
    is_counted_anew_ = is_counted_anew_ || report.restarted;
    taken_ += report.trigger.empty() ? 0 : 1;
    judgeHonesty(report, truths);
  }

  /// When all steps that are due have been taken.
  void check(const MetaCoordinator& product) {
    const auto counters = product.counters();
    for (const auto& [reason, count] : counted_.all())
      if (!is_counted_anew_ && !isOfNow(reason) && counters[reason] < count)
        fail("the counter " + reason + " goes back");
    std::uint64_t held = 0;
    for (const auto& [what, count] : product.estimator().intake().arrivals().held().all()) {
      held += count;
      if (count > kMostHeld) fail(fmt::format("{} messages of {} are held", count, what));
    }
    if (product.components().odometry == nullptr) checkThatNoneVanished(counters, held);
    counted_ = counters;
    // what is set aside may be motion or triggers
    is_counted_anew_ = is_counted_anew_ && counters["set_aside"] > 0;
  }

  /// @param bytes of a checkpoint @param steps of the drive
  void checkSize(std::size_t bytes, int steps) {
    largest_ = std::max(largest_, bytes);
    static_cast<void>(steps);
  }
  std::size_t largest() const { return largest_; }

  void checkEnd(const MetaCoordinator& product) {
    if (wrong_ > 5 && 100 * wrong_ > judged_)
      fail(fmt::format("{} of {} poses are wrong and sure of themselves", wrong_, judged_));
    const auto* keeper = product.estimator().capabilities().find<MapKeeper>();
    if (keeper == nullptr) return;
    for (const auto& landmark : keeper->state().landmarks)
      if (!landmark.position.allFinite() || !landmark.covariance.allFinite())
        fail(fmt::format("landmark {} is not finite", landmark.id));
  }

 private:
  static bool isTrigger(const Message& message) {
    return !std::holds_alternative<Motion>(message) &&
           !std::holds_alternative<OdometrySample>(message);
  }

  /// Whether it counts what waits, and not what has happened.
  static bool isOfNow(const std::string& reason) {
    return reason.find("set_aside") != std::string::npos;
  }

  /// Whatever triggers steps is taken, held or counted under the reason for which it is not.
  void checkThatNoneVanished(const Counters& counters, std::uint64_t held) {
    std::uint64_t dropped = counters["set_aside"];
    for (const auto* reason :
         {"late", "before_start", "overflow", "stamp_jump", "invalid_scan", "abandoned", "in_gap"})
      dropped += counters[reason];
    if (is_counted_anew_) {
      given_ = held + dropped;  // as if these had come now
      taken_ = 0;
    }
    if (given_ < taken_ + held)
      fail(fmt::format("of {} triggers {} are taken and {} held", given_, taken_, held));
    if (given_ > taken_ + held + dropped)
      fail(fmt::format("of {} triggers {} are taken, {} held and {} dropped:{}", given_, taken_,
                       held, dropped, listed(counters)));
  }

  static std::string listed(const Counters& counters) {
    std::string list;
    for (const auto& [reason, count] : counters.all()) list += fmt::format(" {} {}", reason, count);
    return list;
  }

  void judgeHonesty(const StepReport& report, const FaultWorld::Truths& truths) {
    const auto truth = truths.find(report.stamp);
    if (!expects_honesty_ || truth == truths.end()) return;
    const Eigen::Vector2d error = report.pose.pose.position() - truth->second.position();
    const Eigen::Matrix2d P = report.pose.covariance.topLeftCorner<2, 2>();
    ++judged_;
    wrong_ += error.norm() > 0.3 && error.dot(P.inverse() * error) > 25.0 ? 1 : 0;
  }

  static constexpr std::uint64_t kMostHeld = 5000;

  std::string broken_;
  bool expects_honesty_ = false;
  std::optional<Stamp> last_;
  bool is_counted_anew_ = true;
  Counters counted_;
  std::uint64_t given_ = 0, taken_ = 0;  ///< triggers, since it was counted anew
  int judged_ = 0, wrong_ = 0;           ///< poses
  std::size_t largest_ = 0;              ///< checkpoint [bytes]
};

}  // namespace slam::test
