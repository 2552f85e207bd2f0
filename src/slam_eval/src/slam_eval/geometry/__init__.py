# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes and motions of the plane: poses and their composition, line segments and rays.

What needs numpy alone and knows neither files nor runs belongs here."""
