// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/tuning/robot_file_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace slam::tuning {
namespace {

using Lines = std::vector<std::string>;

Lines linesOf(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool begins(const std::string& line, const std::string& with) { return line.rfind(with, 0) == 0; }

bool isKey(const std::string& line) {
  return !line.empty() && line[0] != ' ' && line[0] != '#' && line.find(':') != std::string::npos;
}

/// The lines of a section's block: from the one after its name to the next key of the top level.
struct Block {
  std::size_t begin = 0, end = 0;
};

Block blockOf(Lines& lines, const std::string& section) {
  auto head = std::find_if(lines.begin(), lines.end(),
                           [&](const auto& line) { return begins(line, section + ":"); });
  if (head == lines.end()) {
    lines.push_back("");
    lines.push_back(section + ":");
    head = lines.end() - 1;
  }
  const auto begin = head + 1;
  auto end = std::find_if(begin, lines.end(), isKey);
  // A comment above the next section belongs to that.
  while (end != begin && (end[-1].empty() || end[-1][0] == '#')) --end;
  return {static_cast<std::size_t>(begin - lines.begin()),
          static_cast<std::size_t>(end - lines.begin())};
}

void put(Lines& lines, const TunedParameter& parameter) {
  const auto block = blockOf(lines, parameter.section);
  const std::string entry = fmt::format("  {}: {:.3g}", parameter.key, parameter.value);
  for (std::size_t i = block.begin; i < block.end; ++i) {
    if (!begins(lines[i], "  " + parameter.key + ":")) continue;
    const auto comment = lines[i].find('#');
    const auto rest = comment == std::string::npos ? "" : lines[i].substr(comment);
    lines[i] = rest.empty() ? entry : fmt::format("{:<{}}{}", entry, comment, rest);
    if (!rest.empty() && entry.size() >= comment) lines[i] = entry + "  " + rest;
    return;
  }
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(block.end), entry);
}

}  // namespace

std::string withTunedValues(const std::string& text, const std::vector<TunedParameter>& parameters,
                            const std::string& remark) {
  Lines lines = linesOf(text);
  for (const auto& parameter : parameters)
    if (parameter.why_unseen.empty()) put(lines, parameter);
  Lines comment;
  for (const auto& line : linesOf(remark)) comment.push_back(line.empty() ? "#" : "# " + line);
  lines.insert(std::find_if(lines.begin(), lines.end(), isKey), comment.begin(), comment.end());
  std::string result;
  for (const auto& line : lines) result += line + "\n";
  return result;
}

}  // namespace slam::tuning
