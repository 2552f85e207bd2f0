# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a program to its end and says what it cost."""
import dataclasses
import os
import pathlib
import re
import signal
import subprocess
import time

from slam_eval.bench.harness.error import BenchError, ProgramError

_POLL = 0.02      # [s]
_PATIENCE = 30.0  # [s] in which a program may end what it has started, as roslaunch does
_COLOUR = re.compile(r"\x1b\[[0-9;]*m")


@dataclasses.dataclass(frozen=True)
class Usage:
    """CPU (user and system) and wall time [s] and peak resident memory [MB] of a process."""

    cpu_s: float
    wall_s: float
    max_rss_mb: float


def _peak_memory(pid):
    """Peak memory [MB] up to now, 0 when the process has just ended.

    Not ru_maxrss, which starts with the memory of the parent that called exec, here Python's.
    """
    try:
        status = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    except OSError:
        return 0.0
    peak = [line.split()[1] for line in status.splitlines() if line.startswith("VmHWM:")]
    return int(peak[0]) * 1024 / 1e6 if peak else 0.0


def _wait(process, watch):
    """(exit status, usage) of the process, which is asked for its memory all the while."""
    start, peak = time.monotonic(), 0.0
    while True:
        pid, status, used = os.wait4(process.pid, os.WNOHANG)
        wall = time.monotonic() - start
        if pid:
            process.returncode = os.waitstatus_to_exitcode(status)
            return process.returncode, Usage(used.ru_utime + used.ru_stime, wall, peak)
        peak = max(peak, _peak_memory(process.pid))
        if watch is not None:
            watch(wall)
        time.sleep(_POLL)


def without_colours(text):
    """What a program printed for a terminal, as plain text."""
    return _COLOUR.sub("", text)


def _last_line(path):
    lines = path.read_text(encoding="utf-8", errors="replace").split("\n")
    lines = [without_colours(line).strip() for line in lines if line.strip()]
    return lines[-1] if lines else "it printed nothing"


def _stop(process):
    """Ends a program that was given up, and gives it time to end what it has started."""
    if process.returncode is not None:
        return
    process.send_signal(signal.SIGTERM)
    try:
        process.wait(_PATIENCE)
    except subprocess.TimeoutExpired:
        pass
    finally:
        if process.returncode is None:
            process.kill()
            process.wait()


def run(command, log, cwd=None, watch=None):
    """Run a command with its output in the files LOG and LOG.err. Raises BenchError if it fails.

    watch(seconds) is called some 50 times a second.
    """
    command = [str(word) for word in command]
    name, errors = pathlib.Path(command[0]).name, log.with_name(log.name + ".err")
    try:
        with open(log, "wb") as out, open(errors, "wb") as err:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                                       cwd=cwd)
    except OSError as error:
        raise BenchError(f"{command[0]} cannot be run ({error.strerror})") from None
    try:
        code, usage = _wait(process, watch)
    finally:
        _stop(process)
    if code != 0:
        why = f"signal {-code}" if code < 0 else f"exit code {code}"
        said = _last_line(errors if errors.stat().st_size else log)
        raise ProgramError(f"{name} ended with {why}: {said}", code)
    return usage
