# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Campaigns: bags x products x seeds from one file, run by Snakemake on one host or many, and the
page of what came out."""
