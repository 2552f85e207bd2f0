# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Does any marker of the robot's families appear? The product's own detector answers. What appears
shows whether the calibration fits."""
import dataclasses
import pathlib
import re
import subprocess
import tempfile

import numpy as np
import yaml
from slam_launch import packages
from slam_launch.errors import ProductError

from slam_doctor.checks import reprojection
from slam_doctor.finding import ok, unknown, warn
from slam_doctor.squares.calibration import Sighting

CAMERAS = ("camera", "rear_camera")  # that detectors look through
PROGRAM = ("slam_core", "slam_core_fiducial_images")
FAMILIES = {"apriltag": "apriltag.families", "aruco": "aruco.dictionaries"}
OTHERS = (("apriltag", ["36h11", "25h9", "Standard41h12"]),
          ("aruco", ["DICT_4X4_250", "DICT_5X5_250", "DICT_6X6_250", "DICT_7X7_250",
                     "DICT_ARUCO_ORIGINAL"]))
LINE = re.compile(r"^.*: id (\d+), corners((?: \(\S+ \S+\)){4}), (?:range|rejected: (\w+))", re.M)
NUMBER = re.compile(r"[-\d.]+")
WITH_CORNERS = {"", "reprojection_error", "no_pose"}  # rejections of markers with good corners
SECOND_IDS = 10000  # from which on a second detector counts; no family has so many markers
FEWER = 12  # images that are looked at for other families


def check(case):
    """Findings about markers before each camera that detectors look through."""
    return [finding for name in CAMERAS for finding in before(case.sensors.get(name), case)]


def before(camera, case):
    """Findings about markers before a camera, which may be None."""
    if camera is None or not hasattr(camera.topic.record, "pictures"):
        return []
    searches = searches_of(camera.name, case.expectations.product)
    if not searches:
        return []
    pictures, calibration = camera.topic.record.pictures.items, camera.calibration
    if not pictures or not calibration or not calibration.record.first:
        return [unknown(name, "markers cannot be looked for", "They need images with a "
                        "camera_info.") for name in searches]
    info, found, sightings = calibration.record.first, [], []
    with tempfile.TemporaryDirectory(prefix="slam_doctor_") as folder:
        detector = Detector(folder, pictures, info)
        for number, (name, detectors) in enumerate(searches.items()):
            finding, markers = look(name, detector, detectors, case.robot)
            found.append(of_topic(camera, finding))
            sightings += [sighting_of(marker, number) for marker in markers
                          if marker.rejection in WITH_CORNERS]
    if sightings:
        finding = reprojection.judge(f"{camera.name}.reprojection", info, sightings)
        found.append(of_topic(camera, finding))
    return found


def of_topic(camera, finding):
    """The Finding with the name of the camera's topic in its text."""
    return dataclasses.replace(finding, text=f"{camera.topic.name}: {finding.text}")


def sighting_of(marker, number):
    """The Sighting of a marker; its id is none of a search of another number."""
    return dataclasses.replace(marker.sighting, id=marker.sighting.id + number * SECOND_IDS)


def searches_of(camera, product):
    """{check: detectors of which one must find a marker} for a camera: each detector of a product,
    or any where it is not known which."""
    if product is None:
        return {f"{camera}.markers": list(FAMILIES)}
    checks = (f"{camera}.markers", f"{camera}.second_markers")
    return {check: [detector] for check, detector in zip(checks, product.detectors)
            if detector in FAMILIES}


@dataclasses.dataclass(frozen=True)
class Marker:
    """What the detector says of a marker in an image."""

    sighting: Sighting
    rejection: str  # empty: none


class Detector:
    """Pictures in files, for the program that finds markers in them."""

    def __init__(self, folder, pictures, info):
        from PIL import Image  # only where there are images
        self._folder = pathlib.Path(folder)
        self.images = []
        for number, picture in enumerate(pictures):
            self.images.append(self._folder / f"{number}.png")
            Image.fromarray(picture).save(self.images[-1])
        self._calibration = self._folder / "camera.yaml"
        self._calibration.write_text(yaml.safe_dump(calibration_file(info)), encoding="utf-8")

    def find(self, name, families, images=None):
        """The Markers in images, by default all; None where the detector cannot work."""
        command = [packages.program(*PROGRAM), name, self._calibration,
                   f"{FAMILIES[name]}=[{', '.join(families)}]", *(images or self.images)]
        done = subprocess.run([str(word) for word in command], text=True, capture_output=True,
                              check=False)
        if done.returncode != 0:
            return None
        return [Marker(Sighting(int(identity), corners_of(text)), rejection)
                for identity, text, rejection in LINE.findall(done.stdout)]

    def some(self):
        """A few images, evenly selected."""
        return self.images[::-(-len(self.images) // FEWER) or 1]


def corners_of(text):
    """The corners (4 x 2) in a line of the detector [px]."""
    return np.array([float(number) for number in NUMBER.findall(text)]).reshape(4, 2)


def calibration_file(info):
    """A camera_info as ROS's camera calibration writes it into a file."""
    def matrix(rows, columns, data):
        return {"rows": rows, "cols": columns, "data": [float(value) for value in data]}
    return {"image_width": info.width, "image_height": info.height, "camera_name": "camera",
            "camera_matrix": matrix(3, 3, info.K), "distortion_model": info.distortion_model,
            "distortion_coefficients": matrix(1, len(info.D), info.D)}


def families_of(name, robot):
    """The families that a detector looks for."""
    section, key = FAMILIES[name].split(".")
    own = robot.value(section, key)
    return [str(family) for family in own] if isinstance(own, list) else \
        re.findall(r"\w+", str(own or ""))


def look(check, detector, names, robot):
    """(Finding of that name about markers in some pictures, [Marker])."""
    count, looked_for = len(detector.images), []
    try:
        for name in names:
            families = families_of(name, robot)
            markers = detector.find(name, families)
            seen = {marker.sighting.id for marker in markers or []
                    if marker.rejection in WITH_CORNERS}
            if seen:
                return ok(check, f"{len(seen)} markers of {', '.join(families)} in "
                          f"{count} images", len(seen), "markers"), markers
            looked_for += [] if markers is None else families
        return none_of(check, looked_for, other_families(detector, looked_for), count), []
    except ProductError as fault:
        return unknown(check, str(fault), "Build the workspace."), []


def none_of(check, looked_for, others, count):
    """The Finding of that name where no marker appears of the families that were looked for."""
    if not looked_for:
        return unknown(check, "the detectors refuse these images or families",
                       "Look at the sections apriltag and aruco of the robot file.")
    text = f"no marker of {', '.join(looked_for)} in {count} images"
    if others:
        return warn(check, text, f"There are markers of {others}: name that family in "
                    "the robot file.", 0, "markers")
    return warn(check, text, "Are markers in view, flat, lit, and larger than 12 px? "
                "Else take a product without a camera.", 0, "markers")


def other_families(detector, looked_for):
    """A family that does appear, where at least two pictures, or the only one, show it."""
    images = detector.some()
    for name, families in OTHERS:
        for family in families:
            found = detector.find(name, [family], images) if family not in looked_for else None
            accepted = [marker for marker in found or [] if not marker.rejection]
            if len(accepted) >= min(2, len(images)):
                return family
    return ""
