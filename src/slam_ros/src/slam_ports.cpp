// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <iostream>
#include <iterator>
#include <sstream>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_ros/command_line.hpp"
#include "slam_ros/product_files.hpp"
#include "slam_ros/product_ports.hpp"

namespace {

bool isFile(const std::vector<std::string>& words) {
  return words.size() == 1 && words[0].find('=') == std::string::npos;
}

slam::Settings settingsOf(const std::vector<std::string>& words) {
  if (!isFile(words)) return {{}, {}, words};
  return {slam::loadConfigFile(slam_ros::productFile(words[0])), {}, {}};
}

slam::ProductConfig productOf(const std::vector<std::string>& words) {
  auto settings = settingsOf(words);
  slam::ProductConfig product;
  slam::readProduct(settings, product);
  if (!isFile(words)) settings.requireAllRead();
  return product;
}

/// @throw std::exception with a sentence; also where the components cannot be joined
nlohmann::ordered_json portsOf(const std::vector<std::string>& words) {
  const auto product = productOf(words);
  slam_ros::checkPorts(product);
  return slam_ros::describePorts(product);
}

/// Answers each line of words with a line: loading the components takes longer than asking them.
void answerLines(std::istream& lines) {
  std::string answers;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream stream(line);
    const std::vector<std::string> words(std::istream_iterator<std::string>(stream), {});
    answers += portsOf(words).dump() + "\n";
  }
  std::cout << answers << std::flush;
}

void print(const nlohmann::ordered_json& answer) { std::cout << answer.dump(2) << std::endl; }

}  // namespace

int main(int argc, char** argv) {
  slam_ros::CommandLine line(
      "slam_ports",
      "Prints as JSON what a product's components take in and make, and who makes it.");
  std::vector<std::string> words, libraries;
  bool check = false, components = false;
  const auto product =
      line.add("PRODUCT", words,
               "a product's name, its file, or features as KEY=VALUE; -: a line of "
               "them for each product on the standard input, answered by a line each");
  line.add("--library", libraries, "also knows the components in this shared library").oneAtATime();
  line.add("--check", check,
           "prints nothing and refuses components that cannot be joined by their ports");
  line.add("--components", components,
           "prints the names of all components by the product's key instead")
      .excludes(product);
  return line.run(argc, argv, [&] {
    slam::loadLibraries(libraries);
    if (components) return print(slam_ros::describeComponents());
    if (words.empty()) throw slam_ros::WrongUse("PRODUCT is required; --help lists the options");
    if (words == std::vector<std::string>{"-"}) return answerLines(std::cin);
    const auto ports = portsOf(words);
    if (!check) print(ports);
  });
}
