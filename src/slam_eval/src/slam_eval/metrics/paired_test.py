# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether one system is better than another on the same data: exact sign tests with Holm's
correction, and quantiles."""
import dataclasses
import itertools
import math

import numpy as np


@dataclasses.dataclass(frozen=True)
class Comparison:
    """Of pairs of values of two systems: how often the first has the smaller one, the larger one,
    the same; the median of its value over the other's; p of the sign test, and corrected."""

    first: str
    second: str
    smaller: int
    larger: int
    same: int
    ratio: float
    p: float
    p_holm: float = math.nan


def exact_p(smaller, larger):
    """The two-sided p of an exact sign test: how likely it is that fair coins fall so unevenly, or
    more so. Pairs of equal values do not count (Dixon, Mood 1946)."""
    count = smaller + larger
    tail = sum(math.comb(count, k) for k in range(min(smaller, larger) + 1))
    return min(1.0, 2.0 * tail / 2 ** count)


def holm(p_values):
    """Corrected p-values (Holm 1979): the i-th smallest of m times m - i + 1, never below a smaller
    one's, at most 1."""
    order = np.argsort(p_values, kind="stable")
    corrected, least = np.empty(len(p_values)), 0.0
    for rank, i in enumerate(order):
        least = max(least, min(1.0, (len(p_values) - rank) * p_values[i]))
        corrected[i] = least
    return [float(value) for value in corrected]


def _compared(first, second, pairs):
    ratios = [a / b for a, b in pairs if b > 0.0]
    smaller = sum(a < b for a, b in pairs)
    larger = sum(a > b for a, b in pairs)
    return Comparison(first, second, smaller, larger, len(pairs) - smaller - larger,
                      float(np.median(ratios)) if ratios else math.nan, exact_p(smaller, larger))


def compare_all(values, drives=None):
    """Comparisons of each two systems. values: by system a dictionary of numbers by (bag, seed);
    drives: by (bag, seed) what names the drive, such as the SHA-256 of its bag; without it each is
    a drive of its own.

    A pair of values that stands on one drive with several seeds, as of systems that draw nothing at
    random, counts once.
    """
    drives = drives or {}
    found = []
    for first, second in itertools.combinations(values, 2):
        pairs = {(drives.get(key, key), values[first][key], values[second][key])
                 for key in values[first] if key in values[second]}
        if pairs:
            found.append(_compared(first, second, sorted(pair[1:] for pair in pairs)))
    corrected = holm([comparison.p for comparison in found])
    return [dataclasses.replace(comparison, p_holm=p) for comparison, p in zip(found, corrected)]


def quartiles(values):
    """(median, first quartile, third quartile) of values, linearly between them."""
    return tuple(float(q) for q in np.percentile(values, (50, 25, 75)))
