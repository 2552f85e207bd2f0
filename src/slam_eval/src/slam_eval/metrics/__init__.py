# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""How good a run is: errors, consistency and drift as numbers, by the definitions of the field.

What computes a figure from data that was read belongs here. Nothing here draws or prints."""
