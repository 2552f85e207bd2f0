# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Chi-square distribution from the regularised incomplete gamma function (no scipy needed).

Series and continued fraction: Abramowitz and Stegun 6.5.29 and 6.5.31.
"""
import functools
import math

_TINY = 1e-300
_EPSILON = 1e-15


def _gamma_series(a, x):
    term = total = 1.0 / a
    n = a
    while abs(term) > _EPSILON * abs(total):
        n += 1.0
        term *= x / n
        total += term
    return total * math.exp(a * math.log(x) - x - math.lgamma(a))


def _gamma_fraction(a, x):
    """Upper regularised function by the modified Lentz method."""
    b = x + 1.0 - a
    c, d = 1.0 / _TINY, 1.0 / b
    h = d
    for i in range(1, 10000):
        an = -i * (i - a)
        b += 2.0
        d = an * d + b
        d = 1.0 / (d if abs(d) > _TINY else _TINY)
        c = b + an / c
        c = c if abs(c) > _TINY else _TINY
        h *= d * c
        if abs(d * c - 1.0) < _EPSILON:
            break
    return h * math.exp(a * math.log(x) - x - math.lgamma(a))


def chi_square_cdf(value, dof):
    """Probability that a chi-square variable of dof degrees of freedom is at most value."""
    if value <= 0.0:
        return 0.0
    a, x = 0.5 * dof, 0.5 * value
    return _gamma_series(a, x) if x < a + 1.0 else 1.0 - _gamma_fraction(a, x)


@functools.lru_cache(maxsize=None)
def chi_square_quantile(probability, dof):
    """The value a chi-square variable of dof degrees of freedom stays below with probability."""
    if not 0.0 < probability < 1.0 or dof <= 0:
        raise ValueError(f'chi-square quantile of probability {probability}, {dof} dof')
    low, high = 0.0, float(dof)
    while chi_square_cdf(high, dof) < probability:
        low, high = high, 2.0 * high
    for _ in range(200):
        middle = 0.5 * (low + high)
        if chi_square_cdf(middle, dof) < probability:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def two_sided_bounds(dof, probability=0.95):
    """(lower, upper) value between which a chi-square variable lies with the given probability."""
    tail = 0.5 * (1.0 - probability)
    return chi_square_quantile(tail, dof), chi_square_quantile(1.0 - tail, dof)
