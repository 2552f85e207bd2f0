# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A calibration that does not fit the markers in the images is found, and one that does passes:
with corners that are made, where all is known, and in simulated drives."""
import dataclasses
import io
import math
import unittest

from drives import diagnose, edited, Edit, simulate
import numpy as np
from PIL import Image as Pillow
from PIL import ImageFilter
from sensor_msgs.msg import CameraInfo
from slam_doctor.checks import reprojection
from slam_doctor.squares import calibration, poses
from slam_doctor.squares.calibration import Sighting
from slam_doctor.squares.camera import Camera, camera_of

SIZE = (640, 480)
D = np.array([0.12, -0.25, 0.001, -0.0005, 0.0, 0.0, 0.0, 0.0])
FISHEYE = np.array([-0.03, 0.005, -0.001, 0.0, 0.0, 0.0, 0.0, 0.0])
COMPRESSED, CALIBRATION = "sensor_msgs/CompressedImage", "sensor_msgs/CameraInfo"


def camera(fx=540.0, fy=540.0, cx=321.0, cy=239.0, distortion=D, is_equidistant=False):
    """A camera of usual size."""
    return Camera(np.array([fx, fy]), np.array([cx, cy]), distortion, SIZE, is_equidistant)


def views(true, seed, count=80, sigma=0.1, corners=poses.CORNERS, bend=0.0, spread=0.6):
    """Sightings of 12 markers; sigma: noise of a corner [px]; spread: of the places;
    bend: how far a marker's corners are out of place, in each view the same [edges]."""
    random = np.random.default_rng(seed)
    bent = bend * random.normal(size=(12, 4, 3))
    found = []
    while len(found) < count:
        identity = int(random.integers(12))
        turned = poses.rotation(np.array([math.pi, 0.0, 0.0]))[0] @ \
            poses.rotation(random.uniform(-1.0, 1.0, 3))[0]
        distance = random.uniform(4.0, 20.0)
        place = distance * np.array([*random.uniform(-spread, spread, 2), 1.0])
        points = (np.c_[corners, np.zeros(4)] + bent[identity]) @ turned.T + place
        pixels = true.image(points[:, :2] / points[:, 2:])
        if (pixels > 5).all() and (pixels < np.array(SIZE) - 5).all():
            found.append(Sighting(identity, pixels + random.normal(0.0, sigma, (4, 2))))
    return found


def info_of(some):
    """The camera_info of a Camera."""
    (fx, fy), (cx, cy) = some.focal, some.centre
    model = "equidistant" if some.is_equidistant else "plumb_bob"
    return CameraInfo(width=SIZE[0], height=SIZE[1], distortion_model=model,
                      D=list(some.distortion[:4 if some.is_equidistant else 5]),
                      K=[fx, 0, cx, 0, fy, cy, 0, 0, 1])


class Cameras(unittest.TestCase):
    def test_images_by_hand(self):
        plain = camera(500.0, 400.0, 320.0, 240.0, np.array([0.4, 0, 0.01, 0.02, 0, 0, 0, 0]))
        # s = 0.25, factor 1.1; the tangential part is p2 (s + 2 x x) and p1 s
        self.assertTrue(np.allclose(plain.image(np.array([0.5, 0.0])),
                                    [320 + 500 * (0.55 + 0.015), 240 + 400 * 0.0025]))
        fisheye = camera(500.0, 400.0, 320.0, 240.0, np.zeros(8), True)
        self.assertTrue(np.allclose(fisheye.image(np.array([0.0, 1.0])),
                                    [320, 240 + 100 * math.pi]))

    def test_rays_are_the_inverse_of_images(self):
        for some in (camera(), camera(distortion=FISHEYE, is_equidistant=True)):
            pixels = calibration.border(some)
            self.assertLess(np.abs(some.image(some.rays(pixels)) - pixels).max(), 1e-6)

    def test_of_a_message(self):
        for some in (camera(), camera(distortion=FISHEYE, is_equidistant=True)):
            again = camera_of(info_of(some))
            self.assertTrue(np.allclose(again.image(np.array([0.3, 0.2])),
                                        some.image(np.array([0.3, 0.2]))))


