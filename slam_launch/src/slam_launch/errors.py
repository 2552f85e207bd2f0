# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The error that all modules raise, and what its sentences are made of."""

import difflib


class ProductError(Exception):
    """What was asked for cannot be; the message says why and what to give instead."""


def did_you_mean(name, candidates):
    """" (did you mean 'x'?)", or nothing where none is near."""
    near = difflib.get_close_matches(name.lower(), list(candidates), 1)
    return f" (did you mean '{near[0]}'?)" if near else ""
