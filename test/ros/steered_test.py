#!/usr/bin/python3
"""A tap and a heat gun that a robot holds follow tf frames; a service switches the gun."""
import math
import pathlib
import sys
import time
import unittest

import rospy
from geometry_msgs.msg import TransformStamped
from sensor_msgs import point_cloud2
from sensor_msgs.msg import PointCloud2
from tf2_msgs.msg import TFMessage

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node

RATE_1_S = math.pi * 0.08**2 / 0.05**3  # of the tap
LAYER = 8
STILL = 64  # particles of the block


class Steered(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("steered_test")
        cls.node = Node()
        cls.tf = rospy.Publisher("/tf", TFMessage, queue_size=10)

    def put(self, frame, x, y=0.0, z=0.0):
        transform = TransformStamped()
        transform.header.stamp = rospy.Time.now()
        transform.header.frame_id = "world"
        transform.child_frame_id = frame
        transform.transform.translation.x = x
        transform.transform.translation.y = y
        transform.transform.translation.z = z
        transform.transform.rotation.w = 1.0
        self.tf.publish(TFMessage([transform]))

    def carry(self, seconds, frame, pose):
        """Sends pose(time since the call) at 50 Hz."""
        begin = time.monotonic()
        while time.monotonic() < begin + seconds:
            self.put(frame, *pose(time.monotonic() - begin))
            time.sleep(0.02)

    def test_1_without_its_frame_the_tap_is_closed(self):
        status = self.node.diagnostic("followed frames", lambda s: s.level == 1)
        self.assertIn("source tap, which follows tf frame nozzle, does not move", status.message)
        self.assertIn("heat region gun, which follows tf frame gun", status.message)
        state = self.node.when(lambda s: s.frame > 30, "half a second")
        self.assertEqual((state.poured, state.particles), (0, STILL))

    def test_2_it_pours_where_the_frame_is(self):
        self.carry(1.0, "nozzle", lambda t: (0.6, 0.2, 0.5))
        with Latest("/sim/particles", PointCloud2) as clouds:
            cloud = clouds.wait(lambda c: c.width > STILL + 3 * LAYER, "water from the tap")
        points = point_cloud2.read_points(cloud, ["x", "y", "z", "vz", "id"])
        poured = [p for p in points if p[4] >= STILL]
        self.assertGreater(len(poured), 3 * LAYER)
        for x, y, z, vz, _ in poured:
            self.assertAlmostEqual(x, 0.5, delta=0.12)  # the scene is at x = 0.1 m
            self.assertAlmostEqual(y, 0.2, delta=0.12)
            self.assertGreater(z, 0.59)
            self.assertAlmostEqual(vz, 1.0, delta=0.1)

    def test_3_its_rate_stays_while_it_moves(self):
        self.carry(0.3, "nozzle", lambda t: (0.6, 0.2, 0.5))
        before = self.node.state()
        self.carry(2.0, "nozzle", lambda t: (0.6, 0.2 + 0.4 * t, 0.5))
        after = self.node.state()
        due = RATE_1_S * (after.time_s - before.time_s)
        self.assertAlmostEqual(after.poured - before.poured, due, delta=0.01 * due + LAYER)
        self.assertEqual(after.blocked, 0)
        with Latest("/sim/particles", PointCloud2) as clouds:
            cloud = clouds.wait()
        points = list(point_cloud2.read_points(cloud, ["y", "vy", "id"]))
        fast = [p for p in points if p[2] >= STILL and p[1] > 0.3]  # more if the node is slow
        self.assertGreater(len(fast), 10 * LAYER)  # the water has the speed of the tap
        self.node.set_source(name="tap", open=False)

    def test_4_the_gun_heats_while_it_is_on_and_there(self):
        answer = self.node.set_heat_region(name="gun", active=True)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.power_w, 3000.0)
        self.assertEqual(answer.message, "heat region gun heats with 3000 W")
        cold_j = self.node.state().enthalpy_j
        time.sleep(0.5)
        self.assertAlmostEqual(self.node.state().enthalpy_j, cold_j, delta=1.0)  # no frame yet
        self.carry(1.0, "gun", lambda t: (3.1, 0.0, 0.0))  # away from the water
        self.assertAlmostEqual(self.node.state().enthalpy_j, cold_j, delta=1.0)
        self.carry(2.0, "gun", lambda t: (0.1, 0.0, 0.0))
        answer = self.node.set_heat_region(name="gun", active=False, power_w=-50.0)
        self.assertEqual(answer.message, "heat region gun is off")
        self.assertEqual(answer.power_w, -50.0)
        self.node.when(lambda s: s.enthalpy_j > cold_j + 500.0, "warm water")
        time.sleep(0.5)
        warm_j = self.node.state().enthalpy_j
        time.sleep(0.5)
        self.assertAlmostEqual(self.node.state().enthalpy_j, warm_j, delta=1.0)

    def test_5_a_spray_cools_where_the_scene_has_it(self):
        self.node.start("steered")
        self.assertTrue(self.node.set_source(name="tap", open=False).success)
        before = self.node.run_frames(12).enthalpy_j
        self.assertTrue(self.node.set_heat_region(name="spray", active=True).success)
        after = self.node.run_frames(60)
        self.assertTrue(self.node.set_heat_region(name="spray", active=False).success)
        done = self.node.run_frames(12)
        speedup = after.thermal_speedup
        self.assertAlmostEqual(done.enthalpy_j - before, -100.0 * speedup, delta=1.0 * speedup)

    def test_6_set_heat_region_refuses(self):
        self.node.start("steered")
        hot = self.node.hash()
        for name, power_w, named in (
            ("gunn", 0.0, ["gunn", "gun, spray"]),
            ("", 0.0, ["gun, spray"]),
            ("gun", math.nan, ["gun", "nan", "[-1e+09, 1e+09]"]),
            ("spray", -2e9, ["spray", "-2e+09", "[-1e+09, 1e+09]"]),
        ):
            answer = self.node.set_heat_region(name=name, active=True, power_w=power_w)
            self.assertFalse(answer.success)
            for word in named:
                self.assertIn(word, answer.message)
        self.assertEqual(self.node.hash(), hot)
        self.node.start("small")
        answer = self.node.set_heat_region(name="gun", active=True)
        self.assertIn("scene small has none", answer.message)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "steered", Steered)
