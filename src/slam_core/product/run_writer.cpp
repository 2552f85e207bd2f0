// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/run_writer.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/contract/graph_reporter.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/contract/place_reporter.hpp"
#include "slam_core/contract/trajectory_capabilities.hpp"
#include "slam_core/product/feature_file.hpp"
#include "slam_core/product/graph_file.hpp"
#include "slam_core/product/map_files.hpp"
#include "slam_core/product/map_fragment.hpp"
#include "slam_core/product/place_file.hpp"
#include "slam_core/product/stamp_text.hpp"

namespace slam {
namespace {

constexpr const char* kUpdatesHeader =
    "stamp,cov_xx,cov_xy,cov_xt,cov_yy,cov_yt,cov_tt,nis,nis_dof,used,gated,added,unknown,"
    "landmarks\n";

constexpr const char* kAssociationsHeader = "stamp,own_id,taken_for,landmark\n";
constexpr const char* kAssociations = "associations.csv";

const Names<TakenFor>& namesOfTakenFor() {
  static const Names<TakenFor> kNames = {
      {"landmark", TakenFor::kLandmark}, {"new", TakenFor::kNew},
      {"gated", TakenFor::kGated},       {"ambiguous", TakenFor::kAmbiguous},
      {"on_trial", TakenFor::kOnTrial},  {"not_in_map", TakenFor::kNotInMap},
      {"nothing", TakenFor::kNothing},   {"taken_back", TakenFor::kTakenBack}};
  return kNames;
}

std::string associationLine(Stamp stamp, const AssociatedObservation& observation) {
  return fmt::format("{},{},{},{}\n", stampText(stamp), observation.own_id,
                     nameOf(observation.taken_for, namesOfTakenFor()), observation.landmark);
}

constexpr const char* kViewsHeader = "stamp,features,expected,matched,rejected\n";
constexpr const char* kViews = "views.csv";

std::string viewLine(Stamp stamp, const ViewStatistics& view) {
  return fmt::format("{},{},{},{},{}\n", stampText(stamp), view.features, view.expected,
                     view.matched, view.rejected);
}

constexpr const char* kEventsHeader = "stamp,kind,distance,turn,reason\n";

std::string eventLine(const Event& event) {
  return fmt::format("{},{},{:.6f},{:.6f},\"{}\"\n", stampText(event.stamp),
                     nameOf(event.kind, namesOfEvents()), event.distance, event.turn, event.reason);
}

std::string updateLine(const StepReport& report) {
  const auto& P = report.pose.covariance;
  const auto& s = report.statistics;
  return fmt::format(
      "{},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.9g},{},{},{},{},{},{}\n",
      stampText(report.stamp), P(0, 0), P(0, 1), P(0, 2), P(1, 1), P(1, 2), P(2, 2), s.nis,
      s.nis_dof, s.used, s.gated, s.added, s.unknown, s.landmarks);
}

/// Writes `NAME1.session`, `NAME2.session`, ...
void writeSessions(const std::vector<SavedSession>& sessions, const std::string& name) {
  for (std::size_t i = 0; i < sessions.size(); ++i)
    writeFileAtomically(fmt::format("{}{}.session", name, i + 1), sessions[i].bytes);
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

/// Where a file's lines go that were written before time started over for the n-th time.
std::string keptName(const std::string& name, std::size_t restart) {
  const auto dot = name.rfind('.');
  return fmt::format("{}.before_restart_{}{}", name.substr(0, dot), restart, name.substr(dot));
}

/// Opens a file for more behind its first `size` bytes; what follows them is cut off.
void goOn(const std::string& path, std::uint64_t size, std::ofstream& file) {
  std::error_code error;
  if (const auto now = std::filesystem::file_size(path, error); error || now < size)
    throw std::runtime_error("the run cannot be resumed, since " + path +
                             " is gone or shorter than when it was saved: run anew");
  std::filesystem::resize_file(path, size, error);
  file.open(path, std::ios::app | std::ios::ate);
  if (error || !file)
    throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno));
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

std::string tumLineWithoutHeading(Stamp stamp, const Eigen::Vector2d& position) {
  return fmt::format("{} {:.9f} {:.9f} 0.000000000 0 0 0 0\n", stampText(stamp), position.x() + 0.0,
                     position.y() + 0.0);
}

RunWriter::RunWriter(const std::string& folder, Start start)
    : folder_(folder, start), is_resumed_(start == Start::kResumed) {
  if (!is_resumed_) begin();
}

RunWriter::~RunWriter() {
  if (lines() == 0 && restarts_ == 0 && !is_resumed_) folder_.discard();
}

void RunWriter::open(const std::string& name, std::ofstream& file) const {
  const auto path = unfinished() + "/" + name;
  file.close();  // before the file is emptied: what is still in the buffer must not follow
  file.clear();
  file.open(path, std::ios::trunc);
  if (!file) throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno));
}

void RunWriter::restart() {
  writePending();
  if (lines_ > 0) {
    ++restarts_;
    for (const auto& [name, file] : files())
      if (file->is_open()) keep(name, *file);
  }
  begin();
}

void RunWriter::keep(const std::string& name, std::ofstream& file) const {
  file.close();
  const auto kept = unfinished() + "/" + keptName(name, restarts_);
  std::error_code error;
  std::filesystem::rename(unfinished() + "/" + name, kept, error);
  if (error) throw std::runtime_error("cannot write " + kept + ": " + error.message());
  if (restarts_ > kMostKept)
    std::filesystem::remove(unfinished() + "/" + keptName(name, restarts_ - kMostKept), error);
}

