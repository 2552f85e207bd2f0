// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <type_traits>

#include "slam_ros/wrong_use.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace slam_ros {

/// An argument of a command line. Its functions restrict the argument, and return it again; a copy
/// refers to the same argument. A refused value ends the program with the exit code 2.
class Argument {
 public:
  explicit Argument(CLI::Option& option) : option_(&option) {}

  Argument required() const;
  /// Lets --help show the value that the variable has at this call.
  Argument withDefault() const;

  Argument positive() const;     ///< a finite number above 0
  Argument nonNegative() const;  ///< a finite number of at least 0
  Argument between(double least, double most) const;
  Argument existingFile() const;

  /// Cannot be used together with another argument.
  Argument excludes(const Argument& other) const;
  /// Can be used only together with another argument.
  Argument needs(const Argument& other) const;

  /// A list with one value each time that the option is given, so that a positional argument may
  /// follow.
  Argument oneAtATime() const;
  /// A list of several values in one word, separated by this letter.
  Argument separatedBy(char delimiter) const;

 private:
  CLI::Option* option_;
};

/// The command line of a program: add its arguments, then call run().
///
/// It uses CLI11, which is compiled here once, since compiling its headers takes longer than
/// compiling the program itself.
class CommandLine {
 public:
  CommandLine(const std::string& name, const std::string& description);

  /// Adds an argument that is written into a variable. The variable keeps its value if the argument
  /// is not given, and outlives run().
  /// @param name "--option"; for a positional argument its name in --help
  /// @param value bool (an option without a value), int, unsigned, std::uint64_t, double,
  ///   std::string, std::vector<std::string>, and std::optional of
  ///   int, std::uint64_t and double
  template <class T>
  Argument add(const std::string& name, T& value, const std::string& help = "");

  /// Adds a command with its own arguments. Exactly one of the commands of a program has to be
  /// given.
  /// @param kind what its commands are for a user, in the singular
  void addCommand(const CommandLine& command, const std::string& kind = "command");
  /// Whether this command was given.
  bool isChosen() const;

  /// Reads the command line and calls a function; what they throw is reported on standard error in
  /// one sentence that begins with the program's name.
  /// @param function returns nothing or the exit code
  /// @return the program's exit code: 0, 1 if it failed, 2 for wrong use (WrongUse)
  template <class Function>
  int run(int argc, char** argv, Function function) const {
    if constexpr (std::is_void_v<std::invoke_result_t<Function>>)
      return runForCode(argc, argv, [&] { return function(), 0; });
    else
      return runForCode(argc, argv, function);
  }

 private:
  int runForCode(int argc, char** argv, const std::function<int()>& function) const;

  std::shared_ptr<CLI::App> app_;
};

}  // namespace slam_ros
