#!/usr/bin/python3
"""A collider follows a tf frame; if that is missing, it does not move and a warning says so."""
import itertools
import math
import pathlib
import sys
import time
import unittest

import rosgraph
import rospy
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import TransformStamped
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node, wait_until

BALL = "ice_ice_baby/scene/ball"


class Follow(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("follow_test")
        cls.node = Node()
        cls.tf = rospy.Publisher("/tf", TFMessage, queue_size=10)

    def put_hand(self, x, w=1.0):
        """Publishes the frame `hand` in `world`; w is the scalar part of its rotation."""
        hand = TransformStamped()
        hand.header.stamp = rospy.Time.now()
        hand.header.frame_id = "world"
        hand.child_frame_id = "hand"
        hand.transform.translation.x = x
        hand.transform.rotation.w = w
        self.tf.publish(TFMessage([hand]))

    def test_1_missing_frame_is_a_warning(self):
        status = self.node.diagnostic("followed frames", lambda s: s.level == 1)
        self.assertIn("ball", status.message)
        self.assertIn("hand", status.message)
        self.assertGreater(self.node.state().frame, 0)  # it runs anyway

    def carry_hand(self, tf, x):
        """Publishes the hand at x until the ball is 0.2 m above it; the scene is at x = 0.1 m."""

        def ball_there():
            self.put_hand(x)
            return [
                t
                for m in tf.messages[-20:]
                for t in m.transforms
                if t.child_frame_id == BALL
                and abs(t.transform.translation.x - (x - 0.1)) < 1e-6
                and abs(t.transform.translation.z - 0.2) < 1e-6
            ]

        return wait_until(ball_there, "the ball at the hand")[0]

    def test_2_follows(self):
        with Latest("/tf", TFMessage) as tf, Latest("/sim/colliders", MarkerArray) as arrays:
            for x in (0.2, -0.15):
                found = self.carry_hand(tf, x)
                self.assertEqual(found.header.frame_id, "ice_ice_baby/scene")
                arrays.wait(
                    lambda a: any(
                        m.ns == "ball" and abs(m.pose.position.x - (x - 0.1)) < 1e-6
                        for m in a.markers
                    ),
                    "the drawn ball",
                )
        self.node.diagnostic("followed frames", lambda s: s.level == 0)
        state = self.node.state()
        self.assertEqual(state.non_finite, 0)

    def test_3_a_pose_out_of_range_is_a_warning(self):
        self.put_hand(1e7)
        status = self.node.diagnostic("followed frames", lambda s: s.level == 1)
        self.assertIn("outside", status.message)

    def test_4_a_transform_that_tf_drops_is_a_warning(self):
        for x, w, why in (
            (math.nan, 1.0, "its translation is not finite"),
            (0.1, 2.0, "the length of its rotation is 2"),
            (0.1, math.nan, "its rotation is not finite"),
        ):
            self.put_hand(x, w)
            status = self.node.diagnostic("followed frames", lambda s: why in s.message)
            self.assertEqual(status.level, 1)
            self.assertIn("tf frame hand cannot be used", status.message)
            self.assertIn("sent by " + rospy.get_name(), status.message)
            self.put_hand(0.2)
            self.node.diagnostic("followed frames", lambda s: s.level == 0)
        self.assertEqual(self.node.state().non_finite, 0)

    def test_5_a_reset_that_fails_keeps_the_listener(self):
        self.assertFalse(self.node.reset(scene="none", preset="").success)
        time.sleep(2.5)  # the node checks every 2 s
        subscribers = dict(rosgraph.Master("/follow_test").getSystemState()[1])
        self.assertIn("/sim", subscribers["/tf"])
        self.test_2_follows()

    def test_6_a_scene_without_followers_does_not_listen(self):
        self.assertTrue(self.node.reset(scene="small", preset="").success)

        def listens():
            return "/sim" in dict(rosgraph.Master("/follow_test").getSystemState()[1]).get(
                "/tf", []
            )

        wait_until(lambda: not listens(), "the end of listening")
        self.assertTrue(self.node.reset(scene="followed", preset="").success)
        wait_until(listens, "listening")

    def test_7_only_what_is_beyond_the_speed_limit_is_a_jump(self):
        with Latest("/tf", TFMessage) as tf:
            self.carry_hand(tf, 0.1)
            status = self.node.diagnostic("followed frames", lambda s: s.level == 0)
            before = status.values[0].value
            for k in range(20):
                self.carry_hand(tf, 0.1 + 0.05 * k)  # 3 m/s at the least
            status = self.node.diagnostic("followed frames", lambda s: s.level == 0)
            self.assertEqual(status.values[0].value, before)
            self.put_hand(1.05)  # shortly before, so that it is a jump and no gap
            self.carry_hand(tf, 4.0)
        status = self.node.diagnostic("followed frames", lambda s: s.values[0].value != before)
        self.assertIn("collider ball jumped 2.95 m with tf frame hand", status.message)
        self.assertEqual(self.node.state().non_finite, 0)

    def test_8_what_is_bounded_is_told(self):
        with Latest("/diagnostics", DiagnosticArray) as told, Latest("/tf", TFMessage) as tf:
            self.carry_hand(tf, 4.0)
            there_and_back = itertools.cycle([3.6, 4.0])  # too near for a jump, faster than 5 m/s

            def bounded():
                self.put_hand(next(there_and_back))
                return next(
                    (
                        s
                        for m in told.messages
                        for s in m.status
                        if s.name == "sim: followed frames" and "rad behind" in s.message
                    ),
                    None,
                )

            status = wait_until(bounded, "a warning about the bounds")
        self.assertEqual(status.level, 1)
        self.assertIn("behind tf frame hand", status.message)
        self.assertIn("~tf_max_speed_m_s", status.message)
        keys = [v.key for v in status.values]
        for key in ("ball age [s]", "ball rate [Hz]", "ball delay [s]"):
            self.assertIn(key, keys)

    def test_9_water_slower_than_a_robot_is_a_warning(self):
        slow = Node("/slow/sim")
        slow.when(lambda s: s.frame > 60, "a second of simulated time")
        status = slow.diagnostic("real time", lambda s: s.level == 1)
        self.assertRegex(status.message, "a robot on tf is 3.[0-9]* times as fast for the water")
        self.assertIn("~publish_clock", status.message)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "follow", Follow)
