// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "turn_inputs.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iterator>

namespace slam_pipes {

bool PipeInput::read() {
  constexpr std::size_t kPiece = 1U << 16U;  // [B], as much as a pipe holds
  std::array<char, kPiece> piece;
  ssize_t count = 0;
  do {
    count = ::read(descriptor_, piece.data(), piece.size());
  } while (count < 0 && errno == EINTR);
  if (count <= 0) return false;
  decoder_.append(piece.data(), static_cast<std::size_t>(count));
  return true;
}

std::optional<Frame> PipeInput::next() {
  try {
    return decoder_.next();
  } catch (const std::runtime_error& fault) {
    throw std::runtime_error("the pipe from " + maker_ + " cannot be read: " + fault.what());
  }
}

Frame PipeInput::waitForNext() {
  while (true) {
    if (auto frame = next()) return std::move(*frame);
    if (!read()) failAtEnd();
  }
}

void PipeInput::failAtEnd() const {
  if (decoder_.isWithinFrame())
    throw std::runtime_error("the pipe from " + maker_ +
                             " ends within a frame: start the run again");
  throw PipeClosed("the pipe from " + maker_ +
                   " was closed before the end of its data: start the run again");
}

TurnInputs::Turn TurnInputs::next() {
  const auto is_complete = [](const Pipe& pipe) { return pipe.mark.has_value(); };
  for (auto& pipe : pipes_) takeTurn(pipe);
  while (!std::all_of(pipes_.begin(), pipes_.end(), is_complete)) readSome();
  Turn turn;
  turn.mark = *pipes_.front().mark;
  for (auto& pipe : pipes_) {
    if (pipe.mark != turn.mark)
      throw std::runtime_error("the pipes from " + pipes_.front().input.maker() + " and from " +
                               pipe.input.maker() + " are out of step: start the run again");
    std::move(pipe.data.begin(), pipe.data.end(), std::back_inserter(turn.data));
    pipe.data.clear();
    pipe.mark.reset();
  }
  return turn;
}

Frame TurnInputs::behindEnd(const std::string& maker) {
  for (auto& pipe : pipes_)
    if (pipe.input.maker() == maker) return pipe.input.waitForNext();
  throw PipeClosed("there is no pipe from " + maker);
}

/// Takes the frames of this turn that have been read already.
void TurnInputs::takeTurn(Pipe& pipe) {
  while (!pipe.mark) {
    auto frame = pipe.input.next();
    if (!frame) return;
    if (frame->isMark())
      pipe.mark = frame->type;
    else
      pipe.data.push_back(std::move(*frame));
  }
}

/// Waits for all pipes whose turn is not complete, since their writers may wait for room in any
/// order.
void TurnInputs::readSome() {
  std::vector<pollfd> polled;
  std::vector<Pipe*> incomplete;
  for (auto& pipe : pipes_) {
    if (pipe.mark) continue;
    polled.push_back({pipe.input.descriptor(), POLLIN, 0});
    incomplete.push_back(&pipe);
  }
  while (::poll(polled.data(), polled.size(), -1) < 0 && errno == EINTR) {
  }
  for (std::size_t i = 0; i < polled.size(); ++i) {
    if (polled[i].revents == 0) continue;
    if (!incomplete[i]->input.read()) incomplete[i]->input.failAtEnd();
    takeTurn(*incomplete[i]);
  }
}

}  // namespace slam_pipes
