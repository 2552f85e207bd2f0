// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>

namespace slam {

/// What became of the features of an image.
struct ViewStatistics {
  /// that were located in the image: those of the map that it was searched for, and new ones; by a
  /// back-end that detects all, those without a place in the map as well
  std::size_t features = 0;
  std::size_t expected = 0;  ///< features of the map that the image was searched for
  std::size_t matched = 0;   ///< of these: found, and in agreement with the pose
  std::size_t rejected = 0;  ///< of these: found, but in contradiction to the others

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
