#!/usr/bin/python3
"""A scene with heat: temperatures of colliders, heated regions, diagnostics."""
import math
import pathlib
import sys
import unittest

import rospy
from geometry_msgs.msg import Point, Vector3

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Node


class Heat(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("heat_test")
        cls.node = Node()

    def setUp(self):
        self.node.start()

    def torch(self, **changes):
        """Answer of heat_region for a sphere in the water, with some fields changed."""
        request = dict(
            shape="sphere",
            centre=Point(0.0, 0.0, 0.2),
            size=Vector3(0.2, 0.2, 0.2),
            power_w=500.0,
            duration_s=1.0,
        )
        return self.node.heat_region(**dict(request, **changes))

    def test_set_temperature_names_its_target(self):
        answer = self.node.set_temperature(temperature=-5.0, ramp_s=2.0)
        self.assertEqual(answer.message, "the whole scene going to -5 degrees C over 2 s")
        self.node.start("warm")
        answer = self.node.set_temperature(temperature=-5.0, ramp_s=2.0)
        self.assertEqual(answer.message, "air going to -5 degrees C over 2 s")
        for target in ("plate", "container"):
            self.node.start("warm")
            answer = self.node.set_temperature(temperature=90.0, ramp_s=0.0, target=target)
            self.assertTrue(answer.success, answer.message)
            self.assertEqual(answer.message, "collider %s going to 90 degrees C over 0 s" % target)
            self.assertEqual(answer.temperature, 20.0)  # the air's
        self.assertEqual(self.node.run_frames(1).frame, 1)

    def test_set_temperature_refuses_targets(self):
        answer = self.node.set_temperature(temperature=-5.0, target="container")
        self.assertFalse(answer.success)
        self.assertIn("thermal.enabled", answer.message)
        self.node.start("warm")
        for target in ("plat", "air", " ", "x" * 5000):
            answer = self.node.set_temperature(temperature=-5.0, target=target)
            self.assertFalse(answer.success)
            self.assertIn(target[:100], answer.message)
            self.assertIn("container, plate", answer.message)
            self.assertLess(len(answer.message), 300)
        answer = self.node.set_temperature(temperature=-500.0, target="plate")
        self.assertIn("-500", answer.message)
        self.assertEqual(self.node.run_frames(1).temperature, 20.0)

    def test_targets_of_a_scene_that_a_reset_has_just_asked_for(self):
        self.assertTrue(self.node.reset(scene="warm", preset="").success)
        answer = self.node.set_temperature(temperature=-5.0, target="plate")
        self.assertTrue(answer.success, answer.message)

    def test_heat_region(self):
        state = self.node.start("warm")
        self.assertEqual((state.thermal, state.targets), (True, ["container", "plate"]))
        answer = self.torch()
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(
            answer.message,
            "heating a sphere of [0.2, 0.2, 0.2] m about " "[0, 0, 0.2] m with 500 W for 1 s",
        )
        answer = self.torch(shape="box", power_w=-250.0)
        self.assertTrue(answer.success, answer.message)
        self.assertTrue(answer.message.startswith("cooling a box"))
        self.assertIn("with 250 W", answer.message)
        self.assertEqual(self.node.run_frames(2).frame, 2)

    def test_heat_region_refuses(self):
        self.assertIn("thermal.enabled", self.torch().message)
        self.node.start("warm")
        for named, changes in (
            ("cone", {"shape": "cone"}),
            ("cylinder", {"shape": "cylinder"}),
            ("shape", {"shape": ""}),
            ("centre y", {"centre": Point(0.0, math.nan, 0.0)}),
            ("centre x", {"centre": Point(1e6, 0.0, 0.0)}),
            ("size z", {"size": Vector3(0.1, 0.1, -0.1)}),
            ("size x", {"size": Vector3(math.inf, 0.1, 0.1)}),
            ("power", {"power_w": math.nan}),
            ("power", {"power_w": -2e9}),
            ("duration", {"duration_s": -1.0}),
            ("duration", {"duration_s": math.inf}),
        ):
            answer = self.torch(**changes)
            self.assertFalse(answer.success)
            self.assertIn(named, answer.message)
            self.assertIn("box, sphere" if "shape" in changes else "[", answer.message)
        self.assertEqual(self.node.run_frames(1).frame, 1)

    def test_diagnostics_of_heat(self):
        def keys():
            return {v.key for v in self.node.diagnostic("solver", lambda s: True).values}

        self.assertNotIn("thermal_speedup_wanted", keys())
        self.node.start("warm")
        self.assertIn("thermal_speedup_wanted", keys())
        self.assertIn("mean_celsius", keys())


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "heat", Heat)
