// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <exception>
#include <iostream>
#include <optional>
#include <vector>

#include "slam_core/common/nearest_name.hpp"

namespace slam_ros {

namespace {

constexpr int kFailed = 1, kWrongUse = 2;

std::string missingCommand(const CLI::App& app, const std::string& word) {
  const auto commands = app.get_subcommands({});
  std::vector<std::string> names;
  for (const auto* command : commands) names.push_back(command->get_name());
  const std::string kind = commands.front()->get_group();
  return "there is no " + kind + " '" + word + "'" + slam::didYouMean(word, names) + "; the " +
         kind + "s are: " + slam::join(names);
}

/// One sentence for a command line that cannot be read: an option that does not exist is named with
/// the one that was meant, not with the words that followed from it.
std::string sentenceOf(const CLI::App& app, const CLI::ParseError& error) {
  constexpr const char* kHint = "; --help lists the options";
  if (const auto chosen = app.get_subcommands(); !chosen.empty())
    return sentenceOf(*chosen.front(), error);
  std::vector<std::string> names;
  for (const auto* option : app.get_options()) names.push_back(option->get_name());
  for (const auto& extra : app.remaining()) {
    const auto option = extra.substr(0, extra.find('='));
    if (option.rfind("--", 0) == 0)
      return "there is no option " + option + slam::didYouMean(option, names) + kHint;
    if (!app.get_subcommands({}).empty()) return missingCommand(app, extra);
  }
  return error.what() + std::string(kHint);
}

/// Refuses what is no finite number, or not one of those that are meant.
template <class IsMeant>
CLI::Validator numbers(const std::string& name, const std::string& meant, IsMeant isMeant) {
  const auto faultOf = [meant, isMeant](const std::string& text) -> std::string {
    double number = 0.0;
    const bool is_number = CLI::detail::lexical_cast(text, number) && std::isfinite(number);
    return is_number && isMeant(number) ? "" : "'" + text + "' is no number " + meant;
  };
  return {faultOf, name, ""};
}

/// CLI11 would make a large number of one with a sign.
std::string faultOfSign(const std::string& text) {
  return text.empty() || text[0] != '-' ? "" : "'" + text + "' is below 0";
}

}  // namespace

Argument Argument::required() const {
  option_->required();
  return *this;
}

Argument Argument::withDefault() const {
  option_->capture_default_str();
  return *this;
}

Argument Argument::positive() const {
  option_->check(numbers("POSITIVE", "above 0", [](double number) { return number > 0.0; }));
  return *this;
}

Argument Argument::nonNegative() const {
  option_->check(
      numbers("NONNEGATIVE", "of at least 0", [](double number) { return number >= 0.0; }));
  return *this;
}

Argument Argument::between(double least, double most) const {
  const auto name = fmt::format("{} in [{} - {}]", option_->get_type_name(), least, most);
  option_->check(numbers(name, fmt::format("from {} to {}", least, most),
                         [=](double number) { return number >= least && number <= most; }));
  return *this;
}

Argument Argument::existingFile() const {
  option_->check(CLI::ExistingFile);
  return *this;
}

Argument Argument::excludes(const Argument& other) const {
  option_->excludes(other.option_);
  return *this;
}

Argument Argument::needs(const Argument& other) const {
  option_->needs(other.option_);
  return *this;
}

Argument Argument::oneAtATime() const {
  option_->allow_extra_args(false);
  return *this;
}

Argument Argument::separatedBy(char delimiter) const {
  option_->delimiter(delimiter);
  return *this;
}

CommandLine::CommandLine(const std::string& name, const std::string& description)
    : app_(std::make_shared<CLI::App>(description, name)) {}

template <class T>
Argument CommandLine::add(const std::string& name, T& value, const std::string& help) {
  if constexpr (std::is_same_v<T, bool>) {
    return Argument(*app_->add_flag(name, value, help));
  } else {
    auto* option = app_->add_option(name, value, help);
    constexpr bool kIsUnsigned =
        std::is_unsigned_v<T> || std::is_same_v<T, std::optional<std::uint64_t>>;
    if constexpr (kIsUnsigned) option->check(faultOfSign, "");
    return Argument(*option);
  }
}

template Argument CommandLine::add(const std::string&, bool&, const std::string&);
template Argument CommandLine::add(const std::string&, int&, const std::string&);
template Argument CommandLine::add(const std::string&, unsigned&, const std::string&);
template Argument CommandLine::add(const std::string&, std::uint64_t&, const std::string&);
template Argument CommandLine::add(const std::string&, double&, const std::string&);
template Argument CommandLine::add(const std::string&, std::string&, const std::string&);
template Argument CommandLine::add(const std::string&, std::vector<std::string>&,
                                   const std::string&);
template Argument CommandLine::add(const std::string&, std::optional<int>&, const std::string&);
template Argument CommandLine::add(const std::string&, std::optional<std::uint64_t>&,
                                   const std::string&);
template Argument CommandLine::add(const std::string&, std::optional<double>&, const std::string&);

void CommandLine::addCommand(const CommandLine& command, const std::string& kind) {
  app_->add_subcommand(command.app_)->group(kind);
  app_->require_subcommand(1);
}

bool CommandLine::isChosen() const { return app_->parsed(); }

int CommandLine::runForCode(int argc, char** argv, const std::function<int()>& function) const {
  const auto fail = [&](const std::string& sentence, int code) {
    std::cerr << app_->get_name() << ": " << sentence << std::endl;
    return code;
  };
  try {
    app_->parse(argc, argv);
    return function();
  } catch (const CLI::CallForHelp& help) {
    return app_->exit(help);
  } catch (const CLI::ParseError& error) {
    return fail(sentenceOf(*app_, error), kWrongUse);
  } catch (const WrongUse& error) {
    return fail(error.what(), kWrongUse);
  } catch (const std::exception& error) {
    return fail(error.what(), kFailed);
  }
}

}  // namespace slam_ros
