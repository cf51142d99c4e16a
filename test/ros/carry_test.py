#!/usr/bin/python3
"""A cup of water that a robot in simulated time carries: placed where its frame is, then moved with
it stamp by stamp, at any real-time factor."""
import pathlib
import sys
import threading
import unittest

import numpy as np
import rospy
from geometry_msgs.msg import TransformStamped
from rosgraph_msgs.msg import Clock
from sensor_msgs import point_cloud2
from sensor_msgs.msg import PointCloud2
from tf2_msgs.msg import TFMessage

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node, wait_until

CUP = "ice_ice_baby/scene/cup"
PARTICLES = 384


class Robot:
    """Sends the frame `gripper` for the stamps of /clock after `start_s`, at least `interval_s`
    apart. So its first pose is a teleport from where the robot before it was."""

    def __init__(self, start_s, path, interval_s=0.0):
        self.start_s = start_s
        self.path = path
        self.interval_s = interval_s
        self.sent = None
        self.silent = threading.Event()
        self.tf = rospy.Publisher("/tf", TFMessage, queue_size=100)
        wait_until(self.tf.get_num_connections, "a listener on /tf")
        self.clock = rospy.Subscriber("/clock", Clock, self.tick)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.clock.unregister()

    def tick(self, message):
        now = message.clock
        if self.silent.is_set() or now == self.sent or now.to_sec() <= self.start_s:
            return
        if self.sent and 0 <= (now - self.sent).to_sec() < self.interval_s - 1e-6:
            return
        self.sent = now
        gripper = TransformStamped()
        gripper.header.stamp = now
        gripper.header.frame_id = "world"
        gripper.child_frame_id = "gripper"
        gripper.transform.translation.x = self.path(now.to_sec())
        gripper.transform.rotation.w = 1.0
        self.tf.publish(TFMessage([gripper]))


def cup_poses(tf):
    """x of the cup by stamp, of all messages."""
    return {
        t.header.stamp.to_sec(): t.transform.translation.x
        for m in tf.messages
        for t in m.transforms
        if t.child_frame_id == CUP
    }


def points_of(cloud):
    return np.array(list(point_cloud2.read_points(cloud, ("x", "y", "z"))))


def count_inside(points, x):
    """Particles in the cup at x."""
    low, high = np.array([x - 0.048, -0.048, 0.0]), np.array([x + 0.048, 0.048, 0.14])
    return ((points > low) & (points < high)).all(axis=1).sum()


class Carry(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("carry_test")
        cls.node = Node()

    def start(self):
        """Starts the scene anew and returns its time."""
        self.node.start("carried_cup")
        return self.node.state().header.stamp.to_sec()

    def run_frames(self, frames):
        """Steps; returns the state and the particles after the last frame, (n, 3)."""
        with Latest("/sim/particles", PointCloud2) as clouds:
            state = self.node.run_frames(frames)
            cloud = clouds.wait(
                lambda c: abs((c.header.stamp - state.header.stamp).to_sec()) < 1e-6, "particles"
            )
        return state, points_of(cloud)

    def assert_in_cup(self, points, x):
        self.assertEqual((count_inside(points, x), len(points)), (PARTICLES, PARTICLES))

    def test_1_the_first_pose_is_a_placement(self):
        for x in (0.3, 1.0, -35.0):
            with Robot(self.start(), lambda t, x=x: x):
                state, points = self.run_frames(30)
            self.assert_in_cup(points, x)
            self.assertLess(state.max_speed_m_s, 0.2)
            self.assertEqual(state.speed_limited, 0)

    def carry(self, interval_s):
        """Carries the cup 1 m in 3 s. Returns the path of the robot, and x of the cup by stamp."""
        start = self.start()

        def path(t):
            s = min(max((t - start - 2.0) / 3.0, 0.0), 1.0)
            return 0.3 + s * s * s * (10 - 15 * s + 6 * s * s)

        with Latest("/tf", TFMessage) as tf, Robot(start, path, interval_s):
            _, points = self.run_frames(6 * 60)
            cup = cup_poses(tf)
        self.assert_in_cup(points, 1.3)
        self.assertGreater(len(cup), 300)
        return path, {stamp: x for stamp, x in cup.items() if stamp > start + 1.5}

    def test_2_a_cup_is_at_the_stamp_of_its_frame(self):
        path, cup = self.carry(0.0)
        for stamp, x in cup.items():
            self.assertAlmostEqual(x, path(stamp), delta=1e-6)

    def test_3_a_slow_robot_is_followed_an_interval_later(self):
        path, cup = self.carry(0.1)
        for stamp, x in cup.items():
            # rospy drops messages on /clock under load; then the interval of this robot is longer.
            self.assertGreater(x, path(stamp - 0.5) - 1e-6)
            self.assertLess(x, path(stamp - 0.1) + 0.0015)

    def waits(self, least):
        """Frames that waited in vain, once there are that many."""

        def value(status):
            return next(
                int(v.value) for v in status.values if v.key.startswith("frames that waited")
            )

        return value(self.node.diagnostic("followed frames", lambda s: value(s) >= least))

    def test_4_a_robot_that_is_silent_is_waited_for_once(self):
        with Robot(self.start(), lambda t: 0.0) as robot:
            self.run_frames(130)
            before = self.waits(0)
            robot.silent.set()
            self.run_frames(60)
            self.assertEqual(self.waits(before + 1), before + 1)

    def test_5_one_transform_for_each_stamp(self):
        start = self.start()
        with Latest("/tf", TFMessage) as tf, Robot(start, lambda t: 0.0):
            self.run_frames(60)
            stamps = [
                t.header.stamp for m in tf.messages for t in m.transforms if t.child_frame_id == CUP
            ]
        self.assertGreater(len(stamps), 50)
        self.assertEqual(len(stamps), len(set(stamps)))

    def test_6_a_static_frame_places_its_collider_too(self):
        Node("/fixed/sim")  # it follows the clock of the other node
        bench = TransformStamped()
        bench.header.frame_id = "world"
        bench.child_frame_id = "bench"
        bench.transform.translation.x = 0.3
        bench.transform.rotation.w = 1.0
        static = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
        self.node.start("carried_cup")
        self.node.resume()
        with Latest("/fixed/sim/particles", PointCloud2) as clouds:
            clouds.wait(lambda c: count_inside(points_of(c), 0.0) == PARTICLES, "the cup at first")
            static.publish(TFMessage([bench]))
            clouds.wait(lambda c: count_inside(points_of(c), 0.3) == PARTICLES, "the cup placed")
            stamp = self.node.state().header.stamp
            cloud = clouds.wait(lambda c: (c.header.stamp - stamp).to_sec() > 0.5, "time")
        self.assert_in_cup(points_of(cloud), 0.3)
        self.node.pause()


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "carry", Carry)
