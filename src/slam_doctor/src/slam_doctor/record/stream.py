# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""When the messages of a topic were stamped and when they came."""
import numpy as np

from slam_doctor.record.thinned import Thinned

SECOND = 1e9
BINS = 240  # of the timeline, at most


class Timeline:
    """How many messages came in each piece of the time; pieces double when there are too many."""

    def __init__(self, width=0.25):
        self.width = width  # of a piece [s]
        self.counts = [0]

    def add(self, time):
        """Counts a message [s since the start]."""
        at = max(0, int(time / self.width))
        while at >= BINS:
            pairs = self.counts + [0] * (len(self.counts) % 2)
            self.counts = [a + b for a, b in zip(pairs[::2], pairs[1::2])]
            self.width *= 2
            at = int(time / self.width)
        self.counts += [0] * (at + 1 - len(self.counts))
        self.counts[at] += 1


class Stream:
    """The times of one topic's messages [ns], as statistics. arrival_start, start: of the recording
    by arrivals and by stamps [ns]."""

    def __init__(self, arrival_start, start):
        self._arrival_start, self._start = arrival_start, start
        self._last_stamp = self._last_arrival = None
        self.count = self.stamped = 0
        self.zero = self.equal = self.back = 0  # stamps
        self.largest_step_back = 0.0            # [s]
        self.longest_gap = (0.0, 0.0, 0.0)      # its length, and the stamps of its ends [s]
        self.intervals = Thinned()              # between stamps that grow [s]
        self.offsets = Thinned()                # (arrival since the start, arrival - stamp) [s]
        self.timeline = Timeline()

    def add(self, arrival, stamp):
        """Notes a message; stamp: None of one without."""
        self.count += 1
        self.timeline.add((arrival - self._arrival_start) / SECOND)
        if stamp == 0:
            self.zero += 1
        elif stamp is not None:
            self._add_stamp(arrival, stamp)
        elif self._last_arrival is not None:
            self._add_interval(self._last_arrival, arrival)
        self._last_arrival = arrival

    def _add_stamp(self, arrival, stamp):
        self.stamped += 1
        self.offsets.append(((arrival - self._arrival_start) / SECOND, (arrival - stamp) / SECOND))
        if self._last_stamp is not None:
            self._add_interval(self._last_stamp, stamp)
        self._last_stamp = stamp

    def _add_interval(self, before, stamp):
        step = (stamp - before) / SECOND
        self.equal += step == 0
        if step < 0:
            self.back += 1
            self.largest_step_back = max(self.largest_step_back, -step)
        elif step > 0:
            self.intervals.append(step)
            if step > self.longest_gap[0]:
                self.longest_gap = (step, (before - self._start) / SECOND,
                                    (stamp - self._start) / SECOND)

    def interval(self):
        """The median interval [s]; NaN with fewer than two messages."""
        steps = self.intervals.array()
        return float(np.median(steps)) if len(steps) else float("nan")

    def offset(self):
        """The median of arrival - stamp [s]; NaN without stamps."""
        offsets = self.offsets.array()
        return float(np.median(offsets[:, 1])) if len(offsets) else float("nan")

    def offset_change(self):
        """By how much arrival - stamp has grown from the first quarter of the messages to the last
        [s]; NaN with too few of them."""
        offsets = self.offsets.array()
        quarter = len(offsets) // 4
        if quarter < 5:
            return float("nan")
        return float(np.median(offsets[-quarter:, 1]) - np.median(offsets[:quarter, 1]))
