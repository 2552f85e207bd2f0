// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/known_ids.hpp"

#include <gtest/gtest.h>

#include <map>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/test/faults.hpp"

namespace slam::association {
namespace {

using Kind = Decision::Kind;

/// Landmark 7 is number 0, landmark 3 number 1; whoever asks for places fails.
class NamedLandmarks final : public CandidateSource {
 public:
  std::size_t size() const override { return numbers_.size(); }
  std::optional<std::size_t> find(LandmarkId id) const override {
    const auto found = numbers_.find(id);
    return found == numbers_.end() ? std::nullopt : std::make_optional(found->second);
  }
  void candidates(std::size_t, std::vector<Candidate>&) const override {
    ADD_FAILURE() << "asked for places";
  }

 private:
  std::map<LandmarkId, std::size_t> numbers_ = {{7, 0}, {3, 1}};
};

class KnownIdsTest : public testing::Test {
 protected:
  const std::vector<Decision>& decide(const std::vector<LandmarkId>& ids,
                                      bool map_is_fixed = false) {
    LandmarkObservationArray array;
    for (const auto id : ids) array.observations.emplace_back().id = id;
    policy->decide(array, landmarks, map_is_fixed, decisions);
    return decisions;
  }
  std::vector<Kind> kinds(const std::vector<LandmarkId>& ids, bool map_is_fixed = false) {
    std::vector<Kind> kinds;
    for (const auto& decision : decide(ids, map_is_fixed)) kinds.push_back(decision.kind);
    return kinds;
  }

  std::unique_ptr<AssociationPolicy> policy = makePolicy("known_ids");
  NamedLandmarks landmarks;
  std::vector<Decision> decisions;
};

TEST_F(KnownIdsTest, IsRegisteredAndAnUnknownNameIsAnsweredWithTheNamesThereAre) {
  EXPECT_FALSE(policy->usesPlaces());
  EXPECT_EQ(policyNames(),
            (std::vector<std::string>{"descriptor", "jcbb", "known_ids", "nearest"}));
  try {
    makePolicy("known_idz");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_TRUE(slam::test::oneSays({error.what()}, {"association 'known_idz'", "known_ids"}));
  }
}

TEST_F(KnownIdsTest, TakesAnObservationForTheLandmarkWithItsId) {
  EXPECT_EQ(kinds({3, 7}), (std::vector<Kind>{Kind::kLandmark, Kind::kLandmark}));
  EXPECT_EQ(decisions[0].landmark, 1u);
  EXPECT_EQ(decisions[1].landmark, 0u);
}

TEST_F(KnownIdsTest, AnIdThatIsNotInTheMapIsNewUnlessTheMapIsFixed) {
  EXPECT_EQ(kinds({4, 7}), (std::vector<Kind>{Kind::kNew, Kind::kLandmark}));
  EXPECT_EQ(kinds({4, 7}, true), (std::vector<Kind>{Kind::kNotInMap, Kind::kLandmark}));
  EXPECT_TRUE(decisions[0].isClutter());
  EXPECT_FALSE(decisions[1].isClutter());
}

TEST_F(KnownIdsTest, WithoutAnIdItIsClutterHoweverOften) {
  EXPECT_EQ(kinds({kUnknownId, kUnknownId, 3}),
            (std::vector<Kind>{Kind::kUnknown, Kind::kUnknown, Kind::kLandmark}));
  EXPECT_TRUE(decisions[0].isClutter());
}

TEST_F(KnownIdsTest, TheFirstOfAnIdCountsWhateverTheOrderOfTheArray) {
  EXPECT_EQ(kinds({3, 3, 4, 4, 4}),
            (std::vector<Kind>{Kind::kLandmark, Kind::kDuplicate, Kind::kNew, Kind::kDuplicate,
                               Kind::kDuplicate}));
  EXPECT_EQ(kinds({7, 3, 7, kUnknownId, 3}),
            (std::vector<Kind>{Kind::kLandmark, Kind::kLandmark, Kind::kDuplicate, Kind::kUnknown,
                               Kind::kDuplicate}));
  EXPECT_EQ(kinds({9, 9}, true), (std::vector<Kind>{Kind::kNotInMap, Kind::kDuplicate}));
}

TEST_F(KnownIdsTest, ReplacesTheDecisionsOfTheCallBefore) {
  decide({3, 3, 3, 7});
  EXPECT_EQ(kinds({7}), std::vector<Kind>{Kind::kLandmark});
  EXPECT_TRUE(decide({}).empty());
}

/// As an adversary may send them: it must not take the square of their number.
TEST_F(KnownIdsTest, AHundredThousandIdsInDescendingOrderAreSortedAtOnce) {
  std::vector<LandmarkId> ids;
  for (LandmarkId id = 200000; id > 100000; --id) ids.push_back(id);
  ids.push_back(200000);
  const auto& all = decide(ids);
  EXPECT_EQ(all.front().kind, Kind::kNew);
  EXPECT_EQ(all.back().kind, Kind::kDuplicate);
}

TEST_F(KnownIdsTest, KeepsItsMemoryFromCallToCall) {
  decide({3, 7, 4, 4});
  const auto* const before = decisions.data();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(decide({7, 3, 3}).data(), before);
}

TEST(Decision, OfAWrongPolicyIsWorthNoMoreThanTheMapAllows) {
  const Decision is_new{Kind::kNew, 0}, is_known{Kind::kLandmark, 5}, is_clutter{Kind::kUnknown, 0};
  EXPECT_EQ(is_new.checked(false, false), Kind::kNew);
  EXPECT_EQ(is_new.checked(true, false), Kind::kNotInMap);
  EXPECT_EQ(is_known.checked(true, true), Kind::kLandmark);
  EXPECT_EQ(is_known.checked(false, false), Kind::kUnknown) << "it was not offered";
  EXPECT_EQ(is_clutter.checked(false, false), Kind::kUnknown);
}

}  // namespace
}  // namespace slam::association
