// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "slam_core/common/random.hpp"
#include "slam_core/common/sorted_unique.hpp"
#include "slam_core/mono_graph/vocabulary.hpp"

namespace slam::mono_graph {
namespace {

constexpr int kRounds = 10;  // of k-majority
constexpr std::size_t kBits = 256;

using Members = std::vector<const Descriptor*>;

/// The bits that most of some descriptors have.
Descriptor majorityOf(const Members& members) {
  std::array<std::size_t, kBits> ones{};
  for (const auto* member : members)
    for (std::size_t bit = 0; bit < kBits; ++bit)
      ones[bit] += (*member)[bit / 64] >> (bit % 64) & 1;
  Descriptor majority{};
  for (std::size_t bit = 0; bit < kBits; ++bit)
    if (2 * ones[bit] > members.size()) majority[bit / 64] |= std::uint64_t{1} << (bit % 64);
  return majority;
}

std::size_t nearestOf(const std::vector<Descriptor>& centres, const Descriptor& descriptor) {
  const auto nearest = std::min_element(
      centres.begin(), centres.end(), [&](const Descriptor& a, const Descriptor& b) {
        return distanceOf(a, descriptor) < distanceOf(b, descriptor);
      });
  return static_cast<std::size_t>(nearest - centres.begin());
}

std::vector<Members> divided(const Members& members, const std::vector<Descriptor>& centres) {
  std::vector<Members> clusters(centres.size());
  for (const auto* member : members) clusters[nearestOf(centres, *member)].push_back(member);
  return clusters;
}

/// Centres to begin with, far from one another with probability (k-means++: Arthur and
/// Vassilvitskii 2007).
std::vector<Descriptor> drawn(const Members& members, std::size_t count, RandomStream& random) {
  const auto index = [&](double share) {
    return std::min(members.size() - 1,
                    static_cast<std::size_t>(share * static_cast<double>(members.size())));
  };
  std::vector<Descriptor> centres = {*members[index(random.uniform())]};
  std::vector<double> squares(members.size());
  while (centres.size() < count) {
    for (std::size_t i = 0; i < members.size(); ++i) {
      const int distance = distanceOf(centres.back(), *members[i]);
      const double square = static_cast<double>(distance) * distance;
      squares[i] = centres.size() == 1 ? square : std::min(squares[i], square);
    }
    double left = random.uniform() * std::accumulate(squares.begin(), squares.end(), 0.0);
    if (!(left > 0.0)) break;  // all are centres already
    std::size_t chosen = 0;
    while (chosen + 1 < members.size() && (left -= squares[chosen]) > 0.0) ++chosen;
    centres.push_back(*members[chosen]);
  }
  return centres;
}

}  // namespace

/// Grows a tree level by level, so that children stand behind their parents.
class VocabularyTrainer {
 public:
  VocabularyTrainer(int branching, int depth, std::uint64_t seed)
      : branching_(static_cast<std::size_t>(branching)), depth_(depth), seed_(seed) {}

  Vocabulary train(const std::vector<std::vector<Descriptor>>& images) {
    Members all;
    for (const auto& image : images)
      for (const auto& descriptor : image) all.push_back(&descriptor);
    vocabulary_.nodes_.emplace_back();
    std::vector<std::pair<std::size_t, Members>> level = {{0, std::move(all)}};
    for (int i = 0; i < depth_; ++i) {
      std::vector<std::pair<std::size_t, Members>> next;
      for (const auto& [node, members] : level) grow(node, members, next);
      level = std::move(next);
    }
    for (auto& node : vocabulary_.nodes_)
      if (node.children == 0) node.word = vocabulary_.words_++;
    weigh(images);
    return std::move(vocabulary_);
  }

 private:
  void grow(std::size_t node, const Members& members,
            std::vector<std::pair<std::size_t, Members>>& next) {
    if (members.size() <= branching_) return;
    RandomStream random(seed_, node);
    auto centres = drawn(members, branching_, random);
    auto clusters = divided(members, centres);
    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t i = 0; i < centres.size(); ++i)
        if (!clusters[i].empty()) centres[i] = majorityOf(clusters[i]);
      clusters = divided(members, centres);
    }
    auto& nodes = vocabulary_.nodes_;
    nodes[node].first_child = static_cast<std::uint32_t>(nodes.size());
    for (std::size_t i = 0; i < centres.size(); ++i) {
      if (clusters[i].empty()) continue;
      ++nodes[node].children;
      next.emplace_back(nodes.size(), std::move(clusters[i]));
      nodes.emplace_back();
      nodes.back().centre = centres[i];
    }
  }

  /// The logarithm of how many times more images there are than those that show the word.
  void weigh(const std::vector<std::vector<Descriptor>>& images) {
    std::vector<int> shown(vocabulary_.words_, 0);
    for (const auto& image : images) {
      std::vector<std::uint32_t> words;
      for (const auto& descriptor : image) words.push_back(vocabulary_.wordOf(descriptor));
      for (const auto word : sortedUnique(std::move(words))) ++shown[word];
    }
    for (auto& node : vocabulary_.nodes_)
      if (node.children == 0)
        node.weight = std::log(static_cast<double>(images.size()) / std::max(1, shown[node.word]));
  }

  std::size_t branching_;
  int depth_;
  std::uint64_t seed_;
  Vocabulary vocabulary_;
};

Vocabulary Vocabulary::trained(const std::vector<std::vector<Descriptor>>& images, int branching,
                               int depth, std::uint64_t seed) {
  return VocabularyTrainer(branching, depth, seed).train(images);
}

}  // namespace slam::mono_graph
