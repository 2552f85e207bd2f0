# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads a bag into a Recording, message by message."""
import pathlib
import sys
import time

import rosbag

from slam_doctor.errors import InputError, UsageError
from slam_doctor.record.recording import Recording

QUIET = 2.0  # for so long no progress is shown [s]


class Progress:
    """Says on a terminal how much of a long bag has been read."""

    def __init__(self, begin, end, stream=None):
        self._begin, self._span = begin, max(end - begin, 1e-9)
        self._stream = stream or sys.stderr
        self._next = time.monotonic() + QUIET
        self._shown = False

    def at(self, arrival):
        """Notes how far the bag has been read [s]."""
        now = time.monotonic()
        if now < self._next or not self._stream.isatty():
            return
        share = min(100, max(0, int(100 * (arrival - self._begin) / self._span)))
        print(f"\rreading: {share} %", end="", file=self._stream, flush=True)
        self._next, self._shown = now + 0.5, True

    def end(self):
        """Clears the line."""
        if self._shown:
            print("\r\x1b[K", end="", file=self._stream, flush=True)


def require_file(path):
    """Refuses what no bag can be read from."""
    if path.is_dir():
        raise UsageError(f"{path} is a folder; name a bag in it")
    if not path.exists():
        raise UsageError(f"there is no bag {path}")
    if not path.is_file():
        raise UsageError(f"{path} is a pipe or a device, not a bag")


def read_bag(name):
    """The Recording of a bag. Raises UsageError or InputError."""
    path = pathlib.Path(name).expanduser()
    require_file(path)
    recording = Recording(path.name)
    try:
        with rosbag.Bag(str(path)) as bag:
            take_all(bag, recording)
    except rosbag.bag.ROSBagUnindexedException:
        raise InputError(f"the bag {path} was not closed when it was recorded; 'rosbag reindex "
                         f"{path}' mends it") from None
    except Exception as fault:  # of a damaged bag the library raises whatever it stumbles over
        cause = " ".join(str(fault).split()) or type(fault).__name__
        raise InputError(f"cannot read the bag {path}, is it damaged or no bag? "
                         f"({cause})") from None
    if recording.start is None:
        raise InputError(f"the bag {path} holds no messages; record it anew")
    return recording


def take_all(bag, recording):
    """Takes all messages of a bag."""
    if not bag.get_message_count():
        return
    progress = Progress(bag.get_start_time(), bag.get_end_time())
    for topic, raw, arrival, header in bag.read_messages(raw=True, return_connection_header=True):
        caller = header.get("callerid", b"")
        caller = caller.decode(errors="replace") if isinstance(caller, bytes) else caller
        recording.take(topic, raw[0], raw[1], raw[-1], arrival.to_nsec(), caller)
        progress.at(arrival.to_sec())
    progress.end()
