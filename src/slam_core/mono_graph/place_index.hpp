// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "slam_core/mono_graph/vocabulary.hpp"

namespace slam::mono_graph {

/// A keyframe that looks like an image.
struct PlaceCandidate {
  int keyframe = 0;
  double similarity = 0.0;  ///< 0 to 1 (Galvez-Lopez and Tardos 2012, Eq. 2)
};

/// Which keyframes show which words (an inverted file: Sivic and Zisserman 2003).
class PlaceIndex {
 public:
  /// Keyframes are added in their order, from 0.
  void add(BagOfWords bag);
  const BagOfWords& operator[](int keyframe) const {
    return bags_[static_cast<std::size_t>(keyframe)];
  }
  /// The keyframes most alike, the best first, beside those left out. Keyframes next to one another
  /// are one candidate, the best of them.
  std::vector<PlaceCandidate> find(const BagOfWords& bag, const std::set<int>& left_out,
                                   std::size_t most) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(bags_);
    if constexpr (Archive::kReads) list();
  }

 private:
  struct Entry {
    int keyframe = 0;
    double weight = 0.0;
  };
  void list();
  void list(int keyframe);

  std::vector<BagOfWords> bags_;
  std::vector<std::vector<Entry>> entries_;  ///< by word
};

}  // namespace slam::mono_graph
