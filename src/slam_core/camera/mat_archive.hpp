// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <cstring>
#include <opencv2/core/mat.hpp>
#include <stdexcept>
#include <vector>

namespace slam {

/// Writes a matrix of OpenCV, or reads one, with what lies around it where it is a part of a larger
/// one: optical flow looks at the border of its pyramid.
/// @throw std::runtime_error where what is read is no matrix
template <class Archive>
void persistMat(Archive& archive, cv::Mat& mat) {
  cv::Size size;
  cv::Point offset;
  if (!mat.empty()) mat.locateROI(size, offset);
  cv::Rect part(offset, mat.size());
  int type = mat.type();
  std::vector<std::uint8_t> bytes;
  if constexpr (!Archive::kReads) {
    cv::Mat whole = mat;
    if (!mat.empty())
      whole.adjustROI(offset.y, size.height - part.br().y, offset.x, size.width - part.br().x);
    for (int row = 0; row < whole.rows; ++row)
      bytes.insert(bytes.end(), whole.ptr(row),
                   whole.ptr(row) + whole.elemSize() * static_cast<std::size_t>(whole.cols));
  }
  archive(type, size.width, size.height, part.x, part.y, part.width, part.height, bytes);
  if constexpr (Archive::kReads) {
    const bool is_matrix = type == (type & CV_MAT_TYPE_MASK) && size.width >= 0 &&
                           size.height >= 0 && (cv::Rect({}, size) & part) == part &&
                           bytes.size() == std::size_t(size.width) * std::size_t(size.height) *
                                               std::size_t(CV_ELEM_SIZE(type));
    if (!is_matrix) throw std::runtime_error("it holds an image of another size: save it again");
    cv::Mat whole(size, type);
    if (!bytes.empty()) std::memcpy(whole.data, bytes.data(), bytes.size());
    mat = bytes.empty() ? cv::Mat() : whole(part);
  }
}

}  // namespace slam
