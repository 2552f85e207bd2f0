// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/distrusted_ids.hpp"

#include <gtest/gtest.h>

namespace slam::association {
namespace {

using Kind = Decision::Kind;

int countsUntilDistrusted(DistrustedIds& ids, LandmarkId id, bool was_confirmed) {
  for (int count = 1; count < 100; ++count)
    if (ids.count(id, was_confirmed)) return count;
  return 100;
}

TEST(DistrustedIds, AMoveOfAConfirmedLandmarkCostsMoreThanAWrongFirstPlace) {
  DistrustedIds ids;
  const int moves = countsUntilDistrusted(ids, 1, true);
  EXPECT_GT(moves, 2) << "a marker may be moved now and then";
  EXPECT_LT(moves, countsUntilDistrusted(ids, 2, false));
}

TEST(DistrustedIds, OnlyObservationsOfADistrustedIdBecomeClutter) {
  DistrustedIds ids;
  ids.count(1, true);
  countsUntilDistrusted(ids, 2, true);
  EXPECT_FALSE(ids.has(1));
  EXPECT_TRUE(ids.has(2));
  LandmarkObservationArray array;
  for (const LandmarkId id : {1, 2, 3}) {
    array.observations.emplace_back();
    array.observations.back().id = id;
  }
  std::vector<Decision> decisions(3, Decision{Kind::kLandmark, 7});
  ids.refuse(array, decisions);
  EXPECT_EQ(decisions[0].kind, Kind::kLandmark);
  EXPECT_EQ(decisions[1].kind, Kind::kDistrusted);
  EXPECT_EQ(decisions[2].kind, Kind::kLandmark);
  EXPECT_EQ(decisions[2].landmark, 7u);
}

TEST(DistrustedIds, AreNamedWithWhatMayBeTheMatter) {
  const auto told = DistrustedIds::warningOf(12);
  EXPECT_EQ(told.level, Status::Level::kWarning);
  EXPECT_NE(told.message.find("landmark 12"), std::string::npos);
  EXPECT_NE(told.message.find("several markers have this id"), std::string::npos);
}

}  // namespace
}  // namespace slam::association
