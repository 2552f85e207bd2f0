// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "slam_core/mono_graph/descriptor.hpp"
#include "slam_core/mono_graph/features.hpp"

namespace slam::mono_graph {

/// The words that an image shows, each with its weight; rising words, weights that sum to 1. Empty
/// where it shows none.
struct BagOfWords {
  std::vector<std::uint32_t> words;
  std::vector<double> weights;

  template <class Archive>
  void persist(Archive& archive) {
    archive(words, weights);
  }
};

/// A tree of descriptors whose leaves are visual words (Nister and Stewenius 2006; binary ones:
/// Galvez-Lopez and Tardos 2012). A word weighs the more, the fewer images showed it in training.
class Vocabulary {
 public:
  /// The one that is part of the library; docs/mono_graph.md has the command that made it.
  static const Vocabulary& builtIn();
  /// @throw std::runtime_error with one sentence where the file cannot be read, is cut or damaged
  static Vocabulary load(const std::string& path);
  /// The content of a file. @throw std::runtime_error with what is wrong, to stand behind its name
  static Vocabulary parse(const std::string& bytes);
  /// Grows a tree by k-majority (Grana et al. 2013).
  /// @param images the descriptors of each
  static Vocabulary trained(const std::vector<std::vector<Descriptor>>& images, int branching,
                            int depth, std::uint64_t seed);

  std::string bytes() const;
  std::size_t countOfWords() const { return words_; }
  std::uint32_t wordOf(const Descriptor& descriptor) const;
  BagOfWords wordsOf(const std::vector<Feature>& features) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(nodes_, words_);
  }

 private:
  friend class VocabularyTrainer;

  struct Node {
    Descriptor centre{};
    std::uint32_t first_child = 0, children = 0;  ///< children stand one behind another
    std::uint32_t word = 0;                       ///< of a leaf
    double weight = 0.0;                          ///< of the word

    template <class Archive>
    void persist(Archive& archive) {
      archive(centre, first_child, children, word, weight);
    }
  };

  const Node& leafOf(const Descriptor& descriptor) const;
  std::string fault() const;

  std::vector<Node> nodes_;  ///< the root first
  std::uint32_t words_ = 0;
};

}  // namespace slam::mono_graph
