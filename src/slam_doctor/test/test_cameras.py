# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Faults of cameras: in images and calibrations that are made, and in a simulated drive."""
import io
import unittest

from drives import diagnose, edited, Edit, faults, FOLDER, simulate, views
import numpy as np
from PIL import Image as Pillow
from PIL import ImageFilter
from sensor_msgs.msg import CameraInfo, Image
from slam_doctor.checks.camera import fault_of
from slam_doctor.record.camera import grey, ImageFault, measure

COMPRESSED = "sensor_msgs/CompressedImage"


def image(encoding, size, value=100, **others):
    """An image of 8 x 6 pixels of `size` bytes."""
    pixels = bytes([value] * (8 * 6 * size))
    return Image(**{"width": 8, "height": 6, "encoding": encoding, "step": 8 * size,
                    "data": pixels, **others})


def filtered(name, function):
    """The drive with all images changed by a function of Pillow images."""
    def change(kind, message, time):
        out = io.BytesIO()
        function(Pillow.open(io.BytesIO(message.data))).save(out, "JPEG", quality=80)
        message.data = out.getvalue()
    return edited(name, Edit((COMPRESSED,), change), views())


def covered(frame, bag):
    """A drive with black images of the camera whose frame begins so."""
    black = io.BytesIO()
    Pillow.new("L", (640, 480)).save(black, "JPEG")

    def change(kind, message, time):
        if message.header.frame_id.startswith(frame):
            message.data = black.getvalue()
    return edited(f"{frame}_covered", Edit((COMPRESSED,), change), bag)


class Encodings(unittest.TestCase):
    def test_all_that_products_take(self):
        for encoding, size in (("mono8", 1), ("rgb8", 3), ("bgr8", 3), ("rgba8", 4), ("bgra8", 4),
                               ("bayer_rggb8", 1), ("mono16", 2), ("yuv422", 2)):
            picture = grey(image(encoding, size), False)
            self.assertEqual((picture.shape, picture.min()), ((6, 8), 100), encoding)

    def test_the_brightness_of_two_bytes(self):
        pixels = bytes([0, 200] * 48)
        self.assertEqual(grey(image("mono16", 2, data=pixels), False).max(), 200)
        self.assertEqual(grey(image("mono16", 2, data=pixels, is_bigendian=1), False).max(), 0)
        self.assertEqual(grey(image("yuv422", 2, data=pixels), False).max(), 200)

    def test_others_are_refused(self):
        for bad in (image("32FC1", 4), image("", 1), image("mono8", 1, data=b"12"),
                    image("mono8", 1, step=0), image("rgb8", 1)):
            with self.assertRaises(ImageFault):
                grey(bad, False)


class Measures(unittest.TestCase):
    def test_sharpness_falls_with_blur_and_not_with_brightness(self):
        random = np.random.default_rng(1)
        coarse = np.kron(random.integers(0, 2, (12, 16)), np.ones((10, 10))) * 120 + 60
        sharp = Pillow.fromarray(coarse.astype(np.uint8))
        blurred = sharp.filter(ImageFilter.GaussianBlur(3))
        darker = Pillow.fromarray((coarse / 2).astype(np.uint8))
        values = [measure(0.0, np.array(picture)).sharpness for picture in (sharp, blurred, darker)]
        self.assertLess(values[1], 0.3 * values[0])
        self.assertAlmostEqual(values[2], values[0], delta=0.05 * values[0])

    def test_of_an_image_of_one_pixel(self):
        self.assertEqual(measure(0.0, np.zeros((1, 1), np.uint8)).black, 1.0)


class Calibration(unittest.TestCase):
    def info(self, fx=500.0, fy=500.0, cx=320.0, cy=240.0, distortion=(), **others):
        return CameraInfo(**{"width": 640, "height": 480, "distortion_model": "plumb_bob",
                             "D": list(distortion), "K": [fx, 0, cx, 0, fy, cy, 0, 0, 1], **others})

    def test_usual_ones(self):
        for info in (self.info(), self.info(distortion=[-0.3, 0.1, 0, 0, 0]),
                     self.info(cx=350.0, cy=220.0), self.info(fx=300.0, fy=301.0)):
            self.assertIsNone(fault_of(info))

    def test_those_that_cannot_be(self):
        for info, text in ((self.info(fx=0.0), "not calibrated"),
                           (self.info(fx=float("nan")), "NaN"),
                           (self.info(width=0), "size"),
                           (self.info(fx=50.0, fy=50.0), "focal length"),
                           (self.info(fy=700.0), "differ"),
                           (self.info(cx=10.0), "principal point"),
                           (self.info(distortion=[-2.0, 0, 0, 0, 0]), "folds")):
            self.assertIn(text, fault_of(info)[1])


