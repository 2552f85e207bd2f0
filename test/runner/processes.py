# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a test so that of the processes that it has started none is left, however it ends."""

import contextlib
import itertools
import os
import pathlib
import signal
import subprocess
import threading
import time

GRACE = 20  # [s], as long as roslaunch takes to end a node that does not listen
MARK = "SLAM_TEST_RUN"  # in the environment of all processes of a test
NUMBERS = itertools.count()
INTERRUPTED = threading.Event()


def call(command, log, timeout=None, env=None, **options):
    """Runs a command with its output in a log; returns its exit code. Of the processes that it has
    started none is left afterwards, however it ended."""
    run = f"{os.getpid()}.{next(NUMBERS)}"
    with log.open("w", encoding="utf-8") as file:
        try:
            process = subprocess.Popen(
                [str(word) for word in command], env={**(env or os.environ), MARK: run},
                start_new_session=True, stdin=subprocess.DEVNULL, stdout=file,
                stderr=subprocess.STDOUT, **options)
            return process.wait(timeout)
        except subprocess.TimeoutExpired:
            end(run, signal.SIGINT)  # roslaunch then ends its nodes
            file.write(f"it took longer than {timeout} s and was ended\n")
            return 124
        except OSError as error:
            file.write(f"{command[0]}: {error}\n")
            return 127
        finally:
            end(run, signal.SIGTERM)
            while INTERRUPTED.is_set():  # what was cut short is no failure
                time.sleep(1)


def marked(run):
    """Returns the ids of the processes of a run, or of all runs of this process, by the mark in
    their environment: roslaunch gives each node a session of its own."""
    text = f"{MARK}={run}".encode()
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/environ"):
        try:
            entries = path.read_bytes().split(b"\0")
        except OSError:  # it has ended, or is somebody else's
            continue
        if any(entry == text or entry.startswith(text + b".") for entry in entries):
            found.append(int(path.parent.name))
    return found


def end(run, request):
    """Asks the processes of a run to end; those that do not within GRACE are killed."""
    limit = time.monotonic() + GRACE
    ask(run, request)
    while marked(run) and time.monotonic() < limit:
        time.sleep(0.1)
    while ask(run, signal.SIGKILL):
        time.sleep(0.1)


def ask(run, request):
    """Sends a signal to the processes of a run; returns which there were."""
    processes = marked(run)
    for process in processes:
        with contextlib.suppress(ProcessLookupError):
            os.kill(process, request)
    return processes


def interrupt(request, _):
    """Ctrl-C and its like: no further test, and nothing is left of those that run."""
    INTERRUPTED.set()
    end(str(os.getpid()), signal.SIGINT)
    os._exit(128 + request)


def heed_interrupts():
    """Has whatever may end this program end its tests as well."""
    for request in (signal.SIGINT, signal.SIGTERM):
        signal.signal(request, interrupt)
    if signal.getsignal(signal.SIGHUP) != signal.SIG_IGN:  # nohup
        signal.signal(signal.SIGHUP, interrupt)
