// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "frame.hpp"

namespace slam_pipes {
namespace {

Frame datum(const std::string& value) { return {Frame::Type::kDatum, "scan", "toy::Scan", value}; }

std::string faultOf(const std::string& bytes) {
  FrameDecoder decoder;
  decoder.append(bytes.data(), bytes.size());
  try {
    while (decoder.next()) {
    }
  } catch (const std::runtime_error& fault) {
    return fault.what();
  }
  return "";
}

TEST(Frames, ComeOutAsTheyWentInHoweverTheyAreCut) {
  FrameEncoder encoder;
  auto bytes = encoder.bytesOf(datum(std::string("a\0b", 3)));
  bytes += encoder.bytesOf({Frame::Type::kStep, "", "", ""});
  for (const std::size_t piece : {1U, 7U, 30U, 1000U}) {
    FrameDecoder decoder;
    std::vector<Frame> frames;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      const auto part = bytes.substr(at, piece);
      decoder.append(part.data(), part.size());
      while (auto frame = decoder.next()) frames.push_back(*frame);
    }
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[0].port, "scan");
    EXPECT_EQ(frames[0].kind, "toy::Scan");
    EXPECT_EQ(frames[0].value, std::string("a\0b", 3));
    EXPECT_EQ(frames[1].type, Frame::Type::kStep);
    EXPECT_FALSE(decoder.isWithinFrame());
  }
}

TEST(Frames, ThatAreCutAreNotHandedOut) {
  FrameEncoder encoder;
  const auto bytes = encoder.bytesOf(datum("value"));
  for (std::size_t size = 1; size < bytes.size(); ++size) {
    FrameDecoder decoder;
    decoder.append(bytes.data(), size);
    EXPECT_FALSE(decoder.next());
    EXPECT_TRUE(decoder.isWithinFrame());
  }
}

TEST(Frames, OfAnotherVersionAreRefusedBeforeTheirSizeIsBelieved) {
  FrameEncoder encoder;
  auto bytes = encoder.bytesOf(datum("value"));
  bytes[8] = 9;
  EXPECT_EQ(faultOf(bytes.substr(0, 20)),
            "its frames are of version 9 and this program reads version 1: start both of its ends "
            "from one installation");
}

TEST(Frames, ThatAreNoneAreRefused) {
  EXPECT_EQ(faultOf("stamp, x, y, theta and so on"),
            "what comes is no port data: have slam_pipes start both of its ends");
}

TEST(Frames, WithADamagedByteAreRefused) {
  FrameEncoder encoder;
  const auto good = encoder.bytesOf(datum("value"));
  for (std::size_t at = 20; at < good.size(); ++at) {
    auto bytes = good;
    bytes[at] = static_cast<char>(bytes[at] ^ 4);
    EXPECT_EQ(faultOf(bytes), "it is damaged, its checksum does not fit: start the run again");
  }
}

TEST(Frames, OfASizeThatIsDamagedTakeNoMemory) {
  FrameEncoder encoder;
  auto bytes = encoder.bytesOf(datum("value"));
  bytes[18] = 1;
  EXPECT_EQ(faultOf(bytes).find("a frame of 281474976710"), 0U);
}

TEST(Frames, ThatAreMissingAreNoticed) {
  FrameEncoder encoder;
  const auto first = encoder.bytesOf(datum("a")), second = encoder.bytesOf(datum("b")),
             third = encoder.bytesOf(datum("c"));
  EXPECT_EQ(faultOf(first + third), "frame 2 comes where frame 1 is expected: start the run again");
  EXPECT_EQ(faultOf(first + second + third), "");
}

}  // namespace
}  // namespace slam_pipes
