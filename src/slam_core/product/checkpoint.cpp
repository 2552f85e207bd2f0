// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/checkpoint.hpp"

#include <sstream>
#include <stdexcept>
#include <utility>

#include "slam_core/common/archive.hpp"
#include "slam_core/common/sealed_bytes.hpp"

namespace slam {
namespace {

/// The version grows with each change of what a component keeps.
constexpr SealedFormat kCheckpointFormat = {
    "SLAMCKPT", 18, "it is no checkpoint: name a folder that an autosaving run has written into",
    "run anew"};

void requireSame(const std::string& what, const std::string& there, const std::string& here) {
  if (there != here)
    throw std::runtime_error("it is of another " + what + ", '" + there + "' instead of '" + here +
                             "': resume it with its own");
}

/// The first line of the configuration that differs, there and here.
void requireSameValues(const std::string& there, const std::string& here) {
  std::istringstream lines_there(there), lines_here(here);
  std::string of_there, of_here;
  while (of_there == of_here) {
    const bool has_more = bool(std::getline(lines_there, of_there));
    if (!std::getline(lines_here, of_here)) of_here.clear();
    if (!has_more) of_there.clear();
    if (!has_more && !lines_here) return;
  }
  requireSame("configuration", of_there, of_here);
}

}  // namespace

std::string checkpointOf(const RunIdentity& run, const std::string& state) {
  ArchiveWriter archive;
  archive(run, state);
  return sealed(kCheckpointFormat, archive.take());
}

std::string stateIn(const std::string& checkpoint, const RunIdentity& run) {
  const auto content = contentOf(kCheckpointFormat, checkpoint);
  ArchiveReader archive(content.data(), content.size());
  RunIdentity saved;
  std::string state;
  archive(saved);
  requireSame("product", saved.product, run.product);
  requireSame("robot", saved.robot, run.robot);
  requireSame("bag or composition", saved.data, run.data);
  requireSameValues(saved.configuration, run.configuration);
  archive(state);
  return state;
}

}  // namespace slam
