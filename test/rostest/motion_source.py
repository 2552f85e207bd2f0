# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What every odometry source that makes motion of a sensor publishes, and how a test hears it."""

import os
import subprocess
import tempfile
import threading
import time

from catkin.find_in_workspaces import find_in_workspaces
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
import numpy
from player import wait_for
import rosbag
from rosgraph_msgs.msg import Log
import rospy
from slam_msgs.msg import Motion
from tf2_msgs.msg import TFMessage


def simulated(seconds, topics):
    """Returns the (topic, message) of a simulated drive with some of its topics."""
    program = find_in_workspaces(["libexec"], "slam_sim", "slam_sim", first_match_only=True)[0]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "drive.bag")
        subprocess.run([program, path, "--duration", str(seconds), "--only", topics],
                       check=True, stdout=subprocess.DEVNULL)
        with rosbag.Bag(path) as bag:
            return [(topic, message) for topic, message, _ in bag.read_messages()]


class MotionSource:
    """For a TestCase whose tests go on from one another in the order of their numbers. SOURCE is the
    odometry source's name, of its topics as well; the launch file starts a second one beside it,
    whose odometry is `compared/odom`."""

    SOURCE = None

    @classmethod
    def connect(cls, kinds, before):
        """Publishes the topics of kinds, and first of all those messages that come before the
        sensor's data."""
        cls.odometry = f"{cls.SOURCE}_odometry/odom"
        outputs = {"motion": Motion, cls.odometry: Odometry, "compared/odom": Odometry,
                   "/tf": TFMessage, "/rosout": Log, "/diagnostics": DiagnosticArray}
        cls.lock = threading.Lock()
        cls.received = {}
        cls.publishers = {topic: rospy.Publisher(topic, kind, queue_size=100,
                                                 latch=topic == "/tf_static")
                          for topic, kind in kinds.items()}
        cls.transforms = rospy.Publisher("/tf", TFMessage, queue_size=10)
        cls.subscribers = [rospy.Subscriber(topic, kind, cls.keep, topic, queue_size=1000)
                           for topic, kind in outputs.items()]
        cls.connected = wait_for(lambda: all(p.get_num_connections() > 0
                                             for p in cls.publishers.values()), 30)
        cls.connected &= wait_for(lambda: all(s.get_num_connections() > 0
                                              for s in cls.subscribers[:3]), 30)
        time.sleep(0.5)  # a nodelet advertises before it subscribes
        for topic, message in before:
            cls.publishers[topic].publish(message)
        time.sleep(1.0)

    @classmethod
    def keep(cls, message, topic):
        with cls.lock:
            cls.received.setdefault(topic, []).append(message)

    def get(self, topic):
        with self.lock:
            return list(self.received.get(topic, []))

    def motions(self, count):
        self.assertTrue(wait_for(lambda: len(self.get("motion")) >= count),
                        f"{len(self.get('motion'))} motions came")
        return self.get("motion")

    def values(self):
        """The newest diagnostic of the nodelet."""
        for array in reversed(self.get("/diagnostics")):
            for status in array.status:
                if status.name.startswith(f"{self.SOURCE}_odometry"):
                    return {"message": status.message,
                            **{entry.key: entry.value for entry in status.values}}
        return {}

    def has_warned(self, text):
        return wait_for(lambda: any(text in log.msg for log in self.get("/rosout")))

    def edges(self):
        """The transforms of the robot's base."""
        return [t for m in self.get("/tf") for t in m.transforms if t.child_frame_id == "base_link"]

    def assert_motions_end_at(self, stamps):
        motions = self.motions(len(stamps))
        self.assertEqual([m.sequence for m in motions], list(range(len(stamps))))
        self.assertEqual([m.end for m in motions], stamps)
        for motion in motions:
            covariance = numpy.array(motion.covariance).reshape(3, 3)
            self.assertGreater(numpy.linalg.eigvalsh(covariance).min(), 0)
        self.assertEqual({(m.header.frame_id, m.child_frame_id) for m in motions},
                         {("odom", "base_link")})

    def assert_odometry_and_transform_tell_the_way(self, count):
        self.assertTrue(wait_for(lambda: len(self.get(self.odometry)) >= count))
        odometry, end = self.get(self.odometry)[-1], self.get("motion")[-1].odometry_end
        self.assertEqual((odometry.header.frame_id, odometry.child_frame_id),
                         ("odom", "base_link"))
        self.assertAlmostEqual(odometry.pose.pose.position.x, end.x)
        self.assertAlmostEqual(odometry.pose.pose.position.y, end.y)
        self.assertGreater(odometry.pose.covariance[0], 0)
        self.assertTrue(wait_for(self.edges), "no transform came")
        self.assertAlmostEqual(self.edges()[-1].transform.translation.x, end.x)
        stamps = [edge.header.stamp for edge in self.edges()]
        self.assertTrue(all(a < b for a, b in zip(stamps, stamps[1:])))

    def let_another_publish_the_transform(self, stamp):
        edge = TransformStamped(child_frame_id="base_link")
        edge.header.frame_id = "odom"
        edge.header.stamp = stamp
        edge.transform.rotation.w = 1.0
        self.transforms.publish(TFMessage([edge]))
        time.sleep(0.5)

    def assert_keeps_a_frame_of_its_own(self, count):
        self.assertEqual(self.motions(count)[-1].header.frame_id, f"{self.SOURCE}_odom")
        self.assertTrue(self.has_warned(f"{self.SOURCE}_odom"))

    def assert_the_second_one_tells_only_its_own(self, count, delta):
        """delta: by how much the odometry of both may differ [m]."""
        self.assertTrue(wait_for(lambda: len(self.get("compared/odom")) >= count),
                        len(self.get("compared/odom")))
        compared = self.get("compared/odom")
        self.assertEqual({(m.header.frame_id, m.child_frame_id) for m in compared},
                         {(f"{self.SOURCE}_odom", "base_link")})
        ours = {m.header.stamp: m.pose.pose.position for m in self.get(self.odometry)}
        self.assertEqual([m.header.stamp for m in compared], sorted(ours))
        for message in compared:
            self.assertAlmostEqual(message.pose.pose.position.x, ours[message.header.stamp].x,
                                   delta=delta)
        self.assertEqual(len(self.motions(count)), count, "it publishes no motion")
