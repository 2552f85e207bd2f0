// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"

namespace slam::particle_filter {
namespace {

constexpr int kStepsOfPart = 300;  // before the robot is lifted, and after
constexpr double kSigmaRange = 0.02, kSigmaBearing = 0.01;

/// A robot on a circle of 4 m radius among 200 landmarks in 16 m x 16 m, of which it sees some. It
/// may be lifted and put elsewhere.
class Hall {
 public:
  /// @param ids of all that can be seen; empty: any
  Hall(std::vector<LandmarkId> ids, std::size_t most) : ids_(std::move(ids)), most_(most) {
    for (LandmarkId id = 0; id < 200; ++id)
      landmarks_[id] = {16.0 * random_.uniform() - 8.0, 16.0 * random_.uniform() - 8.0};
  }

  void lift() { truth_ = Pose2(truth_.x() + 3.0, truth_.y() + 2.0, truth_.theta() + 1.5); }
  void moveLandmark(LandmarkId id) { landmarks_[id] += Eigen::Vector2d(1.0, -0.5); }
  const Pose2& truth() const { return truth_; }

  void drive(FastSlam& filter) {
    Motion motion;
    motion.increment = Pose2::exp({0.03, 0.0, 0.0075});
    motion.covariance = Eigen::Vector3d(4e-7, 1e-8, 1e-6).asDiagonal();
    const Eigen::Vector3d noise(6e-4 * random_.gaussian(), 0.0, 1e-3 * random_.gaussian());
    truth_ = truth_ * Pose2::fromVector(motion.increment.vector() + noise);
    motion.end = LandmarkObservationArray().stamp + ++count_ * std::chrono::milliseconds(100);
    give(motion, filter);
    auto observations = look();
    observations.stamp = motion.end;
    give(observations, filter);
  }

  /// The mean error of the landmarks in the map [m].
  double errorOf(const LandmarkMap& map) const {
    double sum = 0.0;
    for (const auto& landmark : map)
      sum += (landmark.position - landmarks_.at(landmark.id)).norm() / double(map.size());
    return sum;
  }

 private:
  LandmarkObservationArray look() {
    LandmarkObservationArray array;
    for (const auto& [id, place] : landmarks_) {
      if (!ids_.empty() && std::count(ids_.begin(), ids_.end(), id) == 0) continue;
      const Eigen::Vector2d d = truth_.inverse().transform(place);
      LandmarkObservation z;
      z.id = id;
      z.range = std::max(0.05, d.norm() + kSigmaRange * random_.gaussian());
      z.bearing = std::atan2(d.y(), d.x()) + kSigmaBearing * random_.gaussian();
      z.covariance =
          Eigen::Vector2d(kSigmaRange * kSigmaRange, kSigmaBearing * kSigmaBearing).asDiagonal();
      array.observations.push_back(z);
    }
    auto& all = array.observations;
    const auto nearer = [](const auto& a, const auto& b) { return a.range < b.range; };
    std::sort(all.begin(), all.end(), nearer);
    if (all.size() > most_) all.resize(most_);
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    return array;
  }

  std::vector<LandmarkId> ids_;
  std::size_t most_;
  std::map<LandmarkId, Eigen::Vector2d> landmarks_;
  RandomStream random_{5, 0};
  Pose2 truth_;
  int count_ = 0;
};

struct View {
  std::string name;
  std::vector<LandmarkId> ids;
  std::size_t most;
};

class KidnappedRobot : public testing::TestWithParam<View> {
 protected:
  void SetUp() override { filter.configure(PfConfig()); }
  /// @return how many steps were told as lost
  int drive(int steps) {
    int lost = 0;
    for (int i = 0; i < steps; ++i) {
      hall.drive(filter);
      const auto status = filter.execute();
      lost += status.is_alarm && test::oneSays({status.message}, {"may be lost", "initial pose"});
    }
    return lost;
  }

