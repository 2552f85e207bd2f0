# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rates, gaps and stamps."""
import math

import numpy as np

from slam_doctor.finding import error, judged, Level, ok, unknown, warn

LOST = (0.05, 0.3)        # share of the messages of a regular sensor that are lost: WARN, ERROR
DENSE = 0.1               # steps below this leave enough, whatever is lost [s]
SLOW = 0.5                # a step of key scans, which are taken when the robot has moved on [s]
GAP = (0.3, 1.0)          # a gap in which the robot drives [m] or turns [rad] so far: WARN, ERROR
GAP_UNSEEN = 1.0          # a gap that counts where no odometry says what happened in it [s]
LATE = (0.5, 5.0)         # arrival behind the stamp [s]: WARN, ERROR
EARLY = 0.05              # arrival before the stamp [s]: ERROR
APART = (0.3, 1.0)        # of the offsets of two sensors [s]: WARN, ERROR
DRIFT = (0.05, 0.5)       # change of the offset [s]: WARN, ERROR


def check(case):
    """Findings about the times of all sensors."""
    found = []
    for sensor in case.sensors.values():
        found += [rate(sensor, case), *merged(stamps(sensor), clock(sensor))]
    return found + [apart(case)] if len(case.sensors) > 1 else found


def merged(first, others):
    """The findings about stamps, as one where all is well."""
    if any(each.level is not Level.OK for each in (first, *others)):
        return [first, *others]
    texts = [first.text] + [each.text.split(": ", 1)[-1] for each in others]
    return [ok(first.check, ", ".join(texts))]


def motion_per_message(case, stream):
    """The mean way and turn of odometry from one message of a topic to the next [m + rad]."""
    way = np.hypot(np.diff(case.path.x), np.diff(case.path.y)).sum()
    return float(way + np.abs(np.diff(case.path.heading)).sum()) / stream.count \
        if case.path is not None else 0.0


def lost_share(steps):
    """The share of messages that did not come, of a sensor whose steps [s] are regular; NaN of
    others, such as key scans, and of those that are dense even so."""
    if len(steps) < 20 or np.median(steps) > SLOW or np.quantile(steps, 0.95) < DENSE:
        return math.nan
    low, median, high = np.quantile(steps, [0.25, 0.5, 0.75])
    if high - low > 0.2 * median:
        return math.nan
    lost = np.maximum(np.round(steps / median) - 1, 0).sum()
    return float(lost / (lost + len(steps)))


def rate(sensor, case):
    """How often messages come and what the longest gap is."""
    stream, name = sensor.topic.stream, f"{sensor.name}.rate"
    steps = stream.intervals.array()
    if len(steps) == 0:
        return unknown(name, f"{sensor.topic.name}: {stream.count} "
                       f"message{'' if stream.count == 1 else 's'}",
                       "Record for longer: a rate needs two messages with different stamps.")
    median = float(np.median(steps))
    jitter = float(np.median(np.abs(steps - median)))
    gap, begin, _ = stream.longest_gap
    text = (f"{sensor.topic.name}: {1.0 / median:.3g} Hz, jitter {1000 * jitter:.3g} ms, longest "
            f"gap {gap:.3g} s at {begin:.1f} s")
    if sensor.name == "observations":  # their source may say nothing while it sees nothing
        return ok(name, text, 1.0 / median, "Hz")
    bad = gap_fault(sensor, case, text) if gap > max(5 * median, 0.5) else None
    if bad:
        return bad
    lost = lost_share(steps)
    if lost > LOST[0]:
        return judged(name, f"{text}, {100 * lost:.0f} % of the messages are missing",
                      "Lower the rate, or look for load, network and queue sizes of the recorder.",
                      lost, LOST)
    return ok(name, text, 1.0 / median, "Hz")


def gap_fault(sensor, case, text):
    """The Finding about a long gap; None where the robot hardly moved in it."""
    stream, name = sensor.topic.stream, f"{sensor.name}.gap"
    gap, begin, end = stream.longest_gap
    advice = "Find out why the driver paused (USB, network, load); drive slowly until then."
    moved, is_known = motion_in_gap(case, begin, end)
    if not is_known:
        return warn(name, text, advice, gap, "s") if gap > GAP_UNSEEN else None
    usual = motion_per_message(case, stream)  # of key scans it is large
    if moved < GAP[0] + 2 * usual:
        return None
    make = error if moved > GAP[1] + 4 * usual else warn
    return make(name, f"{text}, in which the robot moved by {moved:.2f} m or rad", advice, gap, "s")


