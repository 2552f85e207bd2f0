// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/image_decoder.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace slam_ros {
namespace {

using Decoder = void (*)(const std::vector<std::uint8_t>& data, cv::Mat& gray);

/// The codecs' library lies beside the one that holds this function.
std::filesystem::path codecsLibrary() {
  Dl_info here{};
  dladdr(reinterpret_cast<const void*>(&decodedGray), &here);
  return std::filesystem::path(here.dli_fname).parent_path() / "libslam_ros_image_codecs.so";
}

Decoder loadedDecoder() {
  void* library = dlopen(codecsLibrary().c_str(), RTLD_NOW | RTLD_LOCAL);
  void* decoder = library == nullptr ? nullptr : dlsym(library, "slam_ros_decode_gray");
  if (decoder == nullptr)
    throw std::runtime_error(fmt::format("compressed images cannot be decoded: {}", dlerror()));
  return reinterpret_cast<Decoder>(decoder);
}

}  // namespace

cv::Mat decodedGray(const std::vector<std::uint8_t>& data) {
  static const Decoder kDecode = loadedDecoder();
  cv::Mat gray;
  kDecode(data, gray);
  return gray;
}

}  // namespace slam_ros
