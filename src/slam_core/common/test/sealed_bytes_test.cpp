// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/sealed_bytes.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/test/faults.hpp"

namespace slam {
namespace {

constexpr SealedFormat kFormat = {"SLAMTEST", 7, "it is no file of this test", "write it again"};

std::string said(const std::string& bytes, const SealedFormat& format = kFormat) {
  return test::sentenceOf([&] { contentOf(format, bytes); });
}

TEST(SealedBytes, GiveBackTheirContent) {
  for (const auto& content : {std::string(), std::string("a\0b", 3), std::string(1000, 'x')})
    EXPECT_EQ(contentOf(kFormat, sealed(kFormat, content)), content);
}

TEST(SealedBytes, HaveTheChecksumOfOtherPrograms) {
  const std::string check = "123456789";  // the check value of CRC-64/XZ
  EXPECT_EQ(checksum(check.data(), check.size()), 0x995dc9bbdf1939faU);
  EXPECT_EQ(checksum(nullptr, 0), 0u);
}

TEST(SealedBytes, RefuseAnyByteThatIsMissingOrOneTooMany) {
  const auto bytes = sealed(kFormat, "some content");
  for (std::size_t size = 8; size < bytes.size(); ++size)
    EXPECT_EQ(said(bytes.substr(0, size)), "it is cut or has grown: write it again") << size;
  EXPECT_EQ(said(bytes + "!"), "it is cut or has grown: write it again");
}

TEST(SealedBytes, RefuseAnyBitThatIsFlipped) {
  const auto bytes = sealed(kFormat, "some content");
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    auto flipped = bytes;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_NE(said(flipped), "") << bit;
  }
}

TEST(SealedBytes, NameWhatTheyAreNot) {
  EXPECT_EQ(said("something else, which is long enough"), "it is no file of this test");
  EXPECT_EQ(said(""), "it is no file of this test");
  auto later = kFormat;
  later.version = 8;
  EXPECT_EQ(said(sealed(later, "content")),
            "it is of version 8 and this program reads version 7: use the program that has saved "
            "it");
}

}  // namespace
}  // namespace slam
