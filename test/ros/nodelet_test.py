#!/usr/bin/python3
"""The nodelet loads, serves and unloads; a refused parameter does not end its manager."""
import pathlib
import subprocess
import sys
import unittest

import rosgraph
import rospy
from sensor_msgs.msg import PointCloud2

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node, wait_until


class InManager(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('nodelet_test')

    def test_2_serves_and_unloads(self):
        node = Node()
        node.start()
        self.assertGreater(node.run_frames(3).time_s, 0.0)
        with Latest('/sim/particles', PointCloud2) as clouds:
            self.assertEqual(clouds.wait().width, 216)
        self.assertEqual(self.nodelet('unload', '/sim', 'manager').returncode, 0)
        wait_until(lambda: '/sim/step' not in self.services(), 'the end of the services')
        self.assertIn('/manager/list', self.services())

    def test_1_refused_parameter_leaves_the_manager_alive(self):
        rospy.set_param('/refused/threads', -4)
        load = self.nodelet('load', 'ice_ice_baby/Simulation', 'manager', '__name:=refused')
        self.assertNotEqual(load.returncode, 0)
        self.assertNotIn('/refused/step', self.services())
        self.assertIn('/sim/step', self.services())

    @staticmethod
    def nodelet(*arguments):
        return subprocess.run(['rosrun', 'nodelet', 'nodelet', *arguments], timeout=30, check=False)

    @staticmethod
    def services():
        return [name for name, _ in rosgraph.Master('/nodelet_test').getSystemState()[2]]


if __name__ == '__main__':
    import rostest
    rostest.rosrun('ice_ice_baby', 'nodelet', InManager)
