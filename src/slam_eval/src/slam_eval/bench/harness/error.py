# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The error that ends a benchmark, and one that only a run of it ends with."""
import dataclasses


class BenchError(Exception):
    """A benchmark that cannot go on. Its text is one sentence: what, where, remedy."""


@dataclasses.dataclass(frozen=True)
class Failure:
    """A run that ended with an error, and what it said."""

    sentence: str
