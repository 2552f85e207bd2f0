// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <deque>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/relocalisation/local_landmarks.hpp"

namespace slam::relocalisation {

/// Judges whether the view of one landmark sensor has changed suddenly: the landmarks of a view are
/// gone, and others are seen that were not seen before. Then the robot was carried away, or its
/// sensor was turned. An object in front of the sensor hides landmarks as well, but shows no
/// others; and while a robot explores, landmarks come and go one by one.
///
/// Views are compared by their landmarks' ids or, where these say nothing, by their places, which
/// odometry moves into the robot's current frame. Neither a map nor a pose is needed, so that wrong
/// associations of the back-end have no influence. Three views are compared with the three before,
/// since a single image may be blurred, and a detector misses a landmark now and then. With ids a
/// few landmarks suffice; those at the edge of the sensor's view do not count then, since they come
/// and go as the robot turns.
///
/// A view that changes little by little where odometry says that the robot stands contradicts that
/// odometry: the wheels spin in the air, their driver hangs, or the robot is being carried.
///
/// The class learns how often a landmark is still seen, and how often it was seen before. From the
/// views of a robot that stands, it learns only after ten further ones in which the robot counts as
/// right, since odometry may just have stopped.
class ViewChange {
 public:
  /// To be called with each motion before the observations at its end.
  void move(const Motion& motion);
  /// The log-likelihood ratio of "lost" to "right" of these observations, 0 or above: both lost and
  /// new landmarks have to be evidence for it.
  /// @param array with covariances @param is_right whether the robot counts as being at its
  /// estimated pose, so that its view is learnt from @param ids the same for each array
  double judge(const LandmarkObservationArray& array, bool is_right, LocalLandmarks::Ids ids);
  /// Later views are compared with none before them.
  void forgetBefore();

  template <class Archive>
  void persist(Archive& archive) {
    archive(before_, after_, kept_, known_, still_, of_late_, reach_);
  }

 private:
  /// A view holds what the sensor saw at one stamp.
  struct View {
    std::vector<LocalLandmark> seen;  ///< in the robot's current frame
    Pose2 sensor;                     ///< its pose at that stamp, in the same frame

    template <class Archive>
    void persist(Archive& archive) {
      archive(seen, sensor);
    }
  };
  using Views = std::vector<View>;
  /// Counts how often something was so and how often it was not.
  struct Rate {
    double yes, no;

    double share() const { return yes / (yes + no); }
    void learn(const Rate& more);

    template <class Archive>
    void persist(Archive& archive) {
      archive(yes, no);
    }
  };

  /// The sensor has seen landmarks at these bearings, and up to this range.
  struct Reach {
    double least = INFINITY, most = -INFINITY;  ///< bearing [rad]
    double far = 0.0;                           ///< most sightings are nearer [m]

    void add(const LandmarkObservation& z);
    /// Whether a place in the sensor's frame is not at the edge of its view.
    bool covers(const Eigen::Vector2d& place) const;

    template <class Archive>
    void persist(Archive& archive) {
      archive(least, most, far);
    }
  };

  /// Those of landmarks that are told apart by their ids, or by their places.
  struct Odds {
    double by_chance;  ///< probability that a lost robot sees one that was there before
    double most_sure;  ///< bound of the learnt rates, since errors of a view are not independent
  };

  static double ratioOf(const Rate& seen, const Rate& usual, const Odds& odds);
  void add(const LandmarkObservationArray& array, LocalLandmarks::Ids ids);
  double judgeBlocks(bool is_right, const Odds& odds);
  double judgeDrift(bool is_right, const Odds& odds);
  void learnStill(bool is_right);
  bool areNear() const;
  bool areAtOnePlace() const;
  bool isInView(const LocalLandmark& landmark, const Views& block) const;
  static Rate sharedBy(const View& view, const View& other);
  Rate seenAlso(const Views& block, std::size_t reference, const Views& other) const;

  Views before_, after_;  ///< two blocks of successive views, the newest last
  /// Counts of landmarks that later views show as well, and of landmarks that earlier views show as
  /// well. The counts begin with a guess.
  Rate kept_{7.0, 3.0}, known_{7.0, 3.0};
  Rate still_{7.0, 3.0};      ///< landmarks that a later view from the same place shows as well
  std::deque<Rate> of_late_;  ///< the newest such counts, which still_ does not hold yet
  Reach reach_;
};

}  // namespace slam::relocalisation
