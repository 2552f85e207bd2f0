// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "slam_ros/command_line.hpp"

namespace slam_ros {
namespace {

struct Answer {
  int code = 0;
  std::string out, errors;
};

/// A program with an argument of each type.
class Program : public testing::Test {
 protected:
  Program() {
    line_.add("FILE", file_, "a file").required();
    line_.add("--rate", rate_, "of a sensor [Hz]").positive().withDefault();
    line_.add("--delay", delay_).nonNegative();
    line_.add("--rows", rows_).between(2, 100);
    line_.add("--seed", seed_);
    line_.add("--limit", limit_);
    line_.add("--set", overrides_);
    line_.add("--only", streams_).separatedBy(',');
    const auto wheels = line_.add("--wheels", has_wheels_);
    const auto laser = line_.add("--laser", laser_).excludes(wheels);
    line_.add("--mount", mount_).existingFile().needs(laser);
  }

  template <class Function>
  Answer run(std::vector<std::string> words, Function function) {
    words.insert(words.begin(), "program");
    std::vector<char*> pointers;
    for (auto& word : words) pointers.push_back(word.data());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Answer answer;
    answer.code = line_.run(static_cast<int>(pointers.size()), pointers.data(), function);
    answer.out = testing::internal::GetCapturedStdout();
    answer.errors = testing::internal::GetCapturedStderr();
    return answer;
  }
  Answer run(const std::vector<std::string>& words) {
    return run(words, [] {});
  }

  /// Checks that words after the file are refused with this sentence, and nothing is run.
  void expectRefusal(std::vector<std::string> words, const std::string& sentence) {
    words.insert(words.begin(), "a.bag");
    const auto answer = run(words, [] { ADD_FAILURE() << "it has run"; });
    EXPECT_EQ(answer.code, 2) << sentence;
    EXPECT_EQ(answer.errors, "slam_program: " + sentence + "; --help lists the options\n");
  }

  CommandLine line_{"slam_program", "Does what a test asks of it."};
  std::string file_, laser_, mount_;
  double rate_ = 10.0;
  std::optional<double> delay_;
  int rows_ = 10;
  std::uint64_t seed_ = 1;
  std::optional<std::uint64_t> limit_;
  std::vector<std::string> overrides_, streams_;
  bool has_wheels_ = false;
};

TEST_F(Program, WritesWhatIsGivenAndKeepsTheRest) {
  ASSERT_EQ(run({"a.bag", "--rate", "2.5", "--set", "a.b=1", "--set", "c.d=2", "--only",
                 "odom,scan", "--wheels", "--seed=18446744073709551615", "--delay", "0"})
                .code,
            0);
  EXPECT_EQ(file_, "a.bag");
  EXPECT_EQ(rate_, 2.5);
  EXPECT_EQ(overrides_, (std::vector<std::string>{"a.b=1", "c.d=2"}));
  EXPECT_EQ(streams_, (std::vector<std::string>{"odom", "scan"}));
  EXPECT_TRUE(has_wheels_);
  EXPECT_EQ(seed_, UINT64_MAX);
  EXPECT_EQ(delay_, 0.0);
  EXPECT_EQ(rows_, 10);
  EXPECT_FALSE(limit_);
}

TEST_F(Program, RefusesWrongUseInOneSentence) {
  EXPECT_EQ(run({}).errors, "slam_program: FILE is required; --help lists the options\n");
  expectRefusal({"--rat", "3"}, "there is no option --rat (did you mean '--rate'?)");
  expectRefusal({"--colour=red"}, "there is no option --colour");
  expectRefusal({"b.bag"}, "The following argument was not expected: b.bag");
  expectRefusal({"--rate", "0"}, "--rate: '0' is no number above 0");
  expectRefusal({"--rate", "inf"}, "--rate: 'inf' is no number above 0");
  expectRefusal({"--rate", "nan"}, "--rate: 'nan' is no number above 0");
  expectRefusal({"--delay", "-1"}, "--delay: '-1' is no number of at least 0");
  expectRefusal({"--rows", "1"}, "--rows: '1' is no number from 2 to 100");
  expectRefusal({"--rows", "2.5"}, "Could not convert: --rows = 2.5");
  expectRefusal({"--seed", "-1"}, "--seed: '-1' is below 0");
  expectRefusal({"--limit", "-1"}, "--limit: '-1' is below 0");
  expectRefusal({"--wheels", "--laser", "front"}, "--wheels excludes --laser");
  expectRefusal({"--mount", __FILE__}, "--mount requires --laser");
  expectRefusal({"--laser", "front", "--mount", "/none"}, "--mount: File does not exist: /none");
}

TEST_F(Program, ReportsWhatIsThrownWithItsExitCode) {
  const auto failed = run({"a.bag"}, [] { throw std::runtime_error("the disk is full"); });
  EXPECT_EQ(failed.code, 1);
  EXPECT_EQ(failed.errors, "slam_program: the disk is full\n");
  const auto wrong = run({"a.bag"}, [] { throw WrongUse("there is no bag"); });
  EXPECT_EQ(wrong.code, 2);
  EXPECT_EQ(wrong.errors, "slam_program: there is no bag\n");
  EXPECT_EQ(run({"a.bag"}, [] { return 130; }).code, 130);
}

TEST_F(Program, HelpNamesArgumentsWithTypesLimitsAndDefaults) {
  const auto help = run({"--help"}, [] { ADD_FAILURE() << "it has run"; });
  EXPECT_EQ(help.code, 0);
  EXPECT_EQ(help.errors, "");
  for (const auto* part : {"Does what a test asks of it.", "Usage: slam_program [OPTIONS] FILE",
                           "FLOAT:POSITIVE=10", "INT:INT in [2 - 100]"})
    EXPECT_NE(help.out.find(part), std::string::npos) << part << " in: " << help.out;
}

TEST_F(Program, RunsOneOfItsCommands) {
  CommandLine tool("slam_tool", "Has commands.");
  CommandLine import("import", "Reads a log."), show("show", "Shows a bag.");
  std::string log;
  import.add("LOG", log).required();
  tool.addCommand(import);
  tool.addCommand(show);
  line_ = tool;
  EXPECT_EQ(run({"import", "a.log"}).code, 0);
  EXPECT_EQ(log, "a.log");
  EXPECT_TRUE(import.isChosen());
  EXPECT_FALSE(show.isChosen());
  EXPECT_EQ(run({}).errors, "slam_tool: A subcommand is required; --help lists the options\n");
  EXPECT_EQ(run({"improt", "a.log"}).errors,
            "slam_tool: there is no command 'improt' (did you mean 'import'?); the commands are: "
            "import, show\n");
  EXPECT_EQ(run({"import", "a.log", "--logg"}).errors,
            "slam_tool: there is no option --logg; --help lists the options\n");
  EXPECT_EQ(run({"import", "a.log", "--hepl"}).errors,
            "slam_tool: there is no option --hepl (did you mean '--help'?); --help lists the "
            "options\n");
}

}  // namespace
}  // namespace slam_ros
