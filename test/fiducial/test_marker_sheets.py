# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sheets of markers as a printer gets them: detectors find each marker, at its size."""

import math
import pathlib
import re
import subprocess
import tempfile
import unittest

from launching import program

DPI = 100
FOCAL_LENGTH = 4000.0  # of a camera that sees the page from 1.016 m, one of its pixels a dot [px]
DISTANCE = FOCAL_LENGTH * 0.0254 / DPI
CALIBRATION = """
image_width: {width}
image_height: {height}
camera_name: page
camera_matrix: {{rows: 3, cols: 3, data: [{f}, 0, {cx}, 0, {f}, {cy}, 0, 0, 1]}}
distortion_model: plumb_bob
distortion_coefficients: {{rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}}
rectification_matrix: {{rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}}
projection_matrix: {{rows: 3, cols: 4, data: [{f}, 0, {cx}, 0, 0, {f}, {cy}, 0, 0, 0, 1, 0]}}
"""


def calibration(width, height):
    return CALIBRATION.format(width=width, height=height, f=FOCAL_LENGTH, cx=width / 2,
                              cy=height / 2)


class MarkerSheetsTest(unittest.TestCase):

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def pages(self, *arguments):
        """The images of the sheets, in the order of the pages."""
        pdf = self.folder / "markers.pdf"
        subprocess.run([program("slam_sim", "slam_markers"), *arguments, "--out", pdf], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run(["pdftoppm", "-r", str(DPI), "-gray", pdf, self.folder / "page"], check=True)
        return sorted(self.folder.glob("page*.pgm"))

    def detections(self, pages, detector, *settings):
        """Range and bearing by the marker's id."""
        size = pages[0].read_bytes()[:20].split()
        file = self.folder / "camera.yaml"
        file.write_text(calibration(int(size[1]), int(size[2])))
        out = subprocess.run([program("slam_core", "slam_core_fiducial_images"), detector, file,
                              *settings, *pages], check=True, capture_output=True, text=True).stdout
        found = re.findall(r"id (\d+),.* range ([\d.]+) .* bearing (-?[\d.]+) ", out)
        self.assertEqual(len(found), len(out.splitlines()), out)
        return {int(name): (float(range), float(bearing)) for name, range, bearing in found}

    def assert_on_the_page(self, found, ids):
        self.assertEqual(sorted(found), ids)
        for distance, bearing in found.values():
            self.assertAlmostEqual(distance * math.cos(bearing), DISTANCE, delta=0.01 * DISTANCE)

    def test_april_tags_have_their_size(self):
        pages = self.pages("--ids", "0-2", "--size", "0.16")
        self.assertEqual(len(pages), 3)
        self.assert_on_the_page(self.detections(pages, "apriltag", "fiducial.marker_size=0.16"),
                                [0, 1, 2])

    def test_several_on_a_page_have_their_size(self):
        pages = self.pages("--family", "Standard41h12", "--ids", "5,10-12", "--size", "0.03")
        self.assertEqual(len(pages), 1)
        found = self.detections(pages, "apriltag", "fiducial.marker_size=0.03",
                                "apriltag.families=[Standard41h12]")
        self.assert_on_the_page(found, [5, 10, 11, 12])

    def test_aruco_markers_have_their_size(self):
        pages = self.pages("--family", "DICT_5X5_100", "--ids", "7", "--size", "0.1", "--paper",
                           "letter")
        found = self.detections(pages, "aruco", "fiducial.marker_size=0.1",
                                "aruco.dictionaries=[DICT_5X5_100]")
        self.assert_on_the_page(found, [7])


if __name__ == "__main__":
    unittest.main()
