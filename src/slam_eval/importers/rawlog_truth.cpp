// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_truth.hpp"

#include <algorithm>
#include <filesystem>

#include "import_error.hpp"
#include "text_table.hpp"

namespace slam::eval {

namespace fs = std::filesystem;

namespace {

constexpr char kComment = '%';

}  // namespace

std::string findTruthFile(const std::string& rawlog, const std::string& ending) {
  const std::string stem = fs::path(rawlog).replace_extension().string();
  for (const std::string& base : {stem, rawlog}) {
    if (fs::is_regular_file(base + ending)) return base + ending;
  }
  return "";
}

std::vector<RawlogTruth::Landmark> readTrueLandmarks(const std::string& path) {
  requireFile(path);
  std::vector<RawlogTruth::Landmark> landmarks;
  for (const TextRow& row : readTable(path, 7, kComment)) {
    landmarks.push_back({row.integer(6), row.number(0), row.number(1)});
  }
  std::sort(landmarks.begin(), landmarks.end(),
            [](const auto& a, const auto& b) { return a.id < b.id; });
  const auto twice = std::adjacent_find(landmarks.begin(), landmarks.end(),
                                        [](const auto& a, const auto& b) { return a.id == b.id; });
  if (twice != landmarks.end()) {
    throw ImportError(path + ": landmark " + std::to_string(twice->id) + " stands twice");
  }
  return landmarks;
}

std::vector<RawlogTruth::Pose> readTruePath(const std::string& path, std::size_t frames) {
  requireFile(path);
  std::vector<RawlogTruth::Pose> poses;
  for (const TextRow& row : readTable(path, 6, kComment)) {
    poses.push_back({row.number(0), row.number(1), row.number(3)});
  }
  if (poses.size() != frames && poses.size() != frames + 1) {
    throw ImportError(path + " holds " + std::to_string(poses.size()) + " poses, but the log " +
                      std::to_string(frames) + " frames: they do not belong together");
  }
  poses.resize(frames);
  return poses;
}

}  // namespace slam::eval
