# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts what tests say: a line for each, those that need attention at the end."""

import math
import os
import re
import threading
import time

from runner.processes import call

# The sanitizer's search for leaks has crashed at the program's end, which says nothing of the test.
BROKEN_TRACER = "LeakSanitizer has encountered a fatal error"
NO_LEAKS = {"ASAN_OPTIONS": "detect_leaks=0"}


class Report:
    """Runs tests, also from several threads, prints a line for each and keeps the sum."""

    def __init__(self, logs, latest=math.inf):
        """logs: the folder that each test's output goes to. latest: by the monotonic clock; tests
        that have not begun by then are skipped."""
        self.logs = logs
        self.latest = latest
        self.lock = threading.Lock()
        self.passed = 0
        self.skipped = []
        self.unsteady = []
        self.failed = []

    def run(self, name, command, read_cases=None, live=False, **options):
        """Runs a command; what it passed is told by read_cases, else by its exit code alone.

        A live test runs by the wall clock, so that a machine that stalls can fail it: it gets a
        second attempt, and its name stands at the end when it needed one. A test whose search for
        leaks crashed is run again without it, and its leaks count as skipped.
        """
        start = time.monotonic()
        if start > self.latest:
            self.skip(name, "the time was over")
            return False
        log = self.logs / (re.sub(r"[^\w.-]+", "_", name) + ".log")
        cases, failed = attempt(name, command, read_cases, log, options)
        if failed and BROKEN_TRACER in log.read_text(errors="replace"):
            self.skip(f"{name}: leaks", "the sanitizer's search for them crashed")
            options["env"] = {**(options.get("env") or os.environ), **NO_LEAKS}
            cases, failed = attempt(name, command, read_cases, log, options)
        elif failed and live:
            self.write(f"{name} ... failed, once more", log)
            self.unsteady += failed
            cases, failed = attempt(name, command, read_cases, log, options)
        seconds = time.monotonic() - start
        self.count(name, cases, failed)
        extent = f", {len(cases)} tests" if cases else ""
        outcome = "FAILED" if failed else "ok"
        self.write(f"{name} ... {outcome} ({seconds:.1f} s{extent})", log if failed else None)
        return not failed

    def count(self, name, cases, failed):
        with self.lock:
            passed = sum(outcome == "passed" for _, outcome in cases)
            self.passed += passed if cases else int(not failed)
            self.skipped += [f"{name}: {case}" for case, outcome in cases if outcome == "skipped"]
            self.failed += failed

    def write(self, line, log=None):
        """Prints a line, and below it the end of a log."""
        with self.lock:
            print(line, flush=True)
            if log:
                print_tail(log)

    def skip(self, name, reason):
        self.write(f"{name} ... skipped: {reason}")
        self.skipped.append(f"{name}: {reason}")

    def finish(self):
        """Prints the names that need attention and the last line; returns the exit code."""
        for title, names in (("skipped", self.skipped), ("failed at first", self.unsteady),
                             ("FAILED", self.failed)):
            for name in names:
                print(f"{title}: {name}")
        skipped = f", {len(self.skipped)} skipped" if self.skipped else ""
        print(f"{self.passed} passed, {len(self.failed)} failed{skipped}")
        return 1 if self.failed else 0


def attempt(name, command, read_cases, log, options):
    """Runs a test; returns its cases and the names of those that failed."""
    code = call(command, log, **options)
    cases = read_cases() if read_cases else []
    failed = [f"{name}: {case}" for case, outcome in cases if outcome == "failed"]
    if code != 0 and not failed:  # a crash leaves no or only good cases behind
        failed = [name]
    return cases, failed


def print_tail(log, count=40):
    """Prints the end of a log, and before it the lines that name what failed."""
    lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
    faults = [line for line in lines[:-count] if re.search(r"Error: |Failure$|FATAL", line)]
    print("\n".join(f"    {line}" for line in faults[:20] + lines[-count:]))
    print(f"    the whole log is {log}", flush=True)
