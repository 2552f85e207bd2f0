# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The errors that end a call of the doctor."""


class UsageError(Exception):
    """The doctor was called in a wrong way, exit code 2; the message says what to do."""


class InputError(Exception):
    """The bag or the robot cannot be read, exit code 1; the message says why."""
