# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Progress of a long benchmark on stderr: one moving line on a terminal, few lines in a log."""
import sys
import time

_TERMINAL_EVERY = 0.5  # [s]
_LOG_EVERY = 30.0      # [s]


class Progress:
    """What is going on. begin() names a task, update() its state."""

    def __init__(self, stream=None):
        self._stream = sys.stderr if stream is None else stream
        self._terminal = self._stream.isatty()
        self._every = _TERMINAL_EVERY if self._terminal else _LOG_EVERY
        self._task = ""
        self._last = 0.0

    def _write(self, text, end):
        start = "\r" if self._terminal else ""
        clear = "\033[K" if self._terminal else ""
        self._stream.write(f"{start}{text}{clear}{end}")
        self._stream.flush()

    def begin(self, task):
        """A new task."""
        self._task, self._last = task, time.monotonic()
        self._write(f"{task} ...", "" if self._terminal else "\n")

    def update(self, state):
        """The state of the task; state is a text, or a function that makes it when it is due."""
        now = time.monotonic()
        if now - self._last < self._every:
            return
        self._last = now
        text = state() if callable(state) else state
        self._write(f"{self._task}: {text}", "" if self._terminal else "\n")

    def end(self):
        """No task is left: frees the line."""
        if self._terminal:
            self._write("", "")
