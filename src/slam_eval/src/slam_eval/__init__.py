# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Evaluation of a run: error figures, pictures and a report from the files a run wrote."""
