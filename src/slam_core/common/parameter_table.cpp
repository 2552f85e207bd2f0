// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/parameter_table.hpp"

#include <set>
#include <vector>

#include "slam_core/common/nearest_name.hpp"

namespace slam {
namespace {

std::string fileOf(const Field& field) {
  return field.scope == Scope::kRobot ? "robot" : "product";
}

std::string code(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

/// A vertical bar would end the cell.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, "\\");
  return text;
}

std::string allowed(const Field& field) {
  if (!field.choices.empty()) {
    std::vector<std::string> names;
    for (const auto& choice : field.choices) names.push_back(code(choice));
    return join(names);
  }
  return field.range.isEverything() ? "" : field.range.text();
}

std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const auto& text : cells) line += (text.empty() ? " |" : " " + text + " |");
  return line + "\n";
}

}  // namespace

std::string filesOf(const Fields& fields) {
  std::set<std::string> files;  // in the order of their names
  for (const auto& field : fields.all()) files.insert(fileOf(field));
  return join({files.begin(), files.end()});
}

std::string parameterTable(const Fields& fields) {
  const bool both = filesOf(fields).find(',') != std::string::npos;
  std::vector<std::string> head = {"name", "default", "unit", "type", "allowed", "meaning"};
  if (both) head.insert(head.begin() + 1, "file");
  std::string table = row(head) + row(std::vector<std::string>(head.size(), "---"));
  for (const auto& field : fields.all()) {
    std::vector<std::string> cells = {code(field.name), code(field.valueText()),
                                      field.unit_text,  field.typeName(),
                                      allowed(field),   cell(field.sentence)};
    if (both) cells.insert(cells.begin() + 1, fileOf(field));
    table += row(cells);
  }
  return table;
}

}  // namespace slam
