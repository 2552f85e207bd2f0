// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "slam_core/models/motion.hpp"

namespace slam {

/// Detects that the odometry and the back-end, which follows its sensors, report contradictory
/// motions: one moves while the other stands still, or they turn in opposite directions. Then
/// wheels slip or stand, or a laser repeats its scans or reverses its beams, and it is unknown
/// which of the two is right. The robot is at one of the two predicted poses, and the distance
/// between them is how far the pose may be wrong.
///
/// The motions are compared in pieces of 0.3 m, and their turns in pieces of 0.3 rad or 1.5 m. A
/// wrong scale is not a contradiction (ScaleDoubt), and neither is a single correction, however
/// large.
class WayContradiction {
 public:
  /// To be called for each step.
  /// @param odometry since the last step, with its covariance
  /// @param estimated the back-end's increment, in the robot's frame before it
  void add(const Motion& odometry, const Pose2& estimated);

  /// Whether several pieces in a row were contradictory, and not many have agreed since.
  bool isEvident() const { return ways_.isEvident() || turns_.isEvident(); }
  /// The pose by odometry may be so far from the back-end's pose, in standard deviations. The
  /// distance is computed from the motions of both since the contradiction began and from the
  /// odometry's noise. It is 0 if there is no contradiction.
  struct Distance {
    double position = 0.0;  ///< [m]
    double heading = 0.0;   ///< [rad]
  };
  Distance apart() const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(ways_, turns_, since_);
  }

 private:
  /// The same piece of the path by both.
  struct Piece {
    Motion odometry;
    Pose2 estimated;

    void add(const Motion& next, const Pose2& next_estimated);
    template <class Archive>
    void persist(Archive& archive) {
      archive(odometry, estimated);
    }
  };
  /// Judges one piece after the other, by its translation or by its turn.
  class Comparison {
   public:
    using Verdict = bool (*)(const Piece&);
    /// @param is_complete whether a piece is long enough @param is_contradictory judges it
    Comparison(Verdict is_complete, Verdict is_contradictory)
        : is_complete_(is_complete), is_contradictory_(is_contradictory) {}

    void add(const Motion& odometry, const Pose2& estimated);
    bool isEvident() const { return is_evident_; }
    /// The last complete piece, if it is contradictory; until the next one is complete.
    const std::optional<Piece>& contradictory() const { return contradictory_; }

    template <class Archive>
    void persist(Archive& archive) {
      archive(piece_, contradictory_, in_a_row_, agreeing_, is_evident_);
    }

   private:
    Verdict is_complete_, is_contradictory_;
    std::optional<Piece> piece_;
    std::optional<Piece> contradictory_;
    int in_a_row_ = 0, agreeing_ = 0;  ///< contradictory pieces, and others, up to the last one
    bool is_evident_ = false;
  };

  static bool isWay(const Piece& piece);
  static bool isTurn(const Piece& piece);
  static bool haveContradictoryWays(const Piece& piece);
  static bool haveContradictoryTurns(const Piece& piece);

  Comparison ways_{isWay, haveContradictoryWays}, turns_{isTurn, haveContradictoryTurns};
  std::optional<Piece> since_;  ///< the first contradictory piece, and all that followed
};

}  // namespace slam
