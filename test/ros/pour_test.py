#!/usr/bin/python3
"""launch/pour.launch: the arm pours 200 ml into the glass and spills nothing; where its lip is."""
import math
import pathlib
import sys
import unittest
import xml.etree.ElementTree

import numpy as np
import rospy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.common.paths import ROOT
from iib.ros.node import wait_until

EXAMPLE = ROOT / "examples" / "pour"
sys.path.insert(0, str(EXAMPLE))
import arm

RIM_M = (0.04, 0.114)  # inner edge of the rim from the frame cup, forward and up
RESULT = "/pour/result"


def turned(axis, angle):
    """Rotation about y or z."""
    c, s = math.cos(angle), math.sin(angle)
    if axis == "0 1 0":
        return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def lip_of(positions):
    """Where arm.urdf has the lip with these joint positions, from its base."""
    rotation, place = np.eye(3), np.zeros(3)
    for joint in xml.etree.ElementTree.parse(EXAMPLE / "arm.urdf").getroot().findall("joint"):
        if joint.get("name") == "base":
            continue
        offset = [float(word) for word in joint.find("origin").get("xyz").split()]
        place = place + rotation @ offset
        if joint.get("type") == "revolute":
            axis = joint.find("axis").get("xyz")
            rotation = rotation @ turned(axis, positions[joint.get("name")])
    return place + rotation @ [RIM_M[0], 0, RIM_M[1]]


class Pour(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("pour_test")

    def test_1_the_lip_is_where_it_was_asked_to_be(self):
        for turn in (-1.0, 0.0, 2.5):
            for tilt in (0.0, 0.7, 1.6, -0.2):
                for distance, height in ((0.39, 0.114), (0.45, 0.2), (0.33, 0.25)):
                    joints = arm.joints_of(turn, (distance, height), tilt)
                    lip = lip_of(dict(zip(arm.JOINTS, joints)))
                    there = [distance * math.cos(turn), distance * math.sin(turn), height]
                    np.testing.assert_allclose(lip, there, atol=1e-9)
                    self.assertAlmostEqual(sum(joints[1:]), tilt)

    def test_1_a_place_out_of_reach_is_refused(self):
        with self.assertRaisesRegex(ValueError, "the arm reaches 0.04 to 0.56 m"):
            arm.joints_of(0.0, (0.8, 0.1), 0.0)

    def test_2_it_pours_200_ml_and_spills_nothing(self):
        wait_until(lambda: rospy.has_param(RESULT), "the result of the arm", 450.0)
        result = rospy.get_param(RESULT)
        self.assertLessEqual(abs(result["error_percent"]), 2.0, result)
        self.assertEqual(result["spilled_particles"], 0, result)
        # The volume that arrived, the weight on the scale and the weight that left the wrist.
        self.assertAlmostEqual(result["scale_g"], result["poured_ml"], delta=2.0)
        self.assertAlmostEqual(result["wrist_g"], -result["poured_ml"], delta=2.0)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "pour_test", Pour)