void RunWriter::begin() {
  open("trajectory.tum", trajectory_);
  open("odometry.tum", odometry_);
  open("updates.csv", updates_);
  updates_ << kUpdatesHeader;
  open("events.csv", events_);
  events_ << kEventsHeader;
  pending_.reset();
  lines_ = 0;
}

void RunWriter::write(const StepReport& report) {
  if (report.restarted) restart();
  for (const auto& event : report.events) events_ << eventLine(event);
  if (!report.hasTrigger()) return;
  const bool is_same_stamp = pending_ && pending_->stamp == report.stamp;
  const auto before = is_same_stamp ? pending_->statistics : UpdateStatistics();
  if (!is_same_stamp) writePending();
  writeAssociations(report);
  writeView(report);
  pending_ = report;
  addCounts(before, pending_->statistics);
  last_stamp_ = report.stamp;
}

void RunWriter::writeAssociations(const StepReport& report) {
  const auto& [now, before] =
      std::tie(report.statistics.associations, report.statistics.revised_associations);
  if (now.empty() && before.empty()) return;
  if (!associations_.is_open()) {
    open(kAssociations, associations_);
    associations_ << kAssociationsHeader;
  }
  for (const auto& [stamp, observation] : before)
    associations_ << associationLine(stamp, observation);
  for (const auto& observation : now) associations_ << associationLine(report.stamp, observation);
}

void RunWriter::writeView(const StepReport& report) {
  if (!report.view) return;
  if (!views_.is_open()) {
    open(kViews, views_);
    views_ << kViewsHeader;
  }
  views_ << viewLine(report.stamp, *report.view);
}

void RunWriter::writePending() {
  if (!pending_) return;
  trajectory_ << tumLine(pending_->stamp, pending_->pose.pose);
  odometry_ << tumLine(pending_->stamp, pending_->odometry_pose);
  updates_ << updateLine(*pending_);
  pending_.reset();
  ++lines_;
  for (const auto& [name, file] : files())
    if (!*file) throw std::runtime_error("cannot write into " + folder() + ": is the disk full?");
}

std::array<std::pair<std::string, std::ofstream*>, 6> RunWriter::files() {
  return {{{"trajectory.tum", &trajectory_},
           {"odometry.tum", &odometry_},
           {"updates.csv", &updates_},
           {"events.csv", &events_},
           {kAssociations, &associations_},
           {kViews, &views_}}};
}

void RunWriter::saveState(ArchiveWriter& archive) {
  archive(pending_, last_stamp_, lines_, restarts_);
  for (auto& [name, file] : files()) {
    std::optional<std::uint64_t> size;
    if (file->is_open()) {
      if (!file->flush())
        throw std::runtime_error("cannot write into " + folder() + ": is the disk full?");
      flushToDisk(unfinished() + "/" + name);
      size = static_cast<std::uint64_t>(file->tellp());
    }
    archive(size);
  }
}

void RunWriter::restoreState(ArchiveReader& archive) {
  archive(pending_, last_stamp_, lines_, restarts_);
  undoRestart();
  std::set<std::string> known;
  std::map<std::string, std::uint64_t> sizes;
  for (const auto& [name, file] : files()) {
    std::optional<std::uint64_t> size;
    archive(size);
    for (std::size_t restart = 1; restart <= restarts_; ++restart)
      known.insert(keptName(name, restart));
    if (!size) continue;
    sizes[name] = *size;
    known.insert(name);
  }
  folder_.restrictTo(known);
  for (auto& [name, file] : files())
    if (const auto size = sizes.find(name); size != sizes.end())
      goOn(unfinished() + "/" + name, size->second, *file);
}

/// Where time started over after the checkpoint, the files of that time have other names.
void RunWriter::undoRestart() {
  std::error_code ignored;
  for (const auto& [name, file] : files())
    std::filesystem::rename(unfinished() + "/" + keptName(name, restarts_ + 1),
                            unfinished() + "/" + name, ignored);
}

void RunWriter::finish(const Capabilities& backend, const std::string& map_frame,
                       const std::string& config) {
  writePending();
  for (const auto& [name, file] : files())
    if (!file->flush())
      throw std::runtime_error("cannot write into " + folder() + ": is the disk full?");
  const auto* reviser = backend.find<PathReviser>();
  writeFileAtomically(unfinished() + "/trajectory_final.tum",
                      revised(readFile(unfinished() + "/trajectory.tum"),
                              reviser ? reviser->path() : std::vector<StampedPose>()));
  if (const auto* keeper = backend.find<MapKeeper>())
    saveMap(unfinished() + "/landmarks.yaml", {map_frame, last_stamp_, keeper->state()});
  if (const auto* reporter = backend.find<GraphReporter>())
    writeFileAtomically(unfinished() + "/graph.csv", graphTable(reporter->graph()));
  if (const auto* places = backend.find<PlaceReporter>())
    writeFileAtomically(unfinished() + "/places.csv", placeTable(places->visits()));
  if (const auto* mapper = backend.find<FeatureMapper>())
    writeFileAtomically(unfinished() + "/features.csv", featureTable(mapper->features()));
  if (const auto* fragment = backend.find<MapFragment>())
    writeSessions(fragment->unmerged(), unfinished() + "/" + RunFolder::kUnmerged);
  writeFileAtomically(unfinished() + "/config.yaml", config);
  folder_.complete();
}

}  // namespace slam
