// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/session_file.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/input_file.hpp"
#include "slam_core/common/sealed_bytes.hpp"
#include "slam_core/graph_slam/session_archive.hpp"
#include "slam_core/graph_slam/session_check.hpp"

namespace slam::graph_slam {
namespace {

constexpr SealedFormat kSessionFormat = {
    "SLAMGRPH", 3, "it is no session of the graph: name a file that save_session has written",
    "copy it again or save the session again"};

/// Each scan of a session has here what further lasers saw.
using FurtherFans = std::vector<std::vector<LaserFan>>;

FurtherFans furtherOf(const Session& session) {
  FurtherFans further;
  for (const auto& each : session.scans) further.push_back(each.scan->further);
  return further;
}

bool hasAny(const FurtherFans& further) {
  return std::any_of(further.begin(), further.end(),
                     [](const auto& fans) { return !fans.empty(); });
}

void addFurther(const FurtherFans& further, Session& session) {
  if (further.size() != session.scans.size())
    throw std::runtime_error(
        "it has not as many scans of a second laser as of the first one: save "
        "the session again");
  for (std::size_t i = 0; i < further.size(); ++i) {
    auto joined = std::make_shared<LaserScan>(*session.scans[i].scan);
    joined->further = further[i];
    session.scans[i].scan = std::move(joined);
  }
}

}  // namespace

std::string bytesOf(const Session& session) {
  SessionWriter writer;
  Session copy = session;
  writer(copy);
  if (auto further = furtherOf(copy); hasAny(further)) writer(further);
  return sealed(kSessionFormat, writer.take());
}

Session sessionOf(const std::string& bytes) {
  const auto content = contentOf(kSessionFormat, bytes);
  SessionReader reader(content.data(), content.size());
  Session session;
  reader(session);
  if (reader.left() > 0) {
    FurtherFans further;
    reader(further);
    addFurther(further, session);
  }
  if (reader.left() > 0)
    throw std::runtime_error("it goes on behind its last record: save the session again");
  if (const auto fault = faultOf(session); !fault.empty())
    throw std::runtime_error(fault + ": save the session again");
  return session;
}

void writeSession(const std::string& path, const Session& session) {
  writeFileAtomically(path, bytesOf(session));
}

Session readSession(const std::string& path) {
  const auto bytes = readInputFile(path, "the session");
  try {
    return sessionOf(bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("cannot use the session " + path + ": " + error.what());
  }
}

}  // namespace slam::graph_slam
