# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The error that ends a benchmark."""


class BenchError(Exception):
    """A benchmark that cannot go on. Its text is one sentence: what, where, remedy."""
