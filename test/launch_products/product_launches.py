# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Launches products of the feature model on a few seconds of the foyer: they publish what their
features promise."""

from concurrent.futures import ThreadPoolExecutor
import pathlib
import subprocess
import tempfile

from launching import program, record_launch
import rosbag
import rospkg
from slam_launch import products
from slam_launch.feature_model import FeatureModel, text
import yaml

SECONDS = 2  # of the drive, replayed at the robot's own speed
MASTERS = 3  # at a time: a launch mostly waits
SECOND, REAR = "/second_observations", "/rear_observations"
REAR_SECOND = "/rear_second_observations"
STAGES = {"rat": {"/local_view", "/pose_cells"}}  # before a back-end
BETWEEN = {"/motion", "/observations", SECOND, REAR, REAR_SECOND}.union(
    *STAGES.values())  # components, each in a nodelet
ALWAYS = {"/pose", "/path", "/tf"}
LANDMARKS = {"/landmarks", "/landmark_markers"}
PROMISED = {"backend=ekf": LANDMARKS,
            "backend=graph": {"/graph_markers", *LANDMARKS},
            "backend=mono_ekf": {"/features"},
            "backend=mono_graph": {"/features", "/graph_markers"},
            "backend=pf": {"/particlecloud", *LANDMARKS},
            "backend=rat": {"/graph_markers"},
            "backend=seif": LANDMARKS,
            "pointmap=true": {"/points"},
            "map=grid": {"/map", "/map_metadata"},
            "odometry=command": {"/command_odometry/odom"},
            "odometry=visual": {"/visual_odometry/odom"},
            "odometry=visual_wheel": {"/visual_odometry/odom"},
            "odometry=visual_imu": {"/visual_odometry/odom"},
            "odometry=laser": {"/laser_odometry/odom"},
            "odometry=laser_wheel": {"/laser_odometry/odom"},
            "odometry=laser_imu": {"/laser_odometry/odom"}}
LOOK_THEMSELVES = {"mono_ekf", "mono_graph", "rat"}  # back-ends that take in images
MADE_OF = {"detector": ("/observations", "/camera/"), "odometry": ("/motion", "/odom")}
RECORDED = ALWAYS.union(BETWEEN, *PROMISED.values())


def promised(features, composition):
    named = [f"{key}={value}" for key, value in features.items()]
    own = ALWAYS.union(*(PROMISED.get(name, set()) for name in named))
    return own | between(features) if composition == "pubsub" else own


def between(features):
    """Returns what components exchange: the grid back-end and those of images take in no
    observations; the grid back-end and a graph with a grid take in motion only where there is an
    odometry source. Stages before a back-end make data of their own."""
    is_grid = features["backend"] == "grid"
    scans_tell_motion = is_grid or features["backend"] == "graph" and features["map"] == "grid"
    has_motion = features["odometry"] != "none" or not scans_tell_motion
    takes_none = is_grid or features["backend"] in LOOK_THEMSELVES
    return (observations(features, takes_none) | STAGES.get(features["backend"], set()) |
            ({"/motion"} if has_motion else set()))


def observations(features, takes_none):
    """Returns what the product's detectors make, each of its own."""
    has_second, has_rear = features["second_detector"] != "none", features["second_camera"] == "true"
    made = {"/observations": not takes_none, SECOND: has_second, REAR: has_rear,
            REAR_SECOND: has_second and has_rear}
    return {topic for topic, is_made in made.items() if is_made}


def published(record):
    """Returns the topics of a bag; of /tf only where it holds map -> odom."""
    with rosbag.Bag(str(record)) as bag:
        topics = {topic for topic, message, _ in bag.read_messages() if topic != "/tf"}
        corrections = [True for _, message, _ in bag.read_messages(topics=["/tf"])
                       for edge in message.transforms if edge.header.frame_id == "map"]
    return topics | ({"/tf"} if corrections else set())


def simulate(path):
    """Writes a bag of the robot scout, which has two cameras, with the rear laser of twin."""
    robots = pathlib.Path(rospkg.RosPack().get_path("slam_sim")) / "robots"
    scout, twin = (yaml.safe_load((robots / f"{name}.yaml").read_text(encoding="utf-8"))
                   for name in ("scout", "twin"))
    robot = path.with_suffix(".yaml")
    robot.write_text(yaml.safe_dump({**scout, "rear_laser": twin["rear_laser"]}), encoding="utf-8")
    subprocess.run([program("slam_sim", "slam_sim"), path, "--world", "foyer", "--robot", robot,
                    "--duration", str(SECONDS), "--only",
                    "odom,scan,rear_scan,imu,commands,camera,rear_camera,ceiling_camera"], check=True,
                   stdout=subprocess.DEVNULL)


def with_made(bag, record, path, made_of):
    """Writes a bag that has recorded topics instead of what they were made of."""
    with rosbag.Bag(str(bag)) as sensors, rosbag.Bag(str(record)) as made, \
            rosbag.Bag(str(path), "w") as both:
        messages = [entry for entry in sensors.read_messages()
                    if not entry.topic.startswith(tuple(made_of.values()))]
        if made_of:  # without a topic all would be read
            messages += made.read_messages(topics=list(made_of))
        for topic, message, stamp in sorted(messages, key=lambda entry: entry.timestamp.to_nsec()):
            both.write(topic, message, stamp)


class ProductLaunches:
    """For a TestCase."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = pathlib.Path(folder.name)
        simulate(cls.root / "images.bag")
        record_launch("ekf_wheel", cls.root / "images.bag", cls.root / "made.bag", RECORDED)
        cls.model = FeatureModel()

    def bag_for(self, number, features):
        """A product without a detector or odometry needs what others made; some back-ends need
        images."""
        made_of = {topic: sensors for key, (topic, sensors) in MADE_OF.items()
                   if features[key] == "none"
                   and not (key == "detector" and features["backend"] in LOOK_THEMSELVES)}
        path = self.root / f"{number}_sensors.bag"
        with_made(self.root / "images.bag", self.root / "made.bag", path, made_of)
        return path

    def launch(self, number, features, bag):
        """Launches a product; returns its composition, the bag that it recorded and what it
        printed."""
        composition = ("pubsub", "inprocess")[number % 5 == 4]
        product = self.root / f"{number}.yaml"
        product.write_text(yaml.safe_dump(products.without_file(features, self.model).content),
                           encoding="utf-8")
        record = self.root / f"{number}.bag"
        output = record_launch(product, bag, record, RECORDED, composition)
        return composition, record, output

    def assert_publish_what_they_promise(self, tried):
        # bags are read here only: the classes of messages are not made by several threads at once
        bags = [self.bag_for(number, features) for number, features in enumerate(tried)]
        with ThreadPoolExecutor(MASTERS) as masters:
            launches = list(masters.map(self.launch, range(len(tried)), tried, bags))
        for features, (composition, record, output) in zip(tried, launches):
            with self.subTest(text(features), composition=composition):
                # a bag may bring observations
                inputs = BETWEEN if composition == "inprocess" else set()
                topics = published(record) if record.exists() else set()
                self.assertEqual(topics - inputs, promised(features, composition), output)
                self.assertNotIn("exit code -", output)  # of a crash
