#!/usr/bin/python3
"""Services answer quickly although a frame takes long."""
import pathlib
import statistics
import sys
import time
import unittest

import rospy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Node


class Slow(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('slow_test')

    def test_services_do_not_wait_for_the_solver(self):
        node = Node()
        state = node.when(lambda s: s.frame >= 1, 'a frame', 60.0)
        self.assertGreater(state.particles, 200000)
        self.assertGreater(state.frame_wall_s, 0.2)
        times = []
        for k in range(20):
            for call in (node.get_state, lambda: node.set_temperature(temperature=20.0 + k),
                         lambda: node.step(frames=1), lambda: node.reset(scene='none')):
                start = time.monotonic()
                call()
                times.append(time.monotonic() - start)
        self.assertLess(statistics.median(times), 0.1)
        self.assertLess(max(times), max(0.5, state.frame_wall_s))

    def test_overload_is_a_warning(self):
        node = Node()
        status = node.diagnostic('real time', lambda s: s.level == 1, 30.0)
        self.assertIn('slower than requested', status.message)


if __name__ == '__main__':
    import rostest
    rostest.rosrun('ice_ice_baby', 'slow', Slow)
