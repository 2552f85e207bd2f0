// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/stamped_queue.hpp"
#include "slam_core/common/time.hpp"

namespace slam {

/// Merges motion and triggers (observation arrays, scans) by stamp into steps, whatever the order
/// of their arrival: a step is taken when motion covers its stamp and every other trigger source
/// has passed it; the increment that spans the stamp is split there. Equal stamps of several
/// sources come in the order of the sources. A source that was silent for too long holds nobody
/// back until it sends something again.
///
/// Of a product without motion (Limits::has_motion) the triggers themselves are the clock: a step
/// is taken when every other trigger source has passed its stamp, and how long one is silent is
/// measured by the newest stamp of the others.
///
/// Motion needs `start`, `end`, `sequence` and a free function split(motion, stamp). Counted, never
/// silent: "late", "before_start", "lost" (a gap in the sequence), "overflow", "stamp_jump",
/// "source_timeout", "restart", "abandoned" (triggers that waited when time was reset), "in_gap"
/// (see skipBetween()).
template <class Motion, class Trigger>
class Collator {
 public:
  struct Limits {
    Duration source_timeout = std::chrono::seconds(1);  ///< then a silent source holds nobody back
    std::size_t motions = 20000;                        ///< held; more are applied without trigger
    std::size_t triggers = 2000;                        ///< held for each source; more are dropped
    bool has_motion = true;                             ///< else triggers are the clock
  };
  /// `motions` lead exactly to `stamp`. Without a trigger it is a carry: motion has piled up with
  /// nothing to see. `restart`: time started over, drop everything first.
  struct Step {
    Stamp stamp;
    std::vector<Motion> motions;
    std::optional<Trigger> trigger;
    bool restart = false;
  };

  explicit Collator(std::size_t trigger_sources = 1, Limits limits = Limits())
      : limits_(limits),
        motions_(limits.motions * 2),
        triggers_(trigger_sources),
        silent_(trigger_sources, false) {
    for (auto& source : triggers_) source = StampedQueue<Trigger>(limits.triggers);
  }

  /// Nothing comes of it where there is to be no motion.
  void push(Motion motion) {
    if (!limits_.has_motion) return;
    const auto stamp = motion.end;
    const auto sequence = motion.sequence;
    motions_.push(stamp, sequence, std::move(motion), counters_);
    restartWhenAllWentBack();
  }

  void push(std::size_t source, Stamp stamp, std::uint64_t sequence, Trigger trigger) {
    triggers_[source].push(stamp, sequence, std::move(trigger), counters_);
    silent_[source] = false;
    restartWhenAllWentBack();
  }

  /// A motion, or a trigger, that is no use: it was not lost on the way.
  void skip(std::uint64_t motion) { motions_.skip(motion); }
  void skip(std::size_t source, std::uint64_t trigger) { triggers_[source].skip(trigger); }

  /// Where the robot was meanwhile is not known, only where it came out: triggers from between are
  /// left out.
  friend void skipBetween(Collator& collator, Stamp begin, Stamp end) {
    collator.gaps_.push_back({begin, end});
  }

  /// Nothing is expected of the source: it holds nobody back before it has sent something.
  void expectNothing(std::size_t source) { silent_[source] = true; }

  /// The next step that is due, or nothing. Call until it is empty after every push().
  std::optional<Step> next() {
    if (limits_.has_motion && motions_.items().empty() && !motions_.stamps().last())
      return std::nullopt;
    if (limits_.has_motion && !position_) position_ = motions_.items().front().value.start;
    if (position_) dropStale();
    auto* source = earliestSource();
    if (source != nullptr && isDue(*source)) {
      Step step = stepTo(source->items().front().stamp);
      step.trigger = source->pop().value;
      return step;
    }
    const auto& held = motions_.items();
    if (held.size() > limits_.motions) return stepTo(held[held.size() / 2].stamp);
    return std::nullopt;
  }

  /// The trigger of another source that is due at the stamp of the last step, which next() would
  /// return; null where there is none.
  friend const Trigger* dueAtTheSameTime(Collator& collator) {
    const auto* source = collator.earliestSource();
    const bool is_due = source != nullptr && source->items().front().stamp == collator.position_ &&
                        collator.isDue(*source);
    return is_due ? &source->items().front().value : nullptr;
  }

  /// The motion that follows the last step, if it is here.
  const Motion* pending() const {
    return motions_.items().empty() ? nullptr : &motions_.items().front().value;
  }
  std::optional<Stamp> lastMotion() const { return motions_.stamps().last(); }
  /// A source's triggers that have not been handed out, and the stamps of all that came.
  const StampedQueue<Trigger>& triggers(std::size_t source) const { return triggers_[source]; }
  /// Since when the source's triggers wait for motion, where they have gone on without it for
  /// longer than `patience`.
  std::optional<Stamp> starvedSince(std::size_t source, Duration patience) const {
    const auto& queue = triggers_[source];
    const auto last = lastMotion();
    const bool is_starved =
        last && !queue.items().empty() && *queue.stamps().last() - *last > patience;
    if (!is_starved) return std::nullopt;
    return std::max(queue.items().front().stamp, *last);
  }
  const Counters& counters() const { return counters_; }
  /// Messages that went back in time and wait for the other sources to do so as well.
  std::size_t setAside() const {
    std::size_t sum = motions_.setAside();
    for (const auto& source : triggers_) sum += source.setAside();
    return sum;
  }

  template <class Archive>
  void persist(Archive& archive, const std::vector<Trigger>& alike) {
    for (std::size_t source = 0; source < triggers_.size(); ++source)
      triggers_[source].persist(archive, alike[source]);
    archive(motions_, gaps_, silent_, position_, stepped_, restart_, counters_);
  }

