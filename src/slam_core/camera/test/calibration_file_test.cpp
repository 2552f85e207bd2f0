// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/camera/calibration_file.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam {
namespace {

constexpr const char* kGood = R"(image_width: 640
image_height: 480
camera_name: narrow
camera_matrix: {rows: 3, cols: 3, data: [500.5, 0, 320, 0, 501, 240, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [-0.1, 0.01, 0, 0, 0]}
)";

class CalibrationFile : public testing::Test {
 protected:
  std::string write(const std::string& text) const { return folder_.write("camera.yaml", text); }
  std::string sentenceWithout(const std::string& line_begin) const {
    std::string text = kGood;
    const auto begin = text.find(line_begin);
    text.erase(begin, text.find('\n', begin) + 1 - begin);
    const auto path = write(text);
    return test::sentenceOf([&] { loadCalibrationFile(path); });
  }

  test::TemporaryFolder folder_;
};

TEST_F(CalibrationFile, IsReadAsRosWritesIt) {
  const auto calibration = loadCalibrationFile(write(kGood));
  EXPECT_EQ(calibration, (CameraCalibration{
                             640, 480, "plumb_bob", 500.5, 501, 320, 240, {-0.1, 0.01, 0, 0, 0}}));
}

TEST_F(CalibrationFile, IsRefusedWithWhatIsMissing) {
  EXPECT_NE(sentenceWithout("image_width").find("image_width is missing"), std::string::npos);
  EXPECT_NE(sentenceWithout("camera_matrix").find("camera_matrix/data"), std::string::npos);
  EXPECT_NE(sentenceWithout("distortion_c").find("distortion_coefficients"), std::string::npos);
}

TEST_F(CalibrationFile, IsRefusedWhenItIsNoCalibration) {
  const auto sentenceOf = [&](const std::string& text) {
    const auto path = write(text);
    return test::sentenceOf([&] { loadCalibrationFile(path); });
  };
  EXPECT_NE(sentenceOf("[1, 2]").find("not a map"), std::string::npos);
  std::string text = kGood;
  text.replace(text.find("[500.5, 0, 320, 0, 501"), 22, "[0, 0, 0, 0, 0");
  EXPECT_NE(sentenceOf(text).find("not calibrated"), std::string::npos);
  EXPECT_NE(test::sentenceOf([] { loadCalibrationFile("/no/such.yaml"); }).find("/no/such.yaml"),
            std::string::npos);
}

}  // namespace
}  // namespace slam
