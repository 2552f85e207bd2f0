# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of runs and of benchmarks, all in one style.

What draws with matplotlib belongs here; figures come from metrics."""
