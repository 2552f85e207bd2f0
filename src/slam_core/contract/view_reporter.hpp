// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>

namespace slam {

/// It counts what became of the features of an image.
struct ViewStatistics {
  /// The back-end has located so many features in the image: some of its map, and others that are
  /// new to it.
  std::size_t features = 0;
  std::size_t expected = 0;  ///< it has searched for so many features of its map
  std::size_t matched = 0;   ///< so many of these were found and agree with the pose
  std::size_t rejected = 0;  ///< so many of these were found and contradict the others

  template <class Archive>
  void persist(Archive& archive) {
    archive(features, expected, matched, rejected);
  }
};

/// The capability of a back-end that follows natural features through the images of a camera.
class ViewReporter {
 public:
  virtual ~ViewReporter() = default;
  /// @return what became of the features of the last step's image; nothing if it had no usable one
  virtual std::optional<ViewStatistics> viewStatistics() const = 0;
};

}  // namespace slam
