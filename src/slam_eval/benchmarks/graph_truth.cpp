// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "graph_truth.hpp"

#include <algorithm>
#include <map>

#include "import_error.hpp"
#include "text_table.hpp"

namespace slam::eval {
namespace {

using PoseById = std::map<std::int64_t, Pose2>;

/// Of rows x y theta, one for each id.
PoseById byOrder(const std::string& path, const std::vector<TextRow>& rows,
                 std::vector<std::int64_t> ids) {
  if (rows.size() != ids.size())
    throw ImportError(path + " holds " + std::to_string(rows.size()) + " poses, but the graph " +
                      std::to_string(ids.size()) + "; give the truth of this graph");
  std::sort(ids.begin(), ids.end());
  PoseById poses;
  for (std::size_t i = 0; i < ids.size(); ++i)
    poses[ids[i]] = {rows[i].number(0), rows[i].number(1), rows[i].number(2)};
  return poses;
}

/// Of rows id x y theta.
PoseById byName(const std::vector<TextRow>& rows) {
  PoseById poses;
  for (const auto& row : rows) {
    const Pose2 pose(row.number(1), row.number(2), row.number(3));
    if (!poses.emplace(row.integer(0), pose).second)
      throw ImportError(row.place() + ": the pose " + row.text(0) +
                        " stands there twice; remove one of the lines");
  }
  return poses;
}

}  // namespace

std::vector<Pose2> readGraphTruth(const std::string& path, const std::vector<std::int64_t>& ids) {
  const std::size_t columns = readRows(path, '#').front().size() == 3 ? 3 : 4;
  const auto rows = readTable(path, columns, '#');
  const auto poses = columns == 3 ? byOrder(path, rows, ids) : byName(rows);
  std::vector<Pose2> truth;
  for (const auto id : ids) {
    const auto pose = poses.find(id);
    if (pose == poses.end())
      throw ImportError(path + " has no true pose " + std::to_string(id) +
                        "; give the truth of this graph");
    truth.push_back(pose->second);
  }
  return truth;
}

}  // namespace slam::eval
