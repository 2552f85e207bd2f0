// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "import_error.hpp"
#include "matlab_file.hpp"
#include "matlab_maker.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

using Form = MatlabMaker::Form;

std::string fromHex(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return bytes;
}

/// A file's LASER (2 x 3, unsigned 16 bit) and speed (2 x 1, double) as scipy 1.10 writes them.
std::string ofScipyCompressed() {
  std::string header = "MATLAB 5.0 MAT-file Platform: posix";
  header.resize(124, '\0');
  return header + fromHex("0001494d") +
         fromHex(
             "0f00000039000000789ce3636060f000623620e600626e06086085f2998098198819a1623e8ec1ae"
             "41409a05887980380528fa5f9e8d4187911dac0f0067e603d00f00000031000000789ce3636060f0"
             "00623620e680d220c00ae5330131231483c48a0b525353803427100b30c0c0037b08fd653f00715d"
             "057d");
}

std::string ofScipyLevel4() {
  return fromHex(
      "0000000002000000010000000000000006000000737065656400000000000000e03f00000000"
      "0000f4bf28000000020000000300000000000000060000004c415345520064000500ff1f06002c01"
      "0700");
}

class MatlabFile : public testing::Test {
 protected:
  auto read(const std::string& bytes) {
    folder_.write("a.mat", bytes);
    return readMatlabFile(folder_.file("a.mat"));
  }
  std::string failure(const std::string& bytes) {
    return messageOf<ImportError>([&] { read(bytes); });
  }
  void expectFailure(const std::string& bytes, const std::string& text) {
    const auto sentence = failure(bytes);
    EXPECT_NE(sentence.find(text), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("a.mat"), std::string::npos) << sentence;
  }

  TempFolder folder_;
};

TEST_F(MatlabFile, ReadsWhatAnotherProgramWrites) {
  for (const auto& bytes : {ofScipyCompressed(), ofScipyLevel4()}) {
    const auto matrices = read(bytes);
    ASSERT_EQ(matrices.size(), 2u);
    const auto& laser = matrices.at("LASER");
    EXPECT_EQ(laser.rows, 2u);
    EXPECT_EQ(laser.columns, 3u);
    EXPECT_EQ(laser.at(0, 1), 8191.0);
    EXPECT_EQ(laser.at(1, 2), 7.0);
    EXPECT_FALSE(laser.isVector());
    EXPECT_EQ(matrices.at("speed").values, (std::vector<double>{0.5, -1.25}));
    EXPECT_TRUE(matrices.at("speed").isVector());
  }
}

TEST_F(MatlabFile, ReadsEachForm) {
  for (const auto form : {Form::kLevel4, Form::kLevel5, Form::kLevel5Compressed}) {
    const auto matrices = read(MatlabMaker(form)
                                   .add("half", 1, 3, {0.5, 1.5, 2.5})
                                   .addUint16("counts", 2, 2, {1, 2, 3, 65535})
                                   .bytes());
    EXPECT_EQ(matrices.at("half").values, (std::vector<double>{0.5, 1.5, 2.5}));
    EXPECT_EQ(matrices.at("counts").at(1, 1), 65535.0);
  }
}

TEST_F(MatlabFile, ReadsTheOtherByteOrder) {
  std::string header = "MATLAB 5.0 MAT-file";
  header.resize(124, ' ');
  // flags of a double, 1 x 1, a name in a short element, 2.5
  const auto matrix = fromHex(
      "0000000e00000038"
      "0000000600000008"
      "0000000600000000"
      "0000000500000008"
      "0000000100000001"
      "0001000178000000"
      "0000000900000008"
      "4004000000000000");
  EXPECT_EQ(read(header + fromHex("01004d49") + matrix).at("x").values, std::vector<double>{2.5});
}

TEST_F(MatlabFile, LeavesOutWhatIsNoNumber) {
  auto text = MatlabMaker(Form::kLevel5).add("x", 1, 1, {1.0}).bytes();
  text[128 + 16] = 4;  // the class of a text
  EXPECT_TRUE(read(text).empty());
}

TEST_F(MatlabFile, SaysWhatIsWrong) {
  EXPECT_NE(messageOf<UsageError>([&] {
              readMatlabFile(folder_.file("none.mat"));
            }).find("there is no file"),
            std::string::npos);
  expectFailure("", "no MATLAB file");
  expectFailure(std::string(300, 'x'), "no MATLAB file");
  expectFailure("MATLAB 7.3 MAT-file" + std::string(600, ' '), "save it with -v7");
  for (const auto form : {Form::kLevel4, Form::kLevel5}) {
    const auto whole = MatlabMaker(form).addColumn("x", {1, 2, 3, 4}).bytes();
    expectFailure(whole.substr(0, whole.size() - 9), "is damaged: it ends in the middle");
  }
  auto packed = MatlabMaker(Form::kLevel5Compressed).addColumn("x", {1, 2, 3, 4}).bytes();
  packed[140] = static_cast<char>(~packed[140]);
  expectFailure(packed, "is damaged");
  auto shape = MatlabMaker(Form::kLevel5).addColumn("x", {1, 2, 3, 4}).bytes();
  shape[128 + 8 + 16 + 8] = 7;  // rows
  expectFailure(shape, "another number of values than its dimensions tell");
}

TEST_F(MatlabFile, NoDamagedByteCrashesIt) {
  for (const auto form : {Form::kLevel4, Form::kLevel5, Form::kLevel5Compressed}) {
    const auto whole = MatlabMaker(form).addColumn("speed", {1, 2, 3}).bytes();
    for (std::size_t i = 0; i < whole.size(); ++i)
      for (const int flip : {0x01, 0x80, 0xff}) {
        auto damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ flip);
        failure(damaged);  // a sentence, or other numbers
      }
  }
}

}  // namespace
}  // namespace slam::eval