  Hall hall{GetParam().ids, GetParam().most};
  FastSlam filter;
};

TEST_P(KidnappedRobot, IsToldAndItsMapIsNotHarmed) {
  EXPECT_EQ(drive(kStepsOfPart), 0);
  EXPECT_EQ(filter.counters()["doubtful"], 0u);
  const double error = hall.errorOf(as<LandmarkMapper>(filter).landmarks());
  const auto landmarks = as<LandmarkMapper>(filter).landmarks().size();
  EXPECT_LT(error, 0.1);
  hall.lift();
  EXPECT_GT(drive(100), 90);
  EXPECT_GT(filter.counters()["doubtful"], 90u);
  EXPECT_EQ(as<LandmarkMapper>(filter).landmarks().size(), landmarks)
      << "nothing is put where it may not be";
  EXPECT_LT(hall.errorOf(as<LandmarkMapper>(filter).landmarks()), error + 0.05)
      << "only the best particle may change";
}

TEST_P(KidnappedRobot, GoesOnFromANewPose) {
  drive(kStepsOfPart);
  hall.lift();
  drive(50);
  filter.set(PoseEstimate{hall.truth(), 1e-3 * Eigen::Matrix3d::Identity()});
  filter.execute();
  EXPECT_EQ(drive(kStepsOfPart), 0);
  EXPECT_LT((filter.pose().pose.position() - hall.truth().position()).norm(), 0.3);
  EXPECT_LT(hall.errorOf(as<LandmarkMapper>(filter).landmarks()), 0.2);
}

/// As one who clicks into a map would tell it: not exactly, and with an honest covariance.
TEST_P(KidnappedRobot, IsFoundAboutAPlaceThatIsToldRoughly) {
  if (GetParam().most < 2) GTEST_SKIP() << "one landmark does not tell a pose";
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    hall = Hall(GetParam().ids, GetParam().most);
    filter.seed(seed);
    filter.configure(PfConfig());
    drive(kStepsOfPart);
    const Pose2 truth = hall.truth();
    const Pose2 told(truth.x() + 0.3, truth.y() - 0.3, truth.theta() + 0.2);
    filter.set(PoseEstimate{told, Eigen::Vector3d(0.25, 0.25, 0.068).asDiagonal()});
    filter.execute();
    EXPECT_EQ(drive(50), 0);
    EXPECT_LT((filter.pose().pose.position() - hall.truth().position()).norm(), 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Sees, KidnappedRobot,
                         testing::Values(View{"OneLandmark", {3}, 1},
                                         View{"TwoLandmarks", {3, 7}, 2},
                                         View{"FourLandmarks", {3, 7, 11, 19}, 4},
                                         View{"KnownAndNewOnes", {}, 15}),
                         [](const auto& view) { return view.param.name; });

TEST(MovedLandmark, IsBegunAnewWhereOthersStandForThePose) {
  FastSlam filter;
  filter.configure(PfConfig());
  Hall hall({3, 7, 11}, 3);
  std::vector<std::string> warnings;
  const auto drive = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      hall.drive(filter);
      const auto status = filter.execute();
      if (!status.isOk()) warnings.push_back(status.message);
    }
  };
  drive(100);
  EXPECT_TRUE(warnings.empty());
  hall.moveLandmark(7);
  drive(30);
  EXPECT_TRUE(test::oneSays(warnings, {"landmark 7", "it was moved"}));
  EXPECT_EQ(warnings.size(), 1u);
  EXPECT_LT(hall.errorOf(as<LandmarkMapper>(filter).landmarks()), 0.2);
  EXPECT_EQ(filter.counters()["doubtful"], 0u);
}

TEST(MovedLandmark, IsNotBelievedAlone) {
  FastSlam filter;
  filter.configure(PfConfig());
  Hall hall({7}, 1);
  for (int i = 0; i < 100; ++i) {
    hall.drive(filter);
    filter.execute();
  }
  const Eigen::Vector2d before = as<LandmarkMapper>(filter).landmarks().front().position;
  hall.moveLandmark(7);
  for (int i = 0; i < 30; ++i) {
    hall.drive(filter);
    filter.execute();
  }
  EXPECT_LT((as<LandmarkMapper>(filter).landmarks().front().position - before).norm(), 0.05);
}

}  // namespace
}  // namespace slam::particle_filter
