#!/usr/bin/python3
"""A recorded bag holds every topic, reads back, and plays into new subscribers."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
from sensor_msgs import point_cloud2
from sensor_msgs.msg import PointCloud2
from visualization_msgs.msg import MarkerArray

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node

TOPICS = ["particles", "springs", "colliders", "state", "vessels"]


class Bag(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("bag_test")

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = os.path.join(self.folder.name, "scene.bag")

    def tearDown(self):
        self.folder.cleanup()

    def record(self):
        node = Node()
        node.start()
        recorder = subprocess.Popen(
            ["rosrun", "rosbag", "record", "-O", self.path, "/tf", "/tf_static"]
            + ["/sim/" + topic for topic in TOPICS]
        )
        try:
            node.when(lambda s: all(t.subscribers for t in s.topics), "the recorder")
            node.resume()
            node.set_temperature(temperature=-5.0)
            node.when(lambda s: s.frame > 60 and s.springs > 0, "ice")
            node.pause()
        finally:
            recorder.send_signal(signal.SIGINT)
            recorder.wait(timeout=20)

    def test_record_read_replay(self):
        self.record()
        with rosbag.Bag(self.path) as bag:
            counts = {t: i.message_count for t, i in bag.get_type_and_topic_info().topics.items()}
            for topic in TOPICS:
                self.assertGreater(counts.get("/sim/" + topic, 0), 0, topic)
            self.assertIn("/tf_static", counts)
            frames = [m.frame for _, m, _ in bag.read_messages("/sim/state")]
            self.assertEqual(frames, sorted(frames))
            cloud = [m for _, m, _ in bag.read_messages("/sim/particles")][-1]
            ids = [p[0] for p in point_cloud2.read_points(cloud, ["id"])]
            self.assertEqual(sorted(ids), list(range(216)))
        with Latest("/again/particles", PointCloud2) as clouds, Latest(
            "/again/colliders", MarkerArray
        ) as colliders:
            subprocess.run(
                [
                    "rosbag",
                    "play",
                    "--delay=1",
                    "--quiet",
                    self.path,
                    "/sim/particles:=/again/particles",
                    "/sim/springs:=/again/springs",
                    "/sim/colliders:=/again/colliders",
                    "/sim/state:=/again/state",
                    "/sim/vessels:=/again/vessels",
                ],
                check=True,
                timeout=60,
            )
            self.assertGreater(len(clouds.messages), 10)
            self.assertEqual(clouds.messages[-1].width, 216)
            self.assertTrue(colliders.messages)

    def test_a_full_disk_ends_the_recording_and_nothing_else(self):
        if subprocess.run(["unshare", "-m", "true"], check=False, capture_output=True).returncode:
            self.skipTest("needs the right to mount a small disk")
        node = Node()
        mount = 'mount -t tmpfs -o size=300k tmpfs %s; exec "$0" "$@"' % self.folder.name
        recorder = subprocess.Popen(
            [
                "timeout",
                "20",
                "unshare",
                "-m",
                "sh",
                "-c",
                mount,
                "rosrun",
                "rosbag",
                "record",
                "-O",
                self.path,
                "/sim/particles",
            ],
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )
        with recorder:
            said = ""
            while "Disabling recording" not in said:  # as rosbag reports it
                line = recorder.stdout.readline()
                self.assertTrue(line, said)
                said += line
            frame = node.state().frame
            node.resume()
            node.when(lambda s: s.frame > frame + 30, "frames without a recorder")
            recorder.terminate()
        node.pause()
        self.assertEqual(node.diagnostic("solver", lambda s: True).level, 0)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "bag", Bag)