class Poses(unittest.TestCase):
    def test_are_found_exactly_without_noise(self):
        for some in (camera(), camera(distortion=FISHEYE, is_equidistant=True)):
            seen = views(some, 1, sigma=0.0)
            _, left = poses.find(some, np.array([each.corners for each in seen]))
            self.assertLess(np.abs(left).max(), 1e-4)

    def test_by_hand(self):
        # upright at 10 edges, its front to the camera: x to the right, y up in the image
        ideal = camera(500.0, 500.0, 320.0, 240.0, np.zeros(8))
        corners = np.array([[[295.0, 215.0], [345.0, 215.0], [345.0, 265.0], [295.0, 265.0]]])
        (turned, position), _ = poses.find(ideal, corners)
        self.assertTrue(np.allclose(turned[0], np.diag([1.0, -1.0, -1.0]), atol=1e-3))
        self.assertTrue(np.allclose(position[0], [0.0, 0.0, 10.0], atol=1e-3))

    def test_derivatives_are_those_of_the_projection(self):
        some, step = camera(), np.array([1e-4, -2e-4, 1e-4, 2e-4, -1e-4, 3e-4])
        pose, _ = poses.find(some, np.array([each.corners for each in views(some, 2, 5)]))
        shift = (poses.image(some, poses.moved(pose, step)) - poses.image(some, pose)).reshape(5, 8)
        self.assertLess(np.abs(shift - poses.jacobian(some, pose) @ step).max(), 1e-4)


class Fits(unittest.TestCase):
    WRONG = {"focal length 5 % too long": {"fx": 567.0, "fy": 567.0},
             "fx 5 % too long": {"fx": 567.0}, "principal point": {"cx": 351.0, "cy": 219.0},
             "another lens": {"distortion": np.array([-0.25, 0.08, 0, 0, 0, 0, 0, 0])}}

    def level(self, some, seen):
        return reprojection.judge("camera.reprojection", info_of(some), seen).level.name

    def test_a_right_calibration_passes_whatever_the_noise(self):
        for sigma in (0.02, 0.1, 0.25, 0.6):
            for seed in range(4):
                self.assertIn(self.level(camera(), views(camera(), seed, sigma=sigma)),
                              ("OK", "UNKNOWN"), (sigma, seed))

    def test_the_change_is_as_large_as_its_covariance_says(self):
        values = [calibration.fit(camera(), views(camera(), seed, sigma=0.2)).chi_square
                  for seed in range(12)]
        self.assertLess(np.mean(values), 9.0)  # 6 degrees of freedom, a cautious covariance
        self.assertGreater(np.mean(values), 1.0)

    def test_wrong_calibrations_are_found_with_their_size(self):
        for name, values in self.WRONG.items():
            wrong = camera(**values)
            for seed in (1, 2):
                seen = views(camera(), seed, 120)
                self.assertIn(self.level(wrong, seen), ("WARN", "ERROR"), name)
                fit = calibration.fit(wrong, seen)
                rays = wrong.rays(calibration.border(wrong))
                true = np.linalg.norm(camera().image(rays) - wrong.image(rays), axis=1).max()
                self.assertAlmostEqual(fit.off, true, delta=4 * fit.sigma, msg=name)
                again = calibration.changed(wrong, fit.change)
                self.assertAlmostEqual(again.focal[0], 540.0, delta=11.0, msg=name)

    def test_of_a_fisheye_lens(self):
        true = camera(300.0, 300.0, distortion=FISHEYE, is_equidistant=True)
        wider = dataclasses.replace(true, focal=true.focal * [1.05, 1.0])
        seen = views(true, 1, 400, spread=0.8)
        self.assertIn(self.level(true, seen), ("OK", "UNKNOWN"))
        self.assertIn(self.level(wider, seen), ("WARN", "ERROR"))

    def test_more_noise_says_less(self):
        sigmas = [calibration.fit(camera(), views(camera(), 1, sigma=sigma)).sigma
                  for sigma in (0.1, 0.4)]
        self.assertGreater(sigmas[1], 2 * sigmas[0])
        self.assertEqual(self.level(camera(), views(camera(), 1, sigma=2.0)), "UNKNOWN")

    def test_one_view_again_and_again_says_no_more(self):
        seen = views(camera(), 1, 40, sigma=0.2)
        once, often = (calibration.fit(camera(), some).sigma for some in (seen, seen * 10))
        self.assertAlmostEqual(once, often, delta=0.3 * once)

    def test_bent_markers_and_printers_that_stretch_are_no_fault_of_the_camera(self):
        for seed in range(4):
            seen = views(camera(), seed, bend=0.004)  # 0.6 mm of 16 cm
            self.assertIn(self.level(camera(), seen), ("OK", "UNKNOWN"), seed)
            stretched = views(camera(), seed, corners=poses.CORNERS * [1.005, 1.0])
            self.assertIn(self.level(camera(), stretched), ("OK", "UNKNOWN"), seed)

    def test_false_detections_do_not_count(self):
        random = np.random.default_rng(1)
        for seed in range(4):
            seen = views(camera(), seed)
            for each in seen[:4]:  # quadrangles of another shape
                seen.append(Sighting(3, each.corners + random.uniform(-8, 8, (4, 2))))
            self.assertIn(self.level(camera(), seen), ("OK", "UNKNOWN"), seed)

    def test_small_markers_of_which_noise_looks_like_perspective(self):
        seen = [dataclasses.replace(each, corners=each.corners.mean(axis=0) + 0.25 * (
            each.corners - each.corners.mean(axis=0))) for each in views(camera(), 1)]
        self.assertLess(len(calibration.usable(seen)), 20)
        self.assertEqual(self.level(camera(), seen), "UNKNOWN")

    def test_too_few(self):
        found = reprojection.judge("camera.reprojection", info_of(camera()), views(camera(), 1, 10))
        self.assertEqual(found.level.name, "UNKNOWN")
        self.assertIn("different views are too few to check the calibration", found.text)
        alone = [dataclasses.replace(each, id=7) for each in views(camera(), 1)]
        found = reprojection.judge("camera.reprojection", info_of(camera()), alone)
        self.assertIn("1 markers in", found.text)

    def test_corners_that_no_square_has(self):
        random = np.random.default_rng(1)
        for make in (lambda: np.full((4, 2), random.uniform(0, 400)),
                     lambda: random.uniform(0, 400, (4, 2)),
                     lambda: np.c_[np.arange(4.0) * 10, np.arange(4.0) * random.uniform(0, 50)]):
            odd = [Sighting(number % 12, make()) for number in range(80)]
            self.assertEqual(self.level(camera(), odd), "UNKNOWN")


