// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/local_view.hpp"

#include <utility>

#include "slam_core/contract/known_sections.hpp"

namespace slam::rat {
namespace {

const StageRegistrar<LocalView> kLocalView(LocalViewConfig::kSection);
const SectionRegistrar<LocalViewConfig> kLocalViewSection;

}  // namespace

void LocalView::describe(Ports& ports) {
  ports.takes<CameraView>("camera", "what the camera sees", this);
  ports.makes<ViewCell>("local_view", cell_);
}

void LocalView::configure(const LocalViewConfig& config) {
  requireUsable(config);
  config_ = config;
  reset();
}

void LocalView::configure(Settings& settings) { configure(settings.read<LocalViewConfig>()); }

void LocalView::reset() {
  memory_ = ViewMemory(config_);
  next_sequence_ = 0;
  seen_.reset();
  cell_.reset();
  counters_.clear();
}

Status LocalView::execute() {
  cell_.reset();
  const auto seen = std::exchange(seen_, std::nullopt);
  return seen ? recognise(*seen) : Status::ok();
}

Status LocalView::recognise(const CameraView& seen) {
  cell_ = ViewCell{seen.stamp, next_sequence_++, kNoView, false, 0.0};
  if (!seen.isUsable() || seen.image.gray.empty()) {
    counters_.add("unusable");
    return Status::ok();  // the camera's gate has said why
  }
  auto view = viewOf(seen.image.gray, config_);
  if (!view) {
    counters_.add("blank");
    return Status::warning(
        "the camera sees nothing that it could recognise, as in a dark room or before a blank "
        "wall: no place is recognised meanwhile");
  }
  const auto match = memory_.nearest(*view);
  if (match) cell_->difference = match->difference;
  if (match && match->difference <= config_.largest_difference) {
    cell_->cell = match->view;
    return Status::ok();
  }
  if (memory_.size() >= config_.most_views) {
    counters_.add("views_full");
    return Status::warning(
        "local_view.most_views views are remembered and no more: raise it to go on mapping");
  }
  cell_->cell = memory_.add(std::move(*view));
  cell_->is_new = true;
  return Status::ok();
}

Component::Figures LocalView::figures() const {
  return {{"views", static_cast<double>(memory_.size())}};
}

void LocalView::saveState(ArchiveWriter& archive) const { archive(*this); }

void LocalView::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::rat
