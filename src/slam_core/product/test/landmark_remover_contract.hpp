// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <set>

#include "slam_core/contract/landmark_remover.hpp"
#include "slam_core/product/test/landmark_contract.hpp"

// A back-end that forgets landmarks on request promises what these tests check.

namespace slam::test {

class LandmarkRemoverContract : public LandmarkContract {
 protected:
  static constexpr LandmarkId kRemoved = 10;

  static std::multiset<LandmarkId> idsOf(const LandmarkMap& map) {
    std::multiset<LandmarkId> ids;
    for (const auto& landmark : map) ids.insert(landmark.id);
    return ids;
  }
};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(LandmarkRemoverContract);

TEST_P(LandmarkRemoverContract, ForgetsThatLandmarkAndNothingElse) {
  auto backend = make();
  run(backend, SimulatedWorld(5), 80);
  const auto before = mapOf(backend);
  const auto pose = backend->pose().pose;
  ASSERT_EQ(idsOf(before).count(kRemoved), 1u);
  const auto status = backend.as<LandmarkRemover>().remove(kRemoved);
  EXPECT_TRUE(status.isOk()) << status.message;
  backend.execute();
  const auto after = mapOf(backend);
  EXPECT_EQ(after.size(), before.size() - 1);
  EXPECT_EQ(statisticsOf(backend).landmarks, static_cast<int>(after.size()));
  EXPECT_EQ(idsOf(after).count(kRemoved), 0u);
  EXPECT_EQ(backend->pose().pose.vector(), pose.vector());
  for (const auto& landmark : after) {
    const auto same = std::find_if(before.begin(), before.end(),
                                   [&](const auto& other) { return other.id == landmark.id; });
    EXPECT_EQ(landmark.position, same->position) << landmark.id;
  }
}

TEST_P(LandmarkRemoverContract, TakesAnotherSightingOfItsIdForANewLandmark) {
  auto backend = make();
  SimulatedWorld world(5);
  for (int i = 0; i < 80; ++i) take(backend, world.next());
  ASSERT_TRUE(backend.as<LandmarkRemover>().remove(kRemoved).isOk());
  for (int i = 0; i < 150; ++i) take(backend, world.next());
  const auto map = mapOf(backend);
  EXPECT_EQ(map.size(), world.landmarks().size());
  EXPECT_EQ(idsOf(map).count(kRemoved), 1u);
  for (const auto& landmark : map)
    EXPECT_LT((landmark.position - world.landmarks().at(landmark.id)).norm(), 0.4) << landmark.id;
}

TEST_P(LandmarkRemoverContract, RefusesALandmarkThatIsNotInTheMap) {
  auto backend = make();
  run(backend, SimulatedWorld(5), 80);
  const auto size = mapOf(backend).size();
  auto& remover = backend.as<LandmarkRemover>();
  EXPECT_EQ(remover.remove(4711).message,
            "there is no landmark 4711 in the map: the topic `landmarks` shows the ids");
  ASSERT_TRUE(remover.remove(kRemoved).isOk());
  EXPECT_EQ(remover.remove(kRemoved).level, Status::Level::kError) << "it is gone already";
  EXPECT_EQ(mapOf(backend).size(), size - 1);
}

/// Those of the variants that this contract is for.
inline std::vector<Variant> removingLandmarks(const std::vector<Variant>& variants) {
  return mappingLandmarksAlone(offering<LandmarkRemover>(variants));
}

}  // namespace slam::test
