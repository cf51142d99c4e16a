#!/usr/bin/python3
"""Nodes in two namespaces have tf frames of their own; nodes in one of them say that they clash."""
import pathlib
import sys
import unittest

import rospy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Node


class Namespaces(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("namespaces_test")

    def test_frames_are_in_the_namespace(self):
        for space in ("left", "right"):
            state = Node("/%s/sim" % space).state()
            self.assertEqual(state.header.frame_id, space + "/ice_ice_baby/scene")

    def test_a_clash_is_told_by_both(self):
        for name, other in (("sim", "again"), ("again", "sim")):
            status = Node("/right/" + name).diagnostic("frames", lambda s: s.level == 1)
            self.assertIn(
                "tf frame right/ice_ice_baby/scene is sent by /right/" + other, status.message
            )
            self.assertIn("~scene_frame", status.message)

    def test_no_clash_is_ok(self):
        self.assertEqual(Node("/left/sim").diagnostic("frames", lambda s: True).level, 0)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "namespaces", Namespaces)
