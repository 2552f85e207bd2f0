# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A small feature model with a constraint of each kind."""

import pathlib
import tempfile

from slam_launch.feature_model import FeatureModel

KCONFIG = """
config SLAM
	bool
	default y
	depends on SEES
choice FILTER
	prompt "Filter"
config FILTER_GAUSS
	bool "one Gaussian"
config FILTER_CLOUD
	bool "samples"
	select SAMPLES
endchoice
choice MAP
	prompt "Map"
	default MAP_POINTS
config MAP_POINTS
	bool "points"
config MAP_CELLS
	bool "cells"
	depends on SAMPLES
endchoice
config CAMERA
	bool "camera"
	select SEES
config LASER
	bool "laser"
	select SEES
config SAMPLES
	bool
	help
	  Cells need
	  samples.
config SEES
	bool
	help
	  Something has to be seen.
config SECTION_CLOUD
	bool
	default y
	depends on FILTER_CLOUD
config LAUNCH_GAUSS
	string
	default "gauss/gauss.launch" if FILTER_GAUSS
"""

EXTENSION = """
choice FILTER
config FILTER_GRID
	bool "histogram"
	select SAMPLES
endchoice
config LIBRARY_GRID
	string
	default "libgrid.so" if FILTER_GRID
"""


def small_model(*texts):
    """Returns the model of Kconfig texts."""
    with tempfile.TemporaryDirectory() as folder:
        files = [pathlib.Path(folder) / f"[{number}] Kconfig" for number in range(len(texts))]
        for file, text in zip(files, texts):
            file.write_text(text, encoding="utf-8")
        return FeatureModel(files)