def drive():
    """A drive round the office with the camera that looks ahead."""
    return simulate("looks", "--only", "odom,camera")


def with_calibration(name, change):
    """The drive with a camera_info that change(message) has altered."""
    return edited(name, Edit((CALIBRATION,), lambda kind, message, time: change(message)), drive())


def with_images(name, function):
    """The drive with images that a function of Pillow images has altered."""
    def change(kind, message, time):
        out = io.BytesIO()
        function(Pillow.open(io.BytesIO(message.data)).convert("L")).save(out, "JPEG", quality=80)
        message.data = out.getvalue()
    return edited(name, Edit((COMPRESSED,), change), drive())


class Drives(unittest.TestCase):
    def found(self, bag):
        return diagnose(bag)["camera.reprojection"]

    def scaled(self, fx, fy):
        def change(message):
            if "ceiling" not in message.header.frame_id:
                message.K = [k * s for k, s in zip(message.K, (fx, 1, 1, 1, fy, 1, 1, 1, 1))]
        return change

    def test_a_right_calibration_fits(self):
        found = self.found(drive())
        self.assertEqual(found.level.name, "OK", found.text)
        self.assertLess(found.value, 4.0)

    def test_a_focal_length_that_is_off(self):
        found = self.found(with_calibration("long", self.scaled(1.05, 1.05)))
        self.assertIn(found.level.name, ("WARN", "ERROR"), found.text)
        self.assertIn("the calibration does not fit the corners of", found.text)
        self.assertIn("Calibrate again (camera_calibration)", found.advice)
        found = self.found(with_calibration("wide", self.scaled(1.04, 1.0)))
        self.assertIn(found.level.name, ("WARN", "ERROR"), found.text)

    def test_the_distortion_of_another_lens(self):
        def change(message):
            message.D = [-0.25, 0.08, 0.0, 0.0, 0.0]
        self.assertEqual(self.found(with_calibration("barrel", change)).level.name, "ERROR")

    def test_images_with_blur_and_noise_pass(self):
        random = np.random.default_rng(1)

        def noisy(picture):
            values = np.asarray(picture.filter(ImageFilter.GaussianBlur(1.2)), float)
            values = values + random.normal(0.0, 12.0, values.shape)
            return Pillow.fromarray(np.clip(values, 0, 255).astype(np.uint8))
        for name, function in (("soft", lambda picture: picture.filter(
                ImageFilter.GaussianBlur(2.0))), ("noisy", noisy)):
            found = self.found(with_images(name, function))
            self.assertIn(found.level.name, ("OK", "UNKNOWN"), f"{name}: {found.text}")


if __name__ == "__main__":
    unittest.main()
