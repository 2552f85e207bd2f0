// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/common/collator.hpp"
#include "slam_core/contract/ports.hpp"
#include "slam_core/models/motion_gap.hpp"
#include "slam_core/product/input_screen.hpp"
#include "slam_core/product/product_config.hpp"

namespace slam {

/// The inputs of a back-end in order: screens them and collates motion and triggers by stamp. In a
/// product without motion the triggers are the clock. What is latched goes to the back-end at once.
///
/// Counted: the reasons of the collator and of the screen, "invalid_motion", "bridged" (missing
/// motion, made up for by the odometry's poses), "coasted" (by the last velocity, where those do
/// not tell), "in_gap" (triggers from where motion is missing for more than a
/// second, in which nobody knows which way the robot took), "set_aside" (messages that went back in
/// time and wait for the other sources to do so).
class Intake {
 public:
  struct Trigger {
    const InputPort* port = nullptr;
    std::shared_ptr<void> value;

    template <class Archive>
    void persist(Archive& archive) {
      if constexpr (Archive::kReads)
        value = port->traits.restore(archive);
      else
        port->traits.save(value.get(), archive);
    }
  };
  using Step = Collator<Motion, Trigger>::Step;
  /// What has come so far.
  struct Arrivals {
    struct Source {
      std::string input, sentence;
      std::optional<Stamp> last;  ///< the newest stamp
      std::size_t held = 0;       ///< have come and have not been handed out
    };
    std::optional<Stamp> motion;    ///< the newest stamp
    std::optional<Motion> pending;  ///< that follows the last step, if it is here
    std::vector<Source> triggers;   ///< of each input that triggers steps
    /// "landmarks and laser scans since 12.3 wait for motion", where they have gone on without it
    /// for more than kPatience; else empty.
    std::string starving;

    /// The newest stamp of a trigger's input.
    std::optional<Stamp> lastOf(const std::string& input) const;
    /// How many have come to each input and have not been handed out, under the input's sentence.
    Counters held() const;
  };

  /// @param ports of the back-end; they outlive this
  /// @param takes_lines the back-end maps lines @throw ConfigError
  void configure(Settings& settings, const Ports& ports, bool takes_lines = false);

  /// A value for an input; nothing comes of one that there is not.
  void take(const std::string& input, Kind kind, const void* value);
  /// The same for the first input of this kind.
  void take(Kind kind, const void* value);
  /// No data are expected at this input, now and after a reset: no other waits for it.
  void expectNothing(const std::string& input);

  /// The next step that is due, or nothing. Observations of one sensor and one stamp are one array,
  /// however many detectors have made them.
  std::optional<Step> next();
  /// The back-end takes this trigger: what would be too much for one step is left out of it.
  void admit(const Trigger& trigger);
  /// The landmarks of a map are not new to the back-end; those that it has seen before are.
  void knowOnly(const LandmarkMap& map) { screen_.knowOnly(map); }

  Arrivals arrivals() const;
  static constexpr Duration kPatience = std::chrono::seconds(3);

  /// The state was restored in a process that runs on other data than those which follow it.
  friend void resume(Intake& intake, Interruption interruption);
  /// Once, when it is known: whether the odometry has gone on since the state was saved, so that
  /// the pose has been carried on as surely as ever.
  friend std::optional<bool> takeContinuity(Intake& intake) {
    return std::exchange(intake.continuity_, std::nullopt);
  }

  /// What was wrong with an input since the last call, as a sentence; empty where nothing was.
  std::string takeFault() { return std::exchange(fault_, ""); }
  Counters counters() const;
  /// Messages that had no effect because they came late, were lost or did not fit.
  std::uint64_t dropped() const;
  void reset();

  /// Whether what waits here can be put into a checkpoint.
  friend bool canResume(const Intake& intake) {
    const auto& ports = intake.triggers_;
    return std::all_of(ports.begin(), ports.end(),
                       [](const auto* port) { return port->traits.save != nullptr; });
  }
  template <class Archive>
  void persist(Archive& archive) {
    std::vector<Trigger> alike;
    for (const auto* port : triggers_) alike.push_back({port, nullptr});
    collator_.persist(archive, alike);
    archive(screen_, gap_, moved_frame_, fault_, counters_);
  }

 private:
  void take(const InputPort& port, const void* value);
  void takeMotion(Motion motion);
  void takeLatched(const InputPort& port, const void* value);
  void takeTrigger(const InputPort& port, const void* value);
  std::string starving() const;
  void warnOfBaseFrame(const std::string& moved);

  FramesConfig frames_;
  Duration source_timeout_{};
  const Ports* ports_ = nullptr;
  bool has_carrier_ = false;
  std::vector<const InputPort*> triggers_;  ///< equal stamps come in this order
  std::vector<std::string> not_expected_;   ///< inputs without data
  InputScreen screen_;
  MotionGap gap_;
  Collator<Motion, Trigger> collator_;
  std::string moved_frame_;  ///< the base frame of the last motion
  std::string fault_;        ///< of an input since it was asked for
  Counters counters_;
  bool may_go_on_ = false;          ///< the odometry, while this process was not there
  std::optional<bool> continuity_;  ///< since resume(), not part of the state
};

bool canResume(const Intake& intake);
void resume(Intake& intake, Interruption interruption);

}  // namespace slam
