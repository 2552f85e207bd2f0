# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Few products that stand for many: faults come of a few features that meet, hardly ever of more
(Kuhn, Wallace, Gallo 2004)."""

from itertools import combinations


def covering(products, together):
    """Returns those products in which all combinations of so many features occur that occur in any:
    always the next one that has most of those that are still missing."""
    combined = [{frozenset(some) for some in combinations(features.items(), together)}
                for features in products]
    missing = set().union(*combined)
    chosen = []
    while missing:
        best = max(range(len(products)), key=lambda i: len(combined[i] & missing))
        chosen.append(products[best])
        missing -= combined[best]
    return chosen
