// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace slam {

/// What a run was of; only a run of the same can be resumed.
struct RunIdentity {
  std::string product, robot;  ///< names or files
  std::string data;            ///< a clause that tells a bag from others
  std::string configuration;   ///< all values in force, a line each

  template <class Archive>
  void persist(Archive& archive) {
    archive(product, robot, data, configuration);
  }
};

/// The content of a checkpoint's file: versioned, with a checksum.
/// @param state of the run, see ArchiveWriter
std::string checkpointOf(const RunIdentity& run, const std::string& state);

/// @return the state in a checkpoint
/// @throw std::runtime_error with what is wrong, to stand behind the file's name: no checkpoint,
/// another version, cut, damaged, or of another run than `run`
std::string stateIn(const std::string& checkpoint, const RunIdentity& run);

}  // namespace slam
