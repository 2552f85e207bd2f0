# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bounds of chi-square variables, which NEES and NIS of a consistent filter are."""
from scipy.special import gammaincinv  # a tenth of the time that scipy.stats takes to load


def chi_square_quantile(probability, dof):
    """The value a chi-square variable of dof degrees of freedom stays below with probability."""
    if not 0.0 < probability < 1.0 or dof <= 0:
        raise ValueError(f"chi-square quantile of probability {probability}, {dof} dof")
    return 2.0 * float(gammaincinv(0.5 * dof, probability))


def two_sided_bounds(dof, probability=0.95):
    """(lower, upper) value between which a chi-square variable lies with the given probability."""
    tail = 0.5 * (1.0 - probability)
    return chi_square_quantile(tail, dof), chi_square_quantile(1.0 - tail, dof)
