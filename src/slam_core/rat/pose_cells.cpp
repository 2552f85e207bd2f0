// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/pose_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/common/starvation.hpp"
#include "slam_core/contract/known_sections.hpp"

namespace slam::rat {
namespace {

const StageRegistrar<PoseCells> kPoseCells(PoseCellConfig::kSection);
const SectionRegistrar<PoseCellConfig> kPoseCellSection;

/// The share of its activity that a view adds which has faded by so much (Ball et al. 2013, the
/// constants of the rat's network).
double shareOf(double fading) { return std::max(1.0 - std::exp(1.2 * fading) / 30.0, 0.0); }

}  // namespace

void PoseCells::describe(Ports& ports) {
  ports.takes<Motion>("motion", "motion", this).carrier();
  ports.takes<ViewCell>("local_view", "local view cells", this);
  ports.makes<PoseCellState>("pose_cells", state_);
}

void PoseCells::configure(const PoseCellConfig& config) {
  requireUsable(config);
  config_ = config;
  reset();
}

void PoseCells::configure(Settings& settings) { configure(settings.read<PoseCellConfig>()); }

void PoseCells::reset() {
  collator_ = Inputs();
  network_ = PoseCellNetwork(config_);
  network_.settle();
  learnt_.clear();
  next_sequence_ = 0;
  is_busy_ = false;
  state_.reset();
  invalid_.clear();
  fault_.clear();
}

bool PoseCells::isFit(const std::string& fault, const char* counter) {
  if (fault.empty()) return true;
  invalid_.add(counter);
  fault_ = fault + "; it is left out";
  return false;
}

void PoseCells::set(const Motion& motion) {
  if (isFit(faultOf(motion), "invalid_motion"))
    collator_.push(motion);
  else
    collator_.skip(motion.sequence);
}

void PoseCells::set(const ViewCell& view) {
  if (isFit(faultOf(view), "invalid_local_view"))
    collator_.push(0, view.stamp, view.sequence, view);
  else
    collator_.skip(0, view.sequence);
}

Counters PoseCells::counters() const {
  auto all = collator_.counters();
  all.add(invalid_);
  return all;
}

Status PoseCells::execute() {
  state_.reset();
  const auto fault = std::exchange(fault_, "");
  const auto status = fault.empty() ? Status::ok() : Status::warning(fault);
  const auto step = collator_.next();
  is_busy_ = step.has_value();
  if (!step) return moreUrgent(status, starvation(collator_, 0, "views of the camera"));
  for (const auto& motion : step->motions) network_.move(motion.increment);
  if (!step->trigger) return status;
  const auto view = step->trigger->cell;
  recall(view);
  network_.settle();
  learn(view);
  state_ = PoseCellState{step->stamp, next_sequence_++, network_.centre(),
                         view,        config_.edge,     config_.headings};
  return status;
}

void PoseCells::recall(std::int64_t view) {
  for (auto& [number, learnt] : learnt_)
    learnt.fading = std::max(learnt.fading - config_.recovery, 0.0);
  const auto known = learnt_.find(view);
  if (known == learnt_.end()) return;
  network_.inject(known->second.place, config_.injected * shareOf(known->second.fading));
  known->second.fading += config_.fading;
}

void PoseCells::learn(std::int64_t view) {
  if (view == kNoView || learnt_.count(view) > 0) return;
  learnt_[view] = {network_.centre(), config_.fading};
}

void PoseCells::saveState(ArchiveWriter& archive) const { archive(*this); }

void PoseCells::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::rat
