// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/pgm_image.hpp"

#include <fmt/format.h>

#include <cctype>
#include <stdexcept>

namespace slam::grid_map {
namespace {

/// Reads the header's words, which comments may stand between.
class Header {
 public:
  explicit Header(const std::string& content) : content_(content) {}

  std::string magic() { return content_.substr(0, at_ = 2); }

  std::uint32_t number(const std::string& name) {
    constexpr std::size_t kMostDigits = 9;
    skipSpaceAndComments();
    const auto begin = at_;
    while (at_ < content_.size() && isDigit(content_[at_])) ++at_;
    const auto digits = content_.substr(begin, at_ - begin);
    if (digits.empty()) throw std::runtime_error("its header has no " + name);
    if (digits.size() > kMostDigits)
      throw std::runtime_error("its " + name + ", " + digits + ", is no size of an image");
    return static_cast<std::uint32_t>(std::stoul(digits));
  }

  /// Where the pixels begin: after one white space.
  std::size_t end() const { return at_ + 1; }

 private:
  static bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

  void skipSpaceAndComments() {
    bool is_comment = false;
    for (; at_ < content_.size(); ++at_) {
      const char c = content_[at_];
      if (c == '#') is_comment = true;
      if (!is_comment && std::isspace(static_cast<unsigned char>(c)) == 0) return;
      if (c == '\n') is_comment = false;
    }
  }

  const std::string& content_;
  std::size_t at_ = 0;
};

}  // namespace

std::string toPgm(const PgmImage& image, const std::string& comment) {
  auto content = fmt::format("P5\n# {}\n{} {}\n255\n", comment, image.width, image.height);
  content.append(image.pixels.begin(), image.pixels.end());
  return content;
}

PgmImage fromPgm(const std::string& content) {
  constexpr std::uint64_t kMostPixels = 1u << 29;
  Header header(content);
  if (header.magic() != "P5")
    throw std::runtime_error("it is no binary PGM image, which begins with P5");
  PgmImage image;
  image.width = header.number("width");
  image.height = header.number("height");
  const auto brightest = header.number("largest grey value");
  const auto pixels = std::uint64_t{image.width} * image.height;
  if (pixels == 0 || pixels > kMostPixels)
    throw std::runtime_error(
        fmt::format("its size, {} x {}, is not that of a map", image.width, image.height));
  if (brightest != 255)
    throw std::runtime_error(
        fmt::format("its largest grey value is {} and must be 255", brightest));
  if (content.size() < header.end() + pixels)
    throw std::runtime_error(fmt::format("it should hold {} pixels and is cut off", pixels));
  const auto begin = content.begin() + static_cast<std::ptrdiff_t>(header.end());
  image.pixels.assign(begin, begin + static_cast<std::ptrdiff_t>(pixels));
  return image;
}

}  // namespace slam::grid_map
