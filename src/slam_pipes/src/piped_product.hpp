// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "part_ports.hpp"
#include "part_program.hpp"
#include "part_report.hpp"
#include "turn_inputs.hpp"

namespace slam_pipes {

/// All processes of a product are started with these options.
struct ProcessOptions {
  std::string program;         ///< slam_part
  std::string product, robot;  ///< files
  std::vector<std::string> overrides;
  std::string folder;                ///< of the run
  std::vector<std::string> without;  ///< the back-end's inputs that no data come to
};

/// The components of a product, each in a process of its own, joined by pipes as their ports say:
/// data go from maker to taker without passing through this process. It feeds them with the data
/// from outside, turn by turn, and hears their reports.
///
/// Any fault ends all processes, and is thrown as one sentence that names the process which was the
/// first cause.
class PipedProduct {
 public:
  struct Listeners {
    std::function<void(const slam::Status&)> warn;
    std::function<void(const StepDone&)> step;
  };

  /// Starts the processes. @param parts those to start, whose inputs are persistent
  /// (requirePersistent) so far as data come to them; they outlive this
  /// @throw std::runtime_error
  PipedProduct(const std::vector<PartPorts>& parts, const ProcessOptions& options,
               Listeners listeners);

  /// A turn for a value from outside: it goes to all that take it in.
  void put(const std::string& port, const slam::Datum& datum);
  /// A turn in which all steps are taken that are due.
  void step();
  /// No more data come. @return what each process says at the end, in the order of the parts
  std::vector<PartSummary> end();
  /// The run is good: the processes write their files and end; the back-end is the last one.
  void finish(const Finish& finish);

 private:
  struct Process {
    const PartPorts* part;
    StartedProgram program;
    Descriptor input;
    Descriptor status_end;
    PipeInput status;
    FrameEncoder encoder;
    std::string fault;
    std::optional<PartSummary> summary;
    bool is_done = false;    ///< it has written its files
    bool is_closed = false;  ///< its reports have ended
  };

  void start(const ProcessOptions& options);
  void mark(Frame::Type type);
  void send(Process& process, const Frame& frame);
  void pump(Process* writing);
  void hear(Process& process);
  void take(Process& process, const Frame& report);
  void finish(Process& process, const Finish& finish);
  template <class Done>
  void waitUntil(Process& process, Done done);
  [[noreturn]] void fail();
  void endAll();
  std::string firstCause();

  const std::vector<PartPorts>& parts_;
  Listeners listeners_;
  std::deque<Process> processes_;
};

}  // namespace slam_pipes
