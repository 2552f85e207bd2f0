// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bag_writer.hpp"

#include <algorithm>

#include "import_error.hpp"
#include "slam_core/common/atomic_file.hpp"

namespace slam::eval {

double BagWriter::duration() const {
  const auto by_stamp = [](const Entry& a, const Entry& b) { return a.stamp < b.stamp; };
  const auto range = std::minmax_element(entries_.begin(), entries_.end(), by_stamp);
  return entries_.empty() ? 0.0 : (range.second->stamp - range.first->stamp).toSec();
}

void BagWriter::write(const std::string& path, Progress& progress) {
  if (entries_.empty()) throw ImportError("there is nothing to write to " + path);
  std::stable_sort(entries_.begin(), entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.stamp < b.stamp; });
  try {
    slam_ros::BagFile bag(path);
    writeMessages(bag, progress);
    writeBeside(path);
    bag.complete();
  } catch (const slam_ros::BagPathError& error) {
    throw UsageError(error.what());
  } catch (const slam_ros::BagWriteError& error) {
    throw ImportError(error.what());
  }
}

void BagWriter::writeMessages(slam_ros::BagFile& bag, Progress& progress) const {
  progress.begin("writing", entries_.size());
  const std::uint64_t start = entries_.front().stamp.toNSec();
  for (std::size_t i = 0; i < first_.size(); ++i) {
    const std::uint64_t before = std::min<std::uint64_t>(first_.size() - i, start - 1);
    ros::Time stamp;
    first_[i].write(bag, stamp.fromNSec(start - before));
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    entries_[i].write(bag, entries_[i].stamp);
    progress.update(i + 1);
  }
  progress.end();
}

void BagWriter::writeBeside(const std::string& path) const {
  try {
    for (const auto& [ending, text] : beside_) writeFileAtomically(path + ending, text);
  } catch (const std::runtime_error& error) {
    throw ImportError(error.what());
  }
}

}  // namespace slam::eval
