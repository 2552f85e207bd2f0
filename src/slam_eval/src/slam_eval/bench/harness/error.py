# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The error that ends a benchmark, and one that only a run of it ends with."""
import dataclasses


class BenchError(Exception):
    """A benchmark that cannot go on. Its text is one sentence: what, where, remedy."""


class ProgramError(BenchError):
    """A program that ended with an error. code: its exit code, below 0 the signal that ended it."""

    def __init__(self, sentence, code):
        super().__init__(sentence)
        self.code = code


@dataclasses.dataclass(frozen=True)
class Failure:
    """A run that ended with an error, and what it said."""

    sentence: str
