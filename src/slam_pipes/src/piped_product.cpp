// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "piped_product.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <map>

#include "exit_code.hpp"

namespace slam_pipes {
namespace {

constexpr std::chrono::seconds kGrace(5);  ///< for a process to end by itself

/// The arguments of a process and the descriptors that it gets.
struct Call {
  std::vector<std::string> words;
  std::vector<int> descriptors;
  std::vector<Descriptor> ends;  ///< its own ends of the pipes

  void add(const std::string& option, const std::string& value) {
    words.insert(words.end(), {option, value});
  }
  void addPipe(const std::string& option, const std::string& name, Descriptor end) {
    add(option, (name.empty() ? "" : name + "=") + std::to_string(end.number()));
    descriptors.push_back(end.number());
    ends.push_back(std::move(end));
  }
};

Call callOf(const PartPorts& part, const ProcessOptions& options) {
  Call call{{options.program, options.product, options.robot, "--part", part.key}, {}, {}};
  for (const auto& entry : options.overrides) call.add("--set", entry);
  if (!part.isBackend()) return call;
  call.add("--out", options.folder);
  for (const auto& input : options.without) call.add("--without", input);
  return call;
}

/// A pipe for each two parts of which one takes what the other makes.
void join(const std::vector<PartPorts>& parts, std::vector<Call>& calls) {
  for (std::size_t maker = 0; maker < parts.size(); ++maker)
    for (std::size_t taker = 0; taker < parts.size(); ++taker) {
      if (maker == taker || parts[maker].inputsOf(parts[taker]).empty()) continue;
      auto pipe = makePipe();
      calls[maker].addPipe("--to", parts[taker].key, std::move(pipe.write_end));
      calls[taker].addPipe("--from", parts[maker].key, std::move(pipe.read_end));
    }
}

}  // namespace

PipedProduct::PipedProduct(const std::vector<PartPorts>& parts, const ProcessOptions& options,
                           Listeners listeners)
    : parts_(parts), listeners_(std::move(listeners)) {
  start(options);
}

void PipedProduct::start(const ProcessOptions& options) {
  std::vector<Call> calls;
  for (const auto& part : parts_) calls.push_back(callOf(part, options));
  join(parts_, calls);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    auto input = makePipe(), status = makePipe();
    ::fcntl(input.write_end.number(), F_SETFL, O_NONBLOCK);
    calls[i].addPipe("--from", "bag", std::move(input.read_end));
    calls[i].addPipe("--status", "", std::move(status.write_end));
    const int status_number = status.read_end.number();
    processes_.push_back({&parts_[i],
                          StartedProgram(calls[i].words, calls[i].descriptors),
                          std::move(input.write_end),
                          std::move(status.read_end),
                          PipeInput(status_number, "the " + parts_[i].title),
                          {},
                          "",
                          {}});
    calls[i].ends.clear();  // else a pipe would not end with the process
  }
}

void PipedProduct::put(const std::string& port, const slam::Datum& datum) {
  const auto kind = slam::nameOf(datum.kind());
  Frame frame{Frame::Type::kDatum, port, kind, ""};
  for (auto& process : processes_) {
    const auto* input = process.part->input(port, kind);
    if (input == nullptr) continue;
    if (frame.value.empty()) {
      slam::ArchiveWriter archive;
      input->traits.save(datum.value(), archive);
      frame.value = archive.take();
    }
    send(process, frame);
  }
  mark(Frame::Type::kTurn);
}

void PipedProduct::step() { mark(Frame::Type::kStep); }

std::vector<PartSummary> PipedProduct::end() {
  mark(Frame::Type::kEnd);
  std::vector<PartSummary> summaries;
  for (auto& process : processes_) {
    waitUntil(process, [&] { return process.summary.has_value(); });
    summaries.push_back(*process.summary);
  }
  return summaries;
}

void PipedProduct::finish(const Finish& finish) {
  for (auto& process : processes_)
    if (!process.part->isBackend()) this->finish(process, finish);
  for (auto& process : processes_)
    if (process.part->isBackend()) this->finish(process, finish);
}

void PipedProduct::finish(Process& process, const Finish& finish) {
  send(process, {Frame::Type::kDatum, report::kFinish, slam::nameOf(slam::kindOf<Finish>()),
                 bytesOf(finish)});
  waitUntil(process, [&] { return process.is_done; });
  if (const auto end = process.program.wait(); end.exit_code != kDone || end.signal != 0) fail();
}

