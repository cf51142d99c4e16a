#!/usr/bin/python3
"""The nodes of examples/ice_ice_baby_examples, against the running node."""
import pathlib
import re
import subprocess
import sys
import unittest

import roslib.packages
import rospy
from tf2_msgs.msg import TFMessage

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.common.paths import ROOT
from iib.ros.node import Latest, Node, wait_until

SCRIPTS = ROOT / "examples" / "ice_ice_baby_examples" / "scripts"
SPOON = "ice_ice_baby/scene/spoon"


def built(example):
    return roslib.packages.find_node("ice_ice_baby", "example_" + example)[0]


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("examples_test")
        cls.node = Node("/ice_ice_baby")

    def start(self, program):
        child = subprocess.Popen(
            [program], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
        )
        self.addCleanup(self.end, child)
        return child

    @staticmethod
    def end(child):
        child.kill()
        child.communicate()

    def expect_particles(self, program):
        line = self.start(program).stdout.readline()
        found = re.search(r"(\d+) particles, coldest (-?[\d.]+) degrees Celsius", line)
        self.assertTrue(found, line)
        state = self.node.state()
        self.assertEqual(int(found.group(1)), state.particles)
        self.assertAlmostEqual(float(found.group(2)), state.temperature, delta=0.1)

    def test_1_subscribers_print_the_particles(self):
        self.expect_particles(built("print_particles"))
        self.expect_particles(str(SCRIPTS / "print_particles.py"))

    def test_1_subscribers_print_the_vessels(self):
        for program in built("print_vessels"), str(SCRIPTS / "print_vessels.py"):
            line = self.start(program).stdout.readline()
            found = re.search(r"bowl: ([\d.]+) l, level ([\d.]+) m", line)
            self.assertTrue(found, line)
            self.assertGreater(float(found.group(1)), 0.0)
            self.assertGreater(float(found.group(2)), 0.0)

    def test_1_subscribers_print_the_weight_in_the_bowl(self):
        self.node.when(lambda s: s.time_s > 2.0, "water at rest")
        weight_n = 9.81 * self.node.state().particles * 1000 * 0.03**3
        for program in built("print_wrench"), str(SCRIPTS / "print_wrench.py"):
            line = self.start(program).stdout.readline()
            found = re.search(r"bowl: ([\d.]+) N downwards", line)
            self.assertTrue(found, line)
            self.assertAlmostEqual(float(found.group(1)), weight_n, delta=0.2 * weight_n)

    def run_to_end(self, *command):
        return subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)

    def test_1_clients_set_the_temperature(self):
        for program in built("set_temperature"), str(SCRIPTS / "set_temperature.py"):
            for celsius in (25.0, 20.0):
                done = self.run_to_end(program, str(celsius))
                self.assertEqual(done.returncode, 0, done.stderr)
                self.node.when(lambda s, c=celsius: s.temperature == c, "%g degrees" % celsius)
            done = self.run_to_end(program, "5000")
            self.assertEqual(done.returncode, 1)
            self.assertIn("1000", done.stdout)  # what is allowed

    def test_1_clients_start_the_scene_again(self):
        for program in built("reset_scene"), str(SCRIPTS / "reset_scene.py"):
            self.node.when(lambda s: s.frame > 0, "a frame")
            self.node.pause()
            done = self.run_to_end(program)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.node.when(lambda s: s.frame == 0, "the start of the scene")
            self.node.resume()
            done = self.run_to_end(program, "no_such_scene")
            self.assertEqual(done.returncode, 1)
            self.assertIn("no_such_scene", done.stdout)

    def test_2_calm_water_freezes(self):
        child = self.start(built("freeze_when_calm"))
        output, _ = child.communicate(timeout=60)
        self.assertIn("Calm after", output)
        self.assertEqual(child.returncode, 0)
        self.node.when(lambda s: s.temperature == -1.0 and s.springs > 0, "ice")
        self.assertTrue(self.node.reset(scene="", preset="").success)

    def test_3_the_spoon_stirs(self):
        self.start(str(SCRIPTS / "move_spoon.py"))
        with Latest("/tf", TFMessage) as tf:

            def places():
                found = [
                    t.transform.translation
                    for m in tf.messages
                    for t in m.transforms
                    if t.child_frame_id == SPOON
                ]
                return [p for p in found if abs(p.z - 0.1) < 1e-6]

            wait_until(
                lambda: max((p.x for p in places()), default=0) > 0.11
                and min(p.x for p in places()) < -0.11,
                "a circle of the spoon",
            )
        self.node.when(lambda s: s.rms_speed_m_s > 0.05, "water that moves")


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "examples", Examples)
