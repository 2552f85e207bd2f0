// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/run_writer.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/product/map_files.hpp"

namespace slam {
namespace {

/// What a run and its evaluation leave in the folder beside the files that are begun at once: none
/// of it may be of another run.
constexpr const char* kResults[] = {"trajectory_final.tum",
                                    "wheel_odometry.tum",
                                    "ground_truth.tum",
                                    "ground_truth_landmarks.yaml",
                                    "landmarks.yaml",
                                    "map.pgm",
                                    "map.yaml",
                                    "points.pcd",
                                    "config.yaml",
                                    "metrics.json",
                                    "trajectory.png",
                                    "odometry.png",
                                    "map.png",
                                    "landmark_errors.png",
                                    "consistency.png",
                                    "report.html"};

constexpr const char* kUpdatesHeader =
    "stamp,cov_xx,cov_xy,cov_xt,cov_yy,cov_yt,cov_tt,nis,nis_dof,used,gated,added,unknown,"
    "landmarks\n";

std::string stampText(Stamp stamp) {
  return fmt::format("{}.{:09d}", nanoseconds(stamp) / 1000000000, nanoseconds(stamp) % 1000000000);
}

std::string updateLine(const StepReport& report) {
  const auto& P = report.pose.covariance;
  const auto& s = report.statistics;
  return fmt::format(
      "{},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.9g},{},{},{},{},{},{}\n",
      stampText(report.stamp), P(0, 0), P(0, 1), P(0, 2), P(1, 1), P(1, 2), P(2, 2), s.nis,
      s.nis_dof, s.used, s.gated, s.added, s.unknown, s.landmarks);
}

void addCounts(const UpdateStatistics& from, UpdateStatistics& to) {
  to.nis += from.nis;
  to.nis_dof += from.nis_dof;
  to.used += from.used;
  to.gated += from.gated;
  to.added += from.added;
  to.unknown += from.unknown;
}

/// The lines of a trajectory with the poses that a later look at the path gives for their stamps.
std::string revised(const std::string& trajectory, const std::vector<StampedPose>& path) {
  std::unordered_map<std::string, std::string> lines;
  for (const auto& [stamp, pose] : path) lines[stampText(stamp)] = tumLine(stamp, pose);
  std::istringstream before(trajectory);
  std::string after, line;
  while (std::getline(before, line)) {
    const auto found = lines.find(line.substr(0, line.find(' ')));
    after += found == lines.end() ? line + "\n" : found->second;
  }
  return after;
}

std::string readFile(const std::string& path) {
  std::ostringstream content;
  content << std::ifstream(path).rdbuf();
  return content.str();
}

}  // namespace

std::string tumLine(Stamp stamp, const Pose2& pose) {
  // adding zero turns -0 into 0
  return fmt::format("{} {:.9f} {:.9f} 0.000000000 0.000000000 0.000000000 {:.9f} {:.9f}\n",
                     stampText(stamp), pose.x() + 0.0, pose.y() + 0.0,
                     std::sin(pose.theta() / 2) + 0.0, std::cos(pose.theta() / 2) + 0.0);
}

RunWriter::RunWriter(const std::string& folder) : folder_(folder) {
  if (folder.empty()) throw std::runtime_error("the output folder has no name");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw std::runtime_error("cannot make the output folder " + folder + ": " + error.message());
  for (const auto* name : kResults)
    std::filesystem::remove(std::filesystem::path(folder) / name, error);
  begin();
}

void RunWriter::open(const std::string& name, std::ofstream& file) const {
  const auto path = folder_ + "/" + name;
  file.close();  // before the file is emptied: what is still in the buffer must not follow
  file.clear();
  file.open(path, std::ios::trunc);
  if (!file) throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno));
}

void RunWriter::begin() {
  open("trajectory.tum", trajectory_);
  open("odometry.tum", odometry_);
  open("updates.csv", updates_);
  updates_ << kUpdatesHeader;
  pending_.reset();
  lines_ = 0;
}

void RunWriter::write(const StepReport& report) {
  if (report.restarted) begin();
  if (!report.hasTrigger()) return;
  const bool is_same_stamp = pending_ && pending_->stamp == report.stamp;
  const auto before = is_same_stamp ? pending_->statistics : UpdateStatistics();
  if (!is_same_stamp) writePending();
  pending_ = report;
  addCounts(before, pending_->statistics);
  last_stamp_ = report.stamp;
}

void RunWriter::writePending() {
  if (!pending_) return;
  trajectory_ << tumLine(pending_->stamp, pending_->pose.pose);
  odometry_ << tumLine(pending_->stamp, pending_->odometry_pose);
  updates_ << updateLine(*pending_);
  pending_.reset();
  ++lines_;
  if (!trajectory_ || !odometry_ || !updates_)
    throw std::runtime_error("cannot write into " + folder_ + ": is the disk full?");
}

void RunWriter::finish(const Backend& backend, const std::string& map_frame,
                       const std::string& config) {
  writePending();
  for (auto* file : {&trajectory_, &odometry_, &updates_})
    if (!file->flush())
      throw std::runtime_error("cannot write into " + folder_ + ": is the disk full?");
  writeFileAtomically(folder_ + "/trajectory_final.tum",
                      revised(readFile(folder_ + "/trajectory.tum"), backend.path()));
  saveMap(folder_ + "/landmarks.yaml", {map_frame, last_stamp_, backend.state()});
  writeFileAtomically(folder_ + "/config.yaml", config);
}

}  // namespace slam
