#!/usr/bin/python3
"""The topic `surface`: the volume of the water, the ice after it froze, and nothing unasked."""
import pathlib
import subprocess
import sys
import unittest

import numpy as np
import rospy
from ice_ice_baby.msg import State, Surface
from visualization_msgs.msg import Marker, MarkerArray

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node, wait_until

WATER_M3 = 12**3 * 0.02**3


def points(vectors):
    return np.array([(p.x, p.y, p.z) for p in vectors])


def corners(mesh):
    return points(mesh.vertices)[[t.vertices for t in mesh.triangles]]


def volume_m3(triangles):
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6


class SurfaceOfTheNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("surface_test")
        cls.node = Node()

    def setUp(self):
        self.node.start("block")

    def subscribers_of_particles(self, node="/sim"):
        with Latest(node + "/state", State) as topic:
            loads = topic.wait().topics
        return next(load.subscribers for load in loads if load.name == node + "/particles")

    def test_encloses_the_water(self):
        with Latest("/sim/surface", Surface) as topic:
            message = topic.wait()
        self.assertEqual(message.header.frame_id, "ice_ice_baby/scene")
        self.assertAlmostEqual(message.spacing_m, 0.02, places=6)
        self.assertFalse(message.thermal)
        water = message.water
        self.assertAlmostEqual(volume_m3(corners(water)), WATER_M3, delta=0.05 * WATER_M3)
        self.assertEqual((message.ice.triangles, message.steam), ([], []))
        self.assertEqual(len(water.normals), len(water.vertices))
        self.assertTrue(np.allclose(np.linalg.norm(points(water.normals), axis=1), 1, atol=1e-5))
        out = points(water.vertices) - (0, 0, 0.17)
        self.assertGreater((points(water.normals) * out).sum(axis=1).min(), 0)

    def test_follows_the_water(self):
        with Latest("/sim/surface", Surface) as topic:
            before = topic.wait()
            stamp = self.node.run_frames(6).header.stamp
            after = topic.wait(lambda m: m.header.stamp >= stamp, "a later surface")
        fall_m = (
            points(before.water.vertices)[:, 2].max() - points(after.water.vertices)[:, 2].max()
        )
        self.assertAlmostEqual(fall_m, 0.5 * 9.81 * 0.1**2, delta=0.01)
        velocities = points(after.water.velocities)
        self.assertAlmostEqual(velocities[:, 2].mean(), -9.81 * 0.1, delta=0.05)

    def test_ice_when_it_has_frozen(self):
        with Latest("/sim/surface", Surface) as topic:
            self.assertTrue(
                self.node.set_temperature(temperature=-10.0, ramp_s=0.0, target="").success
            )
            self.node.run_frames(1)
            message = topic.wait(lambda m: m.ice.triangles, "ice")
        self.assertEqual(message.water.triangles, [])
        self.assertAlmostEqual(volume_m3(corners(message.ice)), WATER_M3, delta=0.05 * WATER_M3)
        self.assertGreater(min(message.ice.ice_fractions), 0.99)

    def test_markers(self):
        with Latest("/sim/surface_markers", MarkerArray) as topic:
            markers = {marker.ns: marker for marker in topic.wait().markers}
        self.assertEqual(markers["ice"].action, Marker.DELETE)
        water = markers["water"]
        self.assertEqual((water.type, water.action), (Marker.TRIANGLE_LIST, Marker.ADD))
        self.assertEqual(len(water.colors), len(water.points))
        self.assertGreater(water.colors[0].b, water.colors[0].r)
        triangles = points(water.points).reshape(-1, 3, 3)
        self.assertAlmostEqual(volume_m3(triangles), WATER_M3, delta=0.05 * WATER_M3)

    def test_costs_nothing_unasked(self):
        wait_until(lambda: self.subscribers_of_particles() == 0, "no subscriber")
        with Latest("/sim/surface", Surface) as topic:
            topic.wait()
            self.assertEqual(self.subscribers_of_particles(), 1)
        wait_until(lambda: self.subscribers_of_particles() == 0, "no subscriber again")

    def test_refuses_a_rate_and_says_why(self):
        command = ["rosrun", "ice_ice_baby", "surface_node", "_rate_hz:=-1", "__name:=refused"]
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=30)
        self.assertEqual(run.returncode, 1)
        self.assertIn("rate_hz is -1", run.stdout.decode())

    def test_as_a_nodelet(self):
        with Latest("/nodelet_sim/surface", Surface) as topic:
            message = topic.wait()
        self.assertAlmostEqual(volume_m3(corners(message.water)), WATER_M3, delta=0.05 * WATER_M3)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "surface", SurfaceOfTheNode)
