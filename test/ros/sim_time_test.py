#!/usr/bin/python3
"""ROS time that is missing, runs, and jumps back."""
import pathlib
import sys
import threading
import time
import unittest

import rospy
from geometry_msgs.msg import TransformStamped
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node

BALL = "ice_ice_baby/scene/ball"


class Ticker:
    """Publishes /clock from `start_s` on, and the frame `hand`, at 100 Hz of wall time."""

    def __init__(self, start_s, hand_x):
        self.now_s = start_s
        self.hand_x = hand_x
        self.clock = rospy.Publisher("/clock", Clock, queue_size=10)
        self.tf = rospy.Publisher("/tf", TFMessage, queue_size=10)
        self.stop = threading.Event()
        self.thread = threading.Thread(target=self.run)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.stop.set()
        self.thread.join()

    def run(self):
        while not self.stop.wait(0.01):
            self.now_s += 0.01
            self.clock.publish(Clock(rospy.Time(self.now_s)))
            hand = TransformStamped()
            hand.header.stamp = rospy.Time(self.now_s)
            hand.header.frame_id = "world"
            hand.child_frame_id = "hand"
            hand.transform.translation.x = self.hand_x
            hand.transform.rotation.w = 1.0
            self.tf.publish(TFMessage([hand]))


class SimTime(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("sim_time_test")
        cls.node = Node()

    def assert_runs(self, hand_x):
        frame = self.node.state().frame
        self.node.when(lambda s: s.frame > frame + 30, "frames with the clock")
        with Latest("/tf", TFMessage) as tf:
            tf.wait(
                lambda m: any(
                    t.child_frame_id == BALL and abs(t.transform.translation.x - hand_x) < 1e-6
                    for t in m.transforms
                ),
                "the ball at the hand",
            )
            stamps = [
                t.header.stamp
                for m in tf.messages
                for t in m.transforms
                if t.child_frame_id == BALL
            ]
        self.assertEqual(len(stamps), len(set(stamps)), "more than one transform for a stamp")

    def test_no_clock_runs_then_jumps_back(self):
        status = self.node.diagnostic("clock", lambda s: s.level == 1)
        self.assertIn("/use_sim_time is true, but no node publishes /clock", status.message)
        self.assertEqual(self.node.state().frame, 0)
        self.assertTrue(self.node.set_temperature(temperature=10.0).success)
        with Ticker(1000.0, 0.2) as ticker:
            self.assert_runs(0.2)
            self.node.diagnostic("clock", lambda s: s.level == 0)
            ticker.hand_x = 0.1
            ticker.now_s = 500.0
            self.assert_runs(0.1)
        frame = self.node.state().frame
        time.sleep(0.3)
        self.assertLessEqual(self.node.state().frame, frame + 1)  # the clock stands still
        self.assertEqual(self.node.state().non_finite, 0)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "sim_time", SimTime)
