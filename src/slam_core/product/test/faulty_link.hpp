// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/laser/laser_sweep.hpp"
#include "slam_core/models/landmark_observation.hpp"
#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/models/odometry_sample.hpp"

namespace slam::test {

using Message =
    std::variant<Motion, LandmarkObservationArray, LaserScan, OdometrySample, LaserSweep>;

/// How likely each fault is for a message.
struct LinkFaults {
  double lost = 0.0, doubled = 0.0, delayed = 0.0, corrupted = 0.0, stamp_jumps = 0.0;

  /// A link has each fault with a probability of a half, and then often or seldom.
  static LinkFaults random(RandomStream& stream) {
    const auto draw = [&stream](double most) {
      return stream.uniform() < 0.5 ? 0.0 : most * stream.uniform();
    };
    return {draw(0.3), draw(0.3), draw(0.5), draw(0.2), draw(0.02)};
  }
  /// Whether each message that arrives is one that a sensor has sent.
  bool areOfArrivalOnly() const { return corrupted == 0.0 && stamp_jumps == 0.0; }
};

/// Between sensors and a product, what can happen to messages: they are lost, doubled, come late
/// and in another order, have stamps that are 100 s off, and values that no sensor has measured.
/// Given the same seed it does the same.
class FaultyLink {
 public:
  FaultyLink(std::uint64_t seed, const LinkFaults& faults) : random_(seed, 1), faults_(faults) {}

  /// @return what arrives meanwhile, in its order
  std::vector<Message> pass(Message message) {
    ++time_;
    if (isChosen(faults_.corrupted)) std::visit([this](auto& m) { corrupt(m); }, message);
    if (isChosen(faults_.stamp_jumps)) std::visit([this](auto& m) { jump(m); }, message);
    if (!isChosen(faults_.lost)) send(message);
    if (isChosen(faults_.doubled)) send(std::move(message));
    return arrived();
  }

 private:
  struct UnderWay {
    double arrival;  ///< in messages since the beginning
    Message message;
  };

  bool isChosen(double probability) { return random_.uniform() < probability; }

  void send(Message message) {
    constexpr double kLongest = 20.0;
    const double delay = isChosen(faults_.delayed) ? kLongest * random_.uniform() : 0.0;
    under_way_.push_back({time_ + delay, std::move(message)});
  }

  std::vector<Message> arrived() {
    std::stable_sort(under_way_.begin(), under_way_.end(),
                     [](const auto& a, const auto& b) { return a.arrival < b.arrival; });
    std::vector<Message> messages;
    auto next = under_way_.begin();
    for (; next != under_way_.end() && next->arrival <= time_; ++next)
      messages.push_back(std::move(next->message));
    under_way_.erase(under_way_.begin(), next);
    return messages;
  }

  /// A value that a driver, a cable or a broken sensor can make.
  double nonsense() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> values = {kNaN, kInfinity, -kInfinity, 0.0,   -1.0,
                                        1e9,  1e300,     -1e12,      1e-300};
    return values[random_.bits() % values.size()];
  }
  template <class Matrix>
  void corruptOne(Matrix& matrix) {
    matrix(static_cast<Eigen::Index>(random_.bits() % matrix.rows()),
           static_cast<Eigen::Index>(random_.bits() % matrix.cols())) = nonsense();
  }
  void corruptOne(Pose2& pose) {
    auto vector = pose.vector();
    corruptOne(vector);
    pose = Pose2(vector.x(), vector.y(), vector.z());
  }

  void corrupt(Motion& motion) {
    switch (random_.bits() % 4) {
      case 0:
        return corruptOne(motion.increment);
      case 1:
        return corruptOne(motion.covariance);
      case 2:
        return corruptOne(motion.odometry_end);
      default:
        std::swap(motion.start, motion.end);
    }
  }
  void corrupt(LandmarkObservationArray& array) {
    if (array.observations.empty()) return corruptOne(array.sensor_pose);
    auto& z = array.observations[random_.bits() % array.observations.size()];
    switch (random_.bits() % 6) {
      case 0:
        z.range = nonsense();
        break;
      case 1:
        z.bearing = nonsense();
        break;
      case 2:
        corruptOne(z.covariance);
        break;
      case 3:
        z.id = static_cast<LandmarkId>(random_.bits());
        break;
      case 4:
        array.sequence = random_.bits();
        break;
      default:
        array.observations.resize(1 + random_.bits() % 600, z);
    }
  }
  void corrupt(LaserScan& scan) {
    if (scan.beams.empty()) return corruptOne(scan.sensor_pose);
    for (auto& beam : scan.beams)
      if (isChosen(0.2)) beam.range = static_cast<float>(20.0 * random_.uniform());
    if (isChosen(0.3)) scan.beams.clear();
  }

  void corrupt(OdometrySample& sample) {
    switch (random_.bits() % 4) {
      case 0:
        return corruptOne(sample.twist);
      case 1:
        return corruptOne(sample.twist_covariance);
      case 2:
        return sample.pose.reset();
      default:
        if (sample.pose) corruptOne(*sample.pose);
    }
  }
  void corrupt(LaserSweep& sweep) {
    switch (random_.bits() % 5) {
      case 0:
        sweep.angle_increment = static_cast<float>(nonsense());
        break;
      case 1:
        sweep.range_max = static_cast<float>(nonsense());
        break;
      case 2:
        sweep.ranges.resize(random_.bits() % 400, 1.0f);
        break;
      case 3:
        sweep.frame = isChosen(0.5) ? "" : "another";
        break;
      default:
        for (auto& range : sweep.ranges)
          if (isChosen(0.2)) range = static_cast<float>(nonsense());
    }
  }

  Duration jump() { return std::chrono::seconds(isChosen(0.5) ? 100 : -100); }
  void jump(Motion& motion) {
    const auto by = jump();
    motion.start += by;
    motion.end += by;
  }
  void jump(LandmarkObservationArray& array) { array.stamp += jump(); }
  void jump(LaserScan& scan) { scan.stamp += jump(); }
  void jump(OdometrySample& sample) { sample.stamp += jump(); }
  void jump(LaserSweep& sweep) { sweep.stamp += jump(); }

  RandomStream random_;
  LinkFaults faults_;
  double time_ = 0.0;
  std::vector<UnderWay> under_way_;
};

}  // namespace slam::test
