// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <memory>

#include "beacon_backend.hpp"
#include "slam_core/common/config_error.hpp"
#include "slam_core/common/random.hpp"
#include "slam_core/product/test/backend_contract.hpp"

namespace slam_toy {
namespace {

using slam::test::DrivenBackend;
using slam::test::Variant;

constexpr double kSigma = 0.05;  // of the ranges [m]
const char* const kBeacons = "beacon_toy.beacons=[1, -5, -2, 2, 6, 0, 3, 1, 9]";

/// A robot on a circle that hears three beacons, with exactly the noise that is claimed.
class BeaconDrive final : public slam::test::SimulatedDrive {
 public:
  explicit BeaconDrive(std::uint64_t seed) : world_(seed), random_(seed, 1) {
    slam::Settings settings({}, {}, {kBeacons});
    beacons_ = settings.read<BeaconConfig>().positions();
  }

  slam::Pose2 give(slam::test::ComponentDriver& inputs) override {
    const auto step = world_.next();
    BeaconRanges heard{step.motion.sequence, step.motion.end, {}, {}, kSigma};
    for (const auto& [id, position] : beacons_) {
      heard.ids.push_back(id);
      heard.ranges.push_back((position - step.truth.position()).norm() +
                             kSigma * random_.gaussian());
    }
    inputs.set(step.motion);
    inputs.set(heard);
    return step.truth;
  }
  int stepsOfALap() const override { return 126; }

 private:
  slam::test::SimulatedWorld world_;
  slam::RandomStream random_;
  std::map<std::uint32_t, Eigen::Vector2d> beacons_;
};

Variant variant() {
  const auto drive = [](std::uint64_t seed) { return std::make_unique<BeaconDrive>(seed); };
  return {"beacon_toy", "beacon_toy", {kBeacons}, {}, drive};
}

TEST(BeaconToy, IsAsWrongAsItSays) {
  constexpr int kSeeds = 50;
  double nees = 0.0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    DrivenBackend backend(variant());
    const auto drive = backend.drive(1000 + seed);
    slam::Pose2 truth;
    for (int i = 0; i < 40; ++i) truth = backend.step(*drive);
    const auto estimate = backend->pose();
    nees += slam::test::nees(truth, estimate.pose, estimate.covariance) / kSeeds;
  }
  // 0.0005 and 0.9995 quantiles of chi-square with 150 degrees of freedom, over 50
  EXPECT_GT(nees, 1.99);
  EXPECT_LT(nees, 4.27);
}

TEST(BeaconToy, LeavesOutARangeThatCannotBeAndABeaconThatItDoesNotKnow) {
  DrivenBackend backend(variant());
  backend.run(1, 20);
  const auto before = backend->pose().pose;
  backend.inputs().set(BeaconRanges{0, {}, {1, 99}, {70.0, 1.0}, kSigma});
  backend.execute();
  EXPECT_EQ(backend->pose().pose.vector(), before.vector());
  EXPECT_EQ(backend->counters()["gated"], 1U);
  EXPECT_EQ(backend->counters()["unknown"], 1U);
}

TEST(BeaconToy, OffersNothingBeyondItsPose) {
  DrivenBackend backend(variant());
  EXPECT_EQ(backend.find<slam::LandmarkMapper>(), nullptr);
  EXPECT_EQ(backend.find<slam::MapKeeper>(), nullptr);
}

TEST(BeaconToy, RefusesAListThatIsNoneOfBeacons) {
  for (const auto* list : {"[]", "[1, 2]", "[1, 0, 0, 1, 2, 2]", "[1.5, 0, 0]", "[-1, 0, 0]"}) {
    slam::Settings settings({}, {}, {std::string("beacon_toy.beacons=") + list});
    EXPECT_THROW(BeaconBackend().configure(settings), slam::ConfigError) << list;
  }
}

TEST(BeaconRangesFault, IsASentenceForWhatCannotBeUsed) {
  EXPECT_EQ(faultOf({0, {}, {1, 2}, {3.0, 4.0}, kSigma}), "");
  EXPECT_EQ(faultOf({0, {}, {}, {}, kSigma}), "") << "nothing heard";
  EXPECT_NE(faultOf({0, {}, {1, 2}, {3.0}, kSigma}), "");
  EXPECT_NE(faultOf({0, {}, {1}, {std::nan("")}, kSigma}), "");
  EXPECT_NE(faultOf({0, {}, {1}, {-3.0}, kSigma}), "");
  EXPECT_NE(faultOf({0, {}, {1}, {3.0}, 0.0}), "");
}

}  // namespace
}  // namespace slam_toy

namespace slam::test {

INSTANTIATE_BACKEND_CONTRACTS(Beacon, (std::vector<Variant>{slam_toy::variant()}));

}  // namespace slam::test
