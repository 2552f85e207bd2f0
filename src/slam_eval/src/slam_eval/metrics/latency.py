# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""From an image to its pose: how long it took, from the times at which both arrived."""
import dataclasses
import struct

import numpy as np

_HEADER = struct.Struct("<III")  # of std_msgs/Header: seq, seconds, nanoseconds


def stamp_of(message):
    """Stamp [ns] of a serialised message that begins with a header."""
    _, seconds, nanoseconds = _HEADER.unpack_from(message)
    return seconds * 1_000_000_000 + nanoseconds


@dataclasses.dataclass(frozen=True)
class Latency:
    """Times from image to pose [ms] with the numbers of images, of poses and of images between
    the first and the last pose that got none."""

    images: int
    poses: int
    unanswered: int
    p50_ms: float
    p99_ms: float
    max_ms: float


def latency(images, poses):
    """Compare two dictionaries from stamp [ns] to time of arrival [s]; None without a pair."""
    pairs = sorted(stamp for stamp in poses if stamp in images)
    if not pairs:
        return None
    times = 1e3 * np.array([poses[stamp] - images[stamp] for stamp in pairs])
    unanswered = sum(pairs[0] < stamp < pairs[-1] and stamp not in poses for stamp in images)
    p50, p99 = np.percentile(times, [50, 99])
    return Latency(len(images), len(poses), unanswered, float(p50), float(p99),
                   float(np.max(times)))
