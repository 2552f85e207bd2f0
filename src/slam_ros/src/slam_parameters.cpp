// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/nearest_name.hpp"
#include "slam_core/common/parameter_table.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_ros/command_line.hpp"
#include "slam_ros/parameter_check.hpp"

namespace {

constexpr const char* kTopLevel = "top";
constexpr const char* kHead =
    "# Parameters\n\n"
    "What a product file and a robot file may hold. `{0}` prints this page from the\n"
    "descriptions that also check the files; `{0} SECTION` prints a part of it. A value\n"
    "is set in the file, or for one run by `--set section.key=value` (roslaunch: `set:=`).\n";

/// The command that people call: the front door of a clone or of Debian packages where it has
/// called this program, else rosrun.
std::string calledAs() {
  const char* front_door = std::getenv("SLAM_COMMAND");
  return front_door == nullptr ? "rosrun slam_ros slam_parameters"
                               : std::string(front_door) + " parameters";
}

/// The page's sections: a table by the section's name, the top level first.
std::map<std::string, std::string> sections() {
  std::map<std::string, std::string> tables;
  const auto add = [&](const std::string& name, const slam::Fields& fields) {
    const auto title = name.empty() ? "Top level" : "Section `" + name + "`";
    tables[name] = fmt::format("## {}\n\nFile: {}.\n\n{}", title, slam::filesOf(fields),
                               slam::parameterTable(fields));
  };
  const auto& known = slam::KnownSections::instance();
  slam_ros::visitSharedSections([&](auto config) { known.visitSection<decltype(config)>(add); });
  known.visit(add);
  return tables;
}

std::vector<std::string> names(const std::map<std::string, std::string>& tables) {
  std::vector<std::string> names;
  for (const auto& entry : tables) names.push_back(entry.first.empty() ? kTopLevel : entry.first);
  return names;
}

/// @throw slam_ros::WrongUse
void print(const std::string& section) {
  const auto tables = sections();
  if (section.empty()) {
    fmt::print(kHead, calledAs());
    for (const auto& entry : tables) fmt::print("\n{}", entry.second);
    return;
  }
  const auto found = tables.find(section == kTopLevel ? "" : section);
  if (found == tables.end())
    throw slam_ros::WrongUse("there is no section '" + section + "'" +
                             slam::didYouMean(section, names(tables)) +
                             "; there are: " + slam::join(names(tables)));
  fmt::print("{}", found->second);
}

/// What is to be checked instead of printed.
struct Check {
  std::string file, robot;
  std::vector<std::string> overrides, parameters;

  bool isAsked() const {
    return !(file.empty() && robot.empty() && overrides.empty() && parameters.empty());
  }
  void run() const {
    if (!file.empty() || !overrides.empty()) slam_ros::checkProductFile(file, overrides);
    if (!robot.empty()) slam_ros::checkRobotFile(robot);
    if (!parameters.empty()) slam_ros::checkProductParameters(parameters);
  }
};

void addOptions(slam_ros::CommandLine& line, Check& check) {
  line.add("--check", check.file, "prints nothing and checks the parameters of this product file");
  line.add("--check-robot", check.robot, "the same of this robot file");
  line.add("--set", check.overrides, "also checks section.key=value, as slam_offline takes it");
  line.add("--product-parameter", check.parameters,
           "checks section.key=value that a product file is to hold");
}

}  // namespace

int main(int argc, char** argv) {
  slam_ros::CommandLine line(
      "slam_parameters", "Prints the parameters of product and robot files as tables in Markdown.");
  std::string section;
  std::vector<std::string> libraries;
  Check check;
  line.add("SECTION", section, std::string("only this one; ") + kTopLevel + ": the top level");
  line.add("--library", libraries, "also of the components in this shared library").oneAtATime();
  addOptions(line, check);
  return line.run(argc, argv, [&] {
    slam::loadLibraries(libraries);
    if (!check.isAsked()) return print(section);
    check.run();
  });
}