 private:
  /// Triggers from before the first motion, those of a timed-out source that come too late, and
  /// those in gaps.
  void dropStale() {
    while (!gaps_.empty() && gaps_.front().second <= *position_) gaps_.pop_front();
    for (auto& source : triggers_)
      while (!source.items().empty()) {
        const auto stamp = source.items().front().stamp;
        const bool is_stale = stamp < *position_;
        if (!is_stale && !isInGap(stamp)) break;
        counters_.add(!is_stale ? "in_gap" : stepped_ ? "late" : "before_start");
        source.pop();
      }
  }

  bool isInGap(Stamp stamp) const {
    return std::any_of(gaps_.begin(), gaps_.end(), [&](const auto& gap) {
      return gap.first < stamp && stamp < gap.second && covered() && gap.second <= *covered() &&
             isCrossed(gap);
    });
  }

  /// Not by motion whose stamps have proved wrong; those in doubt are not covered().
  bool isCrossed(const std::pair<Stamp, Stamp>& gap) const {
    const auto& held = motions_.items();
    return std::any_of(held.begin(), held.end(), [&gap](const auto& item) {
      return item.value.start <= gap.first && gap.second <= item.value.end;
    });
  }

  StampedQueue<Trigger>* earliestSource() {
    StampedQueue<Trigger>* earliest = nullptr;
    for (auto& source : triggers_)
      if (!source.items().empty() &&
          (!earliest || source.items().front().stamp < earliest->items().front().stamp))
        earliest = &source;
    return earliest;
  }

  /// The newest stamp of the triggers, but for jumps ahead that too few of them confirm.
  std::optional<Stamp> newestTrigger() const {
    std::optional<Stamp> newest;
    for (const auto& source : triggers_) newest = std::max(newest, source.stamps().believed());
    return newest;
  }

  /// How far steps may go: as motion is known, or else as triggers have come. A jump ahead of
  /// motion's stamps counts where triggers confirm it.
  std::optional<Stamp> covered() const {
    if (!limits_.has_motion) return newestTrigger();
    const auto& moved = motions_.stamps();
    const auto confirms = [&](const auto& source) {
      const auto believed = source.stamps().believed();
      return believed && *believed + kStampJump >= *moved.begin();
    };
    const bool is_confirmed =
        moved.begin() && std::any_of(triggers_.begin(), triggers_.end(), confirms);
    return is_confirmed ? moved.last() : moved.believed();
  }

  bool isDue(const StampedQueue<Trigger>& source) {
    const auto stamp = source.items().front().stamp;
    if (!covered() || *covered() < stamp) return false;
    for (std::size_t other = 0; other < triggers_.size(); ++other)
      if (!hasPassed(other, stamp)) return false;
    return true;
  }

  /// Whether nothing of the source is to be waited for any more before a step to the stamp.
  bool hasPassed(std::size_t source, Stamp stamp) {
    const auto& queue = triggers_[source];
    const auto newest = queue.stamps().last();
    if (silent_[source] || !queue.items().empty() || (newest && *newest >= stamp)) return true;
    const auto last = std::max(stamp, newest.value_or(stamp));
    if (*covered() - last < limits_.source_timeout) return false;
    counters_.add("source_timeout");
    silent_[source] = true;
    return true;
  }

  Step stepTo(Stamp stamp) {
    Step step;
    step.stamp = stamp;
    step.restart = std::exchange(restart_, false);
    while (pending() != nullptr && pending()->start < stamp) {
      Motion motion = motions_.pop().value;
      if (motion.end <= *position_) {
        counters_.add("late");
        continue;
      }
      if (motion.start < *position_) motion = split(motion, *position_).second;
      if (motion.end > stamp) {
        auto [before, after] = split(motion, stamp);
        motions_.pushFront(after.end, std::move(after));
        motion = std::move(before);
      }
      position_ = motion.end;
      step.motions.push_back(std::move(motion));
    }
    goTo(stamp);
    return step;
  }

  void goTo(Stamp stamp) {
    position_ = stamp;
    stepped_ = true;
    motions_.goneTo(stamp);
    for (auto& source : triggers_) source.goneTo(stamp);
  }

  /// Where there is no motion to confirm it, one trigger alone does not begin a run.
  bool allBeganAnew() const {
    const bool is_likely =
        limits_.has_motion ? motions_.beganAnew() : setAside() >= StampedQueue<Trigger>::kInARow;
    if (!is_likely) return false;
    for (std::size_t source = 0; source < triggers_.size(); ++source)
      if (!silent_[source] && !triggers_[source].beganAnew() && triggers_[source].stamps().last())
        return false;
    return true;
  }

  void restartWhenAllWentBack() {
    if (!allBeganAnew()) return;
    motions_.restart();
    for (auto& source : triggers_) counters_.add("abandoned", source.restart());
    gaps_.clear();
    position_.reset();
    stepped_ = false;
    restart_ = true;
    counters_.add("restart");
  }

  Limits limits_;
  StampedQueue<Motion> motions_;
  std::vector<StampedQueue<Trigger>> triggers_;
  std::deque<std::pair<Stamp, Stamp>> gaps_;  ///< of skipBetween(), that are not behind us yet
  std::vector<bool> silent_;                  ///< of each source: for too long
  std::optional<Stamp> position_;             ///< up to where motion has been handed out
  bool stepped_ = false;
  bool restart_ = false;
  Counters counters_;
};

}  // namespace slam