def motion_in_gap(case, begin, end):
    """(by how much odometry moved [m or rad], whether that is known)."""
    if case.path is None:
        return 0.0, False
    motion = case.path.motion(begin, end)
    if not np.isfinite(motion).all():
        return 0.0, False
    return max(math.hypot(*motion[:2]), abs(motion[2])), True


def stamps(sensor):
    """Stamps that are zero, go back or stand twice."""
    stream, name = sensor.topic.stream, f"{sensor.name}.stamps"
    count = max(1, stream.count)
    if stream.zero:
        return error(name, f"{sensor.topic.name}: {stream.zero} of {stream.count} stamps are zero",
                     "Set header.stamp in the driver to the time when the data were taken.",
                     stream.zero, "messages")
    if stream.back:
        make = error if stream.back > 0.01 * count or stream.largest_step_back > 1.0 else warn
        return make(name, f"{sensor.topic.name}: {stream.back} of {stream.count} stamps go back, "
                    f"by {stream.largest_step_back:.3g} s at most",
                    "Look for two publishers of this topic, for a clock that is set while driving, "
                    "or a bag that was played in a loop.", stream.back, "messages")
    if stream.equal > 0.01 * count:
        return warn(name, f"{sensor.topic.name}: {stream.equal} of {stream.count} stamps are those "
                    "of the message before", "Look for two publishers of this topic, or for stamps "
                    "that are rounded by the driver.", stream.equal, "messages")
    return ok(name, f"{sensor.topic.name}: stamps grow")


def spoken(seconds):
    """A time in the unit that people would use."""
    for unit, factor in (("days", 86400.0), ("h", 3600.0), ("s", 1.0)):
        if abs(seconds) >= 10 * factor:
            return f"{seconds / factor:.3g} {unit}"
    return f"{1000 * seconds:.4g} ms"


def clock(sensor):
    """Stamps against the time of arrival."""
    stream, name = sensor.topic.stream, f"{sensor.name}.clock"
    offset, change = stream.offset(), stream.offset_change()
    if not math.isfinite(offset):
        return []
    found = []
    text = f"{sensor.topic.name}: messages come {spoken(offset)} after their stamps"
    if offset < -EARLY:
        found.append(error(name, f"{sensor.topic.name}: stamps lie {spoken(-offset)} in the future",
                           "Synchronise the clocks of the machines (chrony, ntp).", -offset, "s"))
    else:
        found.append(judged(name, text, "Is the driver's clock that of another machine (chrony, "
                            "ntp), or does it stamp late data? A bag that was recorded from a "
                            "replay keeps old stamps and does no harm.", offset, LATE, "s"))
    if abs(change) > DRIFT[0]:
        found.append(judged(f"{sensor.name}.drift", f"{sensor.topic.name}: stamps drift against "
                            f"the clock, {1000 * change:.0f} ms during the recording",
                            "The sensor has a clock of its own, or messages queue up: stamp on "
                            "arrival, or synchronise it.", abs(change), DRIFT, "s"))
    return found


def apart(case):
    """Sensors whose stamps are late against one another."""
    offsets = {sensor.topic.name: sensor.topic.stream.offset() for sensor in case.sensors.values()}
    offsets = {name: offset for name, offset in offsets.items() if math.isfinite(offset)}
    if len(offsets) < 2:
        return unknown("stamps.apart", "sensors' clocks cannot be compared",
                       "Record the sensors together, with stamps.")
    first, last = min(offsets, key=offsets.get), max(offsets, key=offsets.get)
    spread = offsets[last] - offsets[first]
    return judged("stamps.apart", f"sensors' delays differ by {1000 * spread:.3g} ms"
                  f"{f', {last} against {first}' if spread > APART[0] else ''}",
                  "Two sensors use different clocks, or one is stamped late: synchronise the "
                  "machines, or stamp when the data are taken.", spread, APART, "s")
