// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/vocabulary.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/random.hpp"
#include "slam_core/mono_graph/place_index.hpp"

namespace slam::mono_graph {
namespace {

Descriptor randomDescriptor(RandomStream& random) {
  Descriptor descriptor;
  for (auto& word : descriptor) word = std::uint64_t{random.bits()} << 32 | random.bits();
  return descriptor;
}

/// Images of some places, whose features are those of the place with some bits changed.
std::vector<std::vector<Descriptor>> images(int places, int of_each) {
  std::vector<std::vector<Descriptor>> images;
  for (int place = 0; place < places; ++place)
    for (int i = 0; i < of_each; ++i) {
      RandomStream of_place(7, static_cast<std::uint64_t>(place));
      RandomStream noise(8, static_cast<std::uint64_t>(place), static_cast<std::uint32_t>(i));
      images.emplace_back();
      for (int k = 0; k < 60; ++k) {
        auto descriptor = randomDescriptor(of_place);
        for (int b = 0; b < 12; ++b)
          descriptor[noise.bits() % 4] ^= std::uint64_t{1} << (noise.bits() % 64);
        images.back().push_back(descriptor);
      }
    }
  return images;
}

std::vector<Feature> featuresOf(const std::vector<Descriptor>& descriptors) {
  std::vector<Feature> features(descriptors.size());
  for (std::size_t i = 0; i < features.size(); ++i) features[i].descriptor = descriptors[i];
  return features;
}

TEST(Vocabulary, FindsTheImagesOfTheSamePlace) {
  const auto all = images(10, 4);
  const auto vocabulary = Vocabulary::trained(all, 6, 3, 1);
  EXPECT_GT(vocabulary.countOfWords(), 100U);
  PlaceIndex index;
  for (std::size_t i = 0; i < all.size(); ++i)  // 10 apart, so that they are no neighbours in time
    for (int k = 0; k < 10; ++k)
      index.add(k == 0 ? vocabulary.wordsOf(featuresOf(all[i])) : BagOfWords());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto found = index.find(index[static_cast<int>(10 * i)], {static_cast<int>(10 * i)}, 3);
    ASSERT_EQ(found.size(), 3U);
    for (const auto& candidate : found)
      EXPECT_EQ(static_cast<std::size_t>(candidate.keyframe) / 40, i / 4);
  }
}

TEST(Vocabulary, IsTheSameForTheSameImagesAndSeed) {
  const auto all = images(5, 2);
  EXPECT_EQ(Vocabulary::trained(all, 5, 3, 1).bytes(), Vocabulary::trained(all, 5, 3, 1).bytes());
  EXPECT_NE(Vocabulary::trained(all, 5, 3, 1).bytes(), Vocabulary::trained(all, 5, 3, 2).bytes());
}

TEST(Vocabulary, IsReadAsItWasWritten) {
  const auto vocabulary = Vocabulary::trained(images(5, 2), 5, 3, 1);
  const auto read = Vocabulary::parse(vocabulary.bytes());
  EXPECT_EQ(read.bytes(), vocabulary.bytes());
  for (std::size_t cut : {0, 7, 100, 3000})
    EXPECT_THROW(Vocabulary::parse(vocabulary.bytes().substr(0, cut)), std::runtime_error);
  auto damaged = vocabulary.bytes();
  damaged[200] = static_cast<char>(damaged[200] ^ 1);
  EXPECT_THROW(Vocabulary::parse(damaged), std::runtime_error);
}

TEST(Vocabulary, ComesWithTheProgram) {
  EXPECT_GE(Vocabulary::builtIn().countOfWords(), 5000U);
  EXPECT_LT(Vocabulary::builtIn().bytes().size(), 2000000U);
}

TEST(PlaceIndex, FindsWhatIsAlikeAndNothingElse) {
  const BagOfWords a{{1, 4, 7}, {0.5, 0.25, 0.25}}, b{{4, 9}, {0.5, 0.5}}, none;
  PlaceIndex index;
  index.add(a);
  const auto similarityOf = [&](const BagOfWords& bag) {
    const auto found = index.find(bag, {}, 1);
    return found.empty() ? 0.0 : found.front().similarity;
  };
  EXPECT_DOUBLE_EQ(similarityOf(a), 1.0);
  EXPECT_DOUBLE_EQ(similarityOf(b), 0.25);
  EXPECT_DOUBLE_EQ(similarityOf(none), 0.0);
}

}  // namespace
}  // namespace slam::mono_graph