class Views(unittest.TestCase):
    def test_a_clean_drive_has_no_faults(self):
        found = diagnose(views())
        self.assertEqual(faults(found), {})
        self.assertGreater(found["camera.markers"].value, 1)

    def test_blur(self):
        found = faults(diagnose(filtered("blur", lambda picture: picture.filter(
            ImageFilter.GaussianBlur(5)))))
        self.assertEqual(found["camera.sharpness"], "WARN")

    def test_exposure(self):
        bright = faults(diagnose(filtered("bright", lambda picture: picture.point(
            lambda value: min(255, 2 * value)))))
        self.assertIn("camera.exposure", bright)
        dark = faults(diagnose(filtered("dark", lambda picture: picture.point(
            lambda value: value // 12))))
        self.assertIn("camera.exposure", dark)

    def test_a_calibration_of_another_resolution(self):
        found = diagnose(filtered("half", lambda picture: picture.resize((320, 240))))
        self.assertEqual(found["camera.calibration"].level.name, "ERROR")
        self.assertIn("640 x 480", found["camera.calibration"].text)

    def test_damaged_images(self):
        def change(kind, message, time):
            message.data = message.data[:20]
        found = faults(diagnose(edited("cut", Edit((COMPRESSED,), change), views())))
        self.assertEqual(found["camera.images"], "ERROR")

    def test_no_calibration(self):
        bag = edited("uncalibrated", Edit((), None), views(), ("/camera/camera_info",))
        self.assertEqual(faults(diagnose(bag))["camera.calibration"], "ERROR")

    def test_frozen_images(self):
        first = {}

        def change(kind, message, time):
            message.data = first.setdefault(message.header.frame_id, message.data)
        found = faults(diagnose(edited("repeated", Edit((COMPRESSED,), change), views())))
        self.assertIn("camera.frozen", found)

    def test_another_family(self):
        robot = FOLDER / "family.yaml"
        robot.write_text("version: 1\nrobot: family\napriltag: {families: [25h9]}\n"
                         "aruco: {dictionaries: [DICT_4X4_50]}\n", encoding="utf-8")
        found = diagnose(views(), robot)["camera.markers"]
        self.assertEqual(found.level.name, "WARN")
        self.assertIn("There are markers of 36h11", found.advice)

    def test_each_camera_and_each_detector(self):
        bag = simulate("two_cameras", "--world", "foyer", "--robot", "scout", "--duration", "4",
                       "--only", "odom,camera,rear_camera")
        found = diagnose(bag, "sim_scout")
        for name in ("camera.markers", "rear_camera.markers"):
            self.assertGreater(found[name].value, 0, name)
        product = FOLDER / "two_cameras.yaml"
        product.write_text("version: 1\nbackend: ekf\nodometry: wheel\ndetector: apriltag\n"
                           "second_detector: aruco\nsecond_camera: true\n", encoding="utf-8")
        found = diagnose(covered("rear", bag), "sim_scout", product)
        levels = {name: found[name].level.name for name in found if "markers" in name}
        self.assertEqual(levels, {"camera.markers": "OK", "rear_camera.markers": "WARN",
                                  "camera.second_markers": "OK",
                                  "rear_camera.second_markers": "WARN"})

    def test_standstill_of_odometry_while_images_change(self):
        def change(kind, message, time):
            message.pose.pose.position.x = message.pose.pose.position.y = 0.0
            message.pose.pose.orientation.z, message.pose.pose.orientation.w = 0.0, 1.0
            message.twist.twist.linear.x = message.twist.twist.angular.z = 0.0
        bag = edited("stuck_images", Edit(("nav_msgs/Odometry",), change), views(), ("/scan",))
        self.assertEqual(diagnose(bag)["odom.stuck"].level.name, "WARN")


if __name__ == "__main__":
    unittest.main()
