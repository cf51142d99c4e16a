#!/usr/bin/python3
"""What is dragged in rviz moves: a container, a tap; poses that cannot be are not used."""
import math
import pathlib
import sys
import time
import unittest

import rosgraph
import rospy
from geometry_msgs.msg import Point, Pose, Quaternion
from sensor_msgs import point_cloud2
from sensor_msgs.msg import PointCloud2
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import (
    InteractiveMarkerFeedback,
    InteractiveMarkerInit,
    InteractiveMarkerUpdate,
)

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node, wait_until

SCENE = "ice_ice_baby/scene"
SPEED_M_S = 1.0  # ~tf_max_speed_m_s


class Handles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("handles_test")
        cls.node = Node()
        cls.feedback = rospy.Publisher(
            "/sim/handles/feedback", InteractiveMarkerFeedback, queue_size=10
        )
        wait_until(lambda: cls.feedback.get_num_connections() > 0, "the server of the markers")

    def drag(self, marker, x, frame=SCENE, w=1.0):
        message = InteractiveMarkerFeedback(client_id="test", marker_name=marker)
        message.header.frame_id = frame
        message.event_type = InteractiveMarkerFeedback.POSE_UPDATE
        message.pose = Pose(Point(x, 0.0, 0.0), Quaternion(0.0, 0.0, 0.0, w))
        self.feedback.publish(message)

    def container_x(self, tf):
        """(stamp, x) of the container in each message."""
        return [
            (t.header.stamp.to_sec(), t.transform.translation.x)
            for message in list(tf.messages)
            for t in message.transforms
            if t.child_frame_id == SCENE + "/container"
        ]

    def test_1_every_part_without_a_frame_has_a_marker(self):
        with Latest("/sim/handles/update_full", InteractiveMarkerInit) as markers:
            found = markers.wait().markers
        self.assertEqual(
            {m.name for m in found}, {"collider container", "source tap", "source hose"}
        )
        self.assertEqual({m.header.frame_id for m in found}, {SCENE})
        tap = next(m for m in found if m.name == "source tap")
        self.assertAlmostEqual(tap.pose.position.z, 0.5)

    def test_2_a_container_goes_where_it_is_dragged_no_faster_than_allowed(self):
        with Latest("/tf", TFMessage) as tf:
            tf.wait(lambda m: self.container_x(tf), "the container on /tf")
            self.drag("collider container", 0.6)
            wait_until(
                lambda: abs(self.container_x(tf)[-1][1] - 0.6) < 1e-6, "the container at 0.6 m"
            )
            places = [x for _, x in self.container_x(tf)]
        self.assertTrue(any(0.1 < x < 0.5 for x in places))  # it did not jump
        steps = [b - a for a, b in zip(places, places[1:])]
        self.assertGreaterEqual(min(steps), -1e-9)
        self.assertLessEqual(max(steps), 2 * SPEED_M_S / 60 + 1e-6)  # a message may be missing
        self.drag("collider container", 0.0)
        self.assertEqual(self.node.state().non_finite, 0)

    def test_3_a_tap_pours_where_it_is_dragged(self):
        self.drag("source tap", -0.1)
        time.sleep(2.0)
        self.assertTrue(self.node.set_source(name="tap", open=True).success)
        with Latest("/sim/particles", PointCloud2) as clouds:
            cloud = clouds.wait(lambda c: c.width >= 8, "water")
        self.node.set_source(name="tap", open=False)
        for x, z in point_cloud2.read_points(cloud, ["x", "z"]):
            self.assertAlmostEqual(x, -0.1, delta=0.15)
            self.assertLess(abs(z), 0.6)

    def test_4_poses_that_cannot_be_are_not_used(self):
        self.node.start("tap")
        self.node.resume()
        with Latest("/tf", TFMessage) as tf:
            self.drag("collider container", math.nan)
            self.drag("collider container", 0.3, frame="world")
            self.drag("collider container", 0.3, w=0.2)
            self.drag("collider nobody", 0.3)
            time.sleep(1.0)
            self.assertEqual({x for _, x in self.container_x(tf)}, {0.0})
        with Latest("/sim/handles/update", InteractiveMarkerUpdate) as updates:
            self.drag("collider container", 1e6)
            wait_until(
                lambda: any(
                    p.name == "collider container" and abs(p.pose.position.x) < 150.0
                    for m in list(updates.messages)
                    for p in m.poses
                ),
                "the marker back at the container",
            )
        self.assertEqual(self.node.state().non_finite, 0)

    def test_5_without_the_parameter_there_is_no_topic(self):
        published = rosgraph.Master("/handles_test").getSystemState()[0]
        names = [name for name, _ in published]
        self.assertIn("/sim/handles/update", names)
        self.assertIn("/plain/sim/state", names)
        self.assertFalse([name for name in names if name.startswith("/plain/sim/handles")])


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "handles", Handles)
