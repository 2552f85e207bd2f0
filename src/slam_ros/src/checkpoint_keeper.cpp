// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/checkpoint_keeper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "slam_ros/parameters_from_ros.hpp"

namespace slam_ros {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kNothingWritten = "no checkpoint can be written, the last one stays: ";

}  // namespace

CheckpointKeeper::CheckpointKeeper(ros::NodeHandle handle, slam::RunIdentity run,
                                   slam::MetaCoordinator& product, const StageStates& stages)
    : config_(parametersFromRos<CheckpointConfig>(handle)),
      run_(std::move(run)),
      product_(product),
      stages_(stages) {
  if (config_.folder.empty()) return;
  folder_ = std::make_unique<slam::CheckpointFolder>(config_.folder);
  handle.setParam("restarted", true);
}

CheckpointKeeper::~CheckpointKeeper() { writing_.wait(); }

bool CheckpointKeeper::resume(const std::function<void()>& configure_anew) {
  const bool goes_on = resumeProduct(configure_anew);
  stages_.goOnFrom(goes_on ? std::exchange(saved_stages_, {}) : StageStates::Saved());
  return goes_on;
}

bool CheckpointKeeper::resumeProduct(const std::function<void()>& configure_anew) {
  if (!folder_) return false;
  if (const auto title = slam::notResumable(product_.wiring()); !title.empty()) {
    news_.warnings = {"no checkpoints are written: the " + title + " cannot be resumed"};
    folder_.reset();
    return false;
  }
  autosave_ = slam::Autosave(config_.autosave);
  if (const auto fault = folder_->fault(); !fault.empty()) {
    news_.warnings.push_back(kNothingWritten + fault);
    has_failed_ = true;
  }
  if (!config_.resume && !config_.restarted) {
    folder_->beginAnew();
    return false;
  }
  const auto resumption = folder_->resume([&](const std::string& bytes) {
    try {
      restore(bytes);
    } catch (const std::runtime_error&) {
      configure_anew();
      throw;
    }
  });
  describe(resumption);
  return !resumption.file.empty();
}

void CheckpointKeeper::describe(const slam::CheckpointFolder::Resumption& resumption) {
  const bool goes_on = !resumption.file.empty();
  if (!resumption.warning.empty())
    news_.warnings.push_back((goes_on
                                  ? "an older checkpoint is used, since the last one cannot be: "
                                  : "map and pose begin anew, since no checkpoint can be used: ") +
                             resumption.warning + " (it is kept as checkpoint.unused)");
  if (goes_on)
    news_.text = fmt::format("the product goes on from {} of {:.3f} s", resumption.file,
                             slam::seconds(saved_->time_since_epoch()));
  else if (resumption.warning.empty())
    news_.text = "there is no checkpoint in " + config_.folder + ": map and pose begin anew";
}

void CheckpointKeeper::restore(const std::string& bytes) {
  const auto state = slam::stateIn(bytes, run_);
  slam::ArchiveReader archive(state);
  slam::Stamp stamp;
  std::string of_product;
  archive(stamp, of_product, saved_stages_);
  stages_.require(saved_stages_);
  slam::restore(of_product, product_);
  slam::goOnLive(product_, config_.restarted ? slam::Interruption::kOfThisProcess
                                             : slam::Interruption::kOfAll);
  saved_ = last_step_ = stamp;
}

std::string CheckpointKeeper::note(slam::Stamp last_step) {
  if (!folder_) return "";
  last_step_ = last_step;
  if (autosave_.isDue(last_step)) save();
  return takeNews();
}

/// While the last one is still being written, the next one is due with the next step.
void CheckpointKeeper::save() {
  if (writing_.isBusy()) return;
  if (const auto stage = stages_.missing(); !stage.empty())
    return fail("the stage '" + stage + "' runs in another process than the back-end");
  const auto start = Clock::now();
  slam::ArchiveWriter archive;
  archive(*last_step_, slam::stateOf(product_), stages_.copy());
  autosave_.begin(*last_step_);
  saved_ = last_step_;
  writing_.tryRun([this, state = archive.take()] { write(state); });
  const std::chrono::duration<double, std::milli> pause = Clock::now() - start;
  longest_pause_ = std::max(longest_pause_, pause.count());
}

void CheckpointKeeper::write(const std::string& state) {
  try {
    folder_->write(slam::checkpointOf(run_, state));
    if (std::exchange(has_failed_, false)) tell("checkpoints can be written again");
  } catch (const std::runtime_error& error) {
    fail(error.what());
  }
}

void CheckpointKeeper::fail(const std::string& cause) {
  if (!std::exchange(has_failed_, true)) tell(kNothingWritten + cause);
}

void CheckpointKeeper::tell(const std::string& sentence) {
  const std::lock_guard<std::mutex> lock(mutex_);
  news_of_writing_ = sentence;
}

std::string CheckpointKeeper::takeNews() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(news_of_writing_, "");
}

void CheckpointKeeper::beginAnew() {
  writing_.wait();
  if (folder_) folder_->beginAnew();
}

std::string CheckpointKeeper::finish() {
  writing_.wait();
  if (!folder_ || !last_step_) return "";
  if (saved_ != last_step_ || has_failed_) save();
  writing_.wait();
  return takeNews();
}

}  // namespace slam_ros
