// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "part_ports.hpp"
#include "part_report.hpp"
#include "pipe_output.hpp"
#include "slam_core/product/run_writer.hpp"

namespace slam_pipes {

/// The process of a component is started with these options.
struct PartOptions {
  /// A part of the product, or "bag", and the descriptor of the pipe from it or to it.
  using Pipe = std::pair<std::string, int>;

  std::string product, robot;  ///< files
  std::vector<std::string> overrides;
  std::string part;  ///< PartPorts::key
  std::vector<Pipe> from, to;
  std::optional<int> status;         ///< the pipe that takes reports; without one: standard error
  std::string folder;                ///< of the run, which the back-end writes
  std::vector<std::string> without;  ///< the back-end's inputs that no data come to
};

/// A component in a process of its own: takes in what comes by pipes and writes what it makes into
/// pipes. Here is no ROS, and the component sees the same ports as everywhere.
///
/// Without a pipe for reports the run is complete when the data have come to their end.
class PartProcess {
 public:
  /// @throw slam::ConfigError
  explicit PartProcess(PartOptions options);

  /// To the end of the data. @throw PipeClosed where another process has ended;
  /// std::runtime_error with a sentence
  void run();
  /// Reports the sentence that this process ends with.
  void fail(const std::string& sentence);

 private:
  void configure();
  void connectInputs(const std::vector<PartPorts>& parts);
  void connectOutput(const PartOptions::Pipe& pipe, const PartPorts& taker);
  void take(const Frame& frame);
  void step();
  void stepEstimator();
  void warn(const slam::Status& status);
  template <class T>
  void report(const char* port, const T& value);
  PartSummary summary() const;
  void finish();
  void write(const Finish& finish);

  PartOptions options_;
  slam::Settings settings_;
  slam::ProductComponents components_;
  slam::Wiring wiring_;
  std::string title_;
  std::vector<slam::InputPort> inputs_;
  TurnInputs turns_;
  std::deque<PipeOutput> outputs_;  // a deque: they are referred to
  std::optional<PipeOutput> status_;
  std::optional<slam::RunWriter> writer_;  ///< of the back-end
};

}  // namespace slam_pipes
