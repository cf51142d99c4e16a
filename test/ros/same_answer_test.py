#!/usr/bin/python3
"""The node computes what the library computes without ROS, to the last bit."""
import pathlib
import sys
import unittest

import rospy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.common.run_scene import report_of
from iib.ros.node import Node
from iib.ros.program import find_program

FRAMES = 60


class SameAnswer(unittest.TestCase):
    def test_the_state_of_the_node_is_that_of_run_scene(self):
        rospy.init_node("same_answer_test")
        node = Node()
        for scene in ("small", "raft", "gauged", "ice_and_solids"):
            node.start(scene)
            state = node.run_frames(FRAMES)
            alone = report_of(find_program("run_scene"), scene, duration=state.time_s, threads=1)
            self.assertEqual(
                (alone["frames"], alone["state_hash"]), (FRAMES, "%016x" % state.state_hash), scene
            )
        self.assertGreater(state.ice_bodies, 0)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "same_answer", SameAnswer)
