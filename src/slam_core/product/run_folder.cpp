// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/run_folder.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace slam {
namespace {

namespace fs = std::filesystem;

/// What a run and its evaluation leave in the folder: none of it may be of another run.
constexpr const char* kResults[] = {"trajectory.tum",   "trajectory_final.tum",
                                    "odometry.tum",     "wheel_odometry.tum",
                                    "updates.csv",      "events.csv",
                                    "graph.csv",        "places.csv",
                                    "associations.csv", "features.csv",
                                    "views.csv",        "seen.png",
                                    "ground_truth.tum", "ground_truth_landmarks.yaml",
                                    "stamps.csv",       "landmarks.yaml",
                                    "map.pgm",          "map.yaml",
                                    "points.pcd",       "config.yaml",
                                    "robot.yaml",       "metrics.json",
                                    "trajectory.png",   "odometry.png",
                                    "map.png",          "landmark_errors.png",
                                    "consistency.png",  "graph.png",
                                    "relations.png",    "report.html"};
constexpr const char* kKept = ".before_restart_";  ///< in names of what was written until a restart
constexpr const char* kLast = "config.yaml";

std::vector<std::string> namesIn(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  return names;
}

/// @return whether it is the name of a session that was not merged, such as unmerged_2.session
bool isUnmerged(const std::string& name) {
  const std::string begin = RunFolder::kUnmerged, end = ".session";
  const auto length = name.size(), around = begin.size() + end.size();
  if (length <= around || name.compare(0, begin.size(), begin) != 0 ||
      name.compare(length - end.size(), end.size(), end) != 0)
    return false;
  return name.find_first_not_of("0123456789", begin.size()) == length - end.size();
}

const std::string& made(const std::string& folder) {
  if (folder.empty()) throw std::runtime_error("the output folder has no name");
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw std::runtime_error("cannot make the output folder " + folder + ": " + error.message());
  return folder;
}

}  // namespace

RunFolder::RunFolder(const std::string& path, Start start)
    : path_(path), unfinished_((fs::path(path) / "unfinished_run").string()), lock_(made(path)) {
  for (const auto* name : kResults) {
    requirePlace(name);
    const auto file = path_ + "/" + name;
    if (fs::exists(fs::symlink_status(file))) former_[file] = versionOf(file);
  }
  for (const auto& entry : fs::directory_iterator(path_)) {
    const auto name = entry.path().filename().string();
    const auto file = path_ + "/" + name;
    if (isUnmerged(name) || name.find(kKept) != std::string::npos) former_[file] = versionOf(file);
  }
  if (start == Start::kAnew)
    clear();
  else if (!fs::is_regular_file(unfinished_ + "/" + kCheckpoint))
    throw std::runtime_error("there is no checkpoint of an unfinished run in " + path_ +
                             ": run anew, with autosave");
}

void RunFolder::clear() {
  std::error_code error;
  fs::remove_all(unfinished_, error);  // of a link only the link
  if (!fs::create_directory(unfinished_, error))
    throw std::runtime_error("cannot make the folder " + unfinished_ + ": " + error.message());
}

RunFolder::FileVersion RunFolder::versionOf(const std::string& path) {
  struct stat status {};
  ::lstat(path.c_str(), &status);
  return {1'000'000'000LL * status.st_mtim.tv_sec + status.st_mtim.tv_nsec, status.st_ino};
}

void RunFolder::requirePlace(const std::string& name) const {
  if (fs::is_directory(path_ + "/" + name))
    throw std::runtime_error("cannot write " + path_ + "/" + name + ": Is a directory");
}

void RunFolder::removeFormer() {
  std::error_code ignored;
  for (const auto& [file, version] : former_)
    if (versionOf(file) == version) fs::remove(file, ignored);
}

void RunFolder::restrictTo(const std::set<std::string>& files) {
  for (const auto& name : files)
    if (!fs::exists(unfinished_ + "/" + name) && fs::exists(path_ + "/" + name))
      fs::rename(path_ + "/" + name, unfinished_ + "/" + name);
  for (const auto& name : namesIn(unfinished_))
    if (files.count(name) == 0 && name != kCheckpoint) fs::remove_all(unfinished_ + "/" + name);
}

void RunFolder::complete() {
  auto names = namesIn(unfinished_);
  names.erase(std::remove(names.begin(), names.end(), kCheckpoint), names.end());
  for (const auto& name : names) requirePlace(name);
  removeFormer();
  const auto move = [this](const std::string& name) {
    fs::rename(unfinished_ + "/" + name, path_ + "/" + name);
  };
  for (const auto& name : names)
    if (name != kLast) move(name);
  if (fs::exists(unfinished_ + "/" + kLast)) move(kLast);
  discard();
}

void RunFolder::discard() {
  std::error_code ignored;
  fs::remove_all(unfinished_, ignored);
}

}  // namespace slam
