// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <thread>

#include "part_program.hpp"
#include "pipe_output.hpp"

namespace slam_pipes {
namespace {

/// Two pipes into a process, and who writes into them.
class TurnInputsOfTwo : public testing::Test {
 protected:
  TurnInputsOfTwo() {
    inputs_.add({first_.read_end.number(), "the first"});
    inputs_.add({second_.read_end.number(), "the second"});
  }

  static Frame datum(const std::string& value) {
    return {Frame::Type::kDatum, "port", "kind", value};
  }
  static Frame mark(Frame::Type type) { return {type, "", "", ""}; }
  static std::string valuesOf(const TurnInputs::Turn& turn) {
    std::string all;
    for (const auto& frame : turn.data) all += frame.value;
    return all;
  }
  std::string faultOfNext() {
    try {
      inputs_.next();
    } catch (const std::runtime_error& fault) {
      return fault.what();
    }
    return "";
  }

  Pipe first_ = makePipe(), second_ = makePipe();
  PipeOutput to_first_{first_.write_end.number(), "the test"},
      to_second_{second_.write_end.number(), "the test"};
  TurnInputs inputs_;
};

TEST_F(TurnInputsOfTwo, GoByTheOrderOfThePipesNotOfArrival) {
  to_second_.put(datum("c"));
  to_second_.put(mark(Frame::Type::kTurn));
  to_second_.put(datum("z"));
  to_first_.put(datum("a"));
  to_first_.put(datum("b"));
  to_first_.put(mark(Frame::Type::kTurn));
  EXPECT_EQ(valuesOf(inputs_.next()), "abc");
  to_second_.put(mark(Frame::Type::kEnd));
  to_first_.put(datum("y"));
  to_first_.put(mark(Frame::Type::kEnd));
  const auto last = inputs_.next();
  EXPECT_EQ(valuesOf(last), "yz");
  EXPECT_EQ(last.mark, Frame::Type::kEnd);
}

TEST_F(TurnInputsOfTwo, ReadWhatIsLargerThanAPipeInWhateverOrderItIsWritten) {
  const std::string large(1U << 20U, 'x');
  std::thread writer([&] {  // the first pipe's mark comes only when the second one's data are read
    to_second_.put(datum(large));
    to_second_.put(mark(Frame::Type::kTurn));
    to_first_.put(datum(large));
    to_first_.put(mark(Frame::Type::kTurn));
  });
  EXPECT_EQ(valuesOf(inputs_.next()).size(), 2 * large.size());
  writer.join();
}

TEST_F(TurnInputsOfTwo, SayWhoIsGone) {
  to_first_.put(mark(Frame::Type::kTurn));
  second_.write_end.close();
  EXPECT_EQ(faultOfNext(),
            "the pipe from the second was closed before the end of its data: start the run again");
}

TEST_F(TurnInputsOfTwo, SayWhichPipeIsCutWithinAFrame) {
  FrameEncoder encoder;
  const auto bytes = encoder.bytesOf(datum("value"));
  slam::writeAll(first_.write_end.number(), bytes.data(), bytes.size() - 1);
  first_.write_end.close();
  EXPECT_EQ(faultOfNext(), "the pipe from the first ends within a frame: start the run again");
}

TEST_F(TurnInputsOfTwo, SayWhichPipeCannotBeRead) {
  slam::writeAll(first_.write_end.number(), "what is this, no frames?", 24);
  EXPECT_EQ(faultOfNext(),
            "the pipe from the first cannot be read: what comes is no port data: have slam_pipes "
            "start both of its ends");
}

TEST_F(TurnInputsOfTwo, RefuseTurnsThatDiffer) {
  to_first_.put(mark(Frame::Type::kTurn));
  to_second_.put(mark(Frame::Type::kStep));
  EXPECT_EQ(faultOfNext(),
            "the pipes from the first and from the second are out of step: start the run again");
}

}  // namespace
}  // namespace slam_pipes