void PipedProduct::mark(Frame::Type type) {
  for (auto& process : processes_) send(process, {type, "", "", ""});
}

/// Reports are heard meanwhile: a process that waits for room for one would read nothing.
void PipedProduct::send(Process& process, const Frame& frame) {
  const auto bytes = process.encoder.bytesOf(frame);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const auto count = ::write(process.input.number(), bytes.data() + done, bytes.size() - done);
    if (count >= 0)
      done += static_cast<std::size_t>(count);
    else if (errno == EAGAIN)
      pump(&process);
    else if (errno != EINTR)
      fail();
  }
}

template <class Done>
void PipedProduct::waitUntil(Process& process, Done done) {
  while (!done()) {
    if (process.is_closed) fail();
    pump(nullptr);
  }
}

/// Waits until there is a report, or room for what is written to a process.
void PipedProduct::pump(Process* writing) {
  std::vector<pollfd> polled;
  std::vector<Process*> heard;
  for (auto& process : processes_) {
    if (process.is_closed) continue;
    polled.push_back({process.status_end.number(), POLLIN, 0});
    heard.push_back(&process);
  }
  if (writing != nullptr) polled.push_back({writing->input.number(), POLLOUT, 0});
  if (::poll(polled.data(), polled.size(), -1) < 0) return;  // a signal
  for (std::size_t i = 0; i < heard.size(); ++i)
    if (polled[i].revents != 0) hear(*heard[i]);
}

void PipedProduct::hear(Process& process) {
  if (process.status.read()) {
    while (const auto frame = process.status.next()) take(process, *frame);
    return;
  }
  process.is_closed = true;
  if (!process.is_done) fail();
}

void PipedProduct::take(Process& process, const Frame& frame) {
  if (frame.type == Frame::Type::kEnd)
    process.is_done = true;
  else if (frame.port == report::kWarning)
    listeners_.warn(valueOf<slam::Status>(frame.value));
  else if (frame.port == report::kStep)
    listeners_.step(valueOf<StepDone>(frame.value));
  else if (frame.port == report::kSummary)
    process.summary = valueOf<PartSummary>(frame.value);
  else if (frame.port == report::kFault)
    process.fault = valueOf<std::string>(frame.value);
}

void PipedProduct::fail() {
  endAll();
  throw std::runtime_error(firstCause());
}

/// Each ends as its inputs do; what does not is killed.
void PipedProduct::endAll() {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + kGrace;
  for (auto& process : processes_) process.input.close();
  for (auto& process : processes_)
    while (!process.is_closed) {
      const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
      pollfd polled{process.status_end.number(), POLLIN, 0};
      const int ready = ::poll(&polled, 1, std::max(0, static_cast<int>(left.count())));
      if (ready < 0) continue;  // a signal
      if (ready == 0) {
        process.program.kill();
        break;
      }
      if (!process.status.read()) process.is_closed = true;
      while (const auto frame = process.status.next()) take(process, *frame);
    }
}

/// A signal comes first, then what a process says itself; that others had ended says least.
std::string PipedProduct::firstCause() {
  std::map<int, std::string> causes;  // by their rank
  for (auto& process : processes_) {
    const bool was_killed_here = !process.is_closed;
    const auto end = process.program.wait();
    const auto who = "the process of the " + process.part->title;
    if (end.signal != 0 && !was_killed_here)
      causes.emplace(0, who + " was ended by a signal (" + ::strsignal(end.signal) +
                            "): the run is not complete, start it again");
    else if (!process.fault.empty())
      causes.emplace(1, who + " has failed: " + process.fault);
    else if (end.exit_code != kDone && end.exit_code != kPipeClosed)
      causes.emplace(2, who + " has failed with exit code " + std::to_string(end.exit_code) +
                            ": its messages above say why");
    else if (was_killed_here)
      causes.emplace(3, who + " did not answer: the run is not complete, start it again");
    else if (end.exit_code == kPipeClosed)
      causes.emplace(4, who + " lost a pipe: the run is not complete, start it again");
  }
  if (causes.empty()) return "a process has ended too early: start the run again";
  return causes.begin()->second;
}

}  // namespace slam_pipes
