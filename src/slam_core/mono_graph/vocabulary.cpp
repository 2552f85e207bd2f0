// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/vocabulary.hpp"

#include <cmath>
#include <map>
#include <stdexcept>

#include "slam_core/common/archive.hpp"
#include "slam_core/common/input_file.hpp"
#include "slam_core/common/sealed_bytes.hpp"

namespace slam::mono_graph {

/// The content of orb.vocabulary, which the build writes into a source file.
extern const unsigned char kBuiltInVocabulary[];
extern const std::size_t kBuiltInVocabularySize;

namespace {

constexpr SealedFormat kFormat = {"SLAMvocb", 1, "it is no vocabulary of visual words",
                                  "copy it again, or leave mono_graph.vocabulary out"};

}  // namespace

const Vocabulary& Vocabulary::builtIn() {
  static const Vocabulary vocabulary =
      parse(std::string(reinterpret_cast<const char*>(kBuiltInVocabulary), kBuiltInVocabularySize));
  return vocabulary;
}

Vocabulary Vocabulary::load(const std::string& path) {
  const auto bytes = readInputFile(path, "the vocabulary");
  try {
    return parse(bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("cannot use the vocabulary " + path + ": " + error.what());
  }
}

Vocabulary Vocabulary::parse(const std::string& bytes) {
  const auto content = contentOf(kFormat, bytes);
  ArchiveReader reader(content.data(), content.size());
  Vocabulary vocabulary;
  reader(vocabulary);
  if (!vocabulary.fault().empty()) throw std::runtime_error(vocabulary.fault());
  return vocabulary;
}

std::string Vocabulary::bytes() const {
  ArchiveWriter writer;
  writer(*this);
  return sealed(kFormat, writer.take());
}

/// A child stands behind its parent, so that each descent ends.
std::string Vocabulary::fault() const {
  if (nodes_.empty()) return "it holds no words: copy it again";
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto& node = nodes_[i];
    const bool has_children = node.children > 0;
    const bool is_tree = !has_children || (node.first_child > i && node.children <= nodes_.size() &&
                                           node.first_child <= nodes_.size() - node.children);
    if (!is_tree || !(node.weight >= 0.0) || (!has_children && node.word >= words_))
      return "its words are no tree: copy it again";
  }
  return "";
}

const Vocabulary::Node& Vocabulary::leafOf(const Descriptor& descriptor) const {
  const Node* node = &nodes_.front();
  while (node->children > 0) {
    const Node* best = &nodes_[node->first_child];
    int least = distanceOf(best->centre, descriptor);
    for (std::uint32_t i = 1; i < node->children; ++i) {
      const Node& child = nodes_[node->first_child + i];
      const int distance = distanceOf(child.centre, descriptor);
      if (distance < least) {
        least = distance;
        best = &child;
      }
    }
    node = best;
  }
  return *node;
}

std::uint32_t Vocabulary::wordOf(const Descriptor& descriptor) const {
  return leafOf(descriptor).word;
}

BagOfWords Vocabulary::wordsOf(const std::vector<Feature>& features) const {
  std::map<std::uint32_t, double> weights;
  double sum = 0.0;
  for (const auto& feature : features) {
    const auto& leaf = leafOf(feature.descriptor);
    if (!(leaf.weight > 0.0)) continue;
    weights[leaf.word] += leaf.weight;
    sum += leaf.weight;
  }
  BagOfWords bag;
  for (const auto& [word, weight] : weights) {
    bag.words.push_back(word);
    bag.weights.push_back(weight / sum);
  }
  return bag;
}

}  // namespace slam::mono_graph
