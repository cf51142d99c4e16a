#!/usr/bin/python3
"""What vessels and gauges hold: a known fill, a cup that moves, and nothing without subscribers."""
import math
import pathlib
import sys
import time
import unittest

import rospy
from geometry_msgs.msg import TransformStamped, Vector3, WrenchStamped
from ice_ice_baby.msg import Vessels
from tf2_msgs.msg import TFMessage

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node, wait_until

PARTICLE_M3 = 0.02**3
IN_TANK, IN_CUP = 10 * 10 * 6, 4 * 4 * 3


def named(message):
    return {vessel.name: vessel for vessel in message.vessels}


class VesselsOfTheNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("vessels_test")
        cls.node = Node()
        cls.tf = rospy.Publisher("/tf", TFMessage, queue_size=10)

    def put_gripper(self, x):
        gripper = TransformStamped()
        gripper.header.stamp = rospy.Time.now()
        gripper.header.frame_id = "world"
        gripper.child_frame_id = "gripper"
        gripper.transform.translation.x = x
        gripper.transform.rotation.w = 1.0
        self.tf.publish(TFMessage([gripper]))

    def test_1_a_known_fill(self):
        self.node.start("gauged")
        with Latest("/sim/vessels", Vessels) as topic:
            topic.wait()
            state = self.node.run_frames(60)
            message = topic.wait(lambda m: abs(m.time_s - state.time_s) < 1e-9, "the last frame")
        self.assertEqual(message.header.frame_id, "ice_ice_baby/scene")
        self.assertEqual([v.name for v in message.vessels], ["tank", "cup", "half"])
        self.assertEqual(message.spilled, 0)
        tank, cup, half = message.vessels
        self.assertEqual((tank.particles, cup.particles), (IN_TANK, IN_CUP))
        for vessel, volume_m3, area_m2 in (
            (tank, IN_TANK * PARTICLE_M3, 0.04),
            (cup, IN_CUP * PARTICLE_M3, math.pi * 0.06**2),
        ):
            self.assertAlmostEqual(vessel.water_m3, volume_m3, delta=0.01 * volume_m3)
            self.assertAlmostEqual(vessel.level_m, volume_m3 / area_m2, delta=0.01 * vessel.level_m)
            self.assertEqual((vessel.ice_m3, vessel.entered_m3, vessel.left_m3), (0.0, 0.0, 0.0))
            self.assertTrue(math.isnan(vessel.mean_celsius))
        self.assertAlmostEqual(half.water_m3, tank.water_m3 / 2, delta=0.1 * tank.water_m3)
        self.assertEqual(state.particles, tank.particles + cup.particles)

    def test_1_the_tank_feels_the_weight_of_its_water(self):
        self.node.start("gauged")
        self.node.run_frames(60)
        with Latest("/sim/wrenches/tank", WrenchStamped) as topic:
            self.node.resume()
            topic.wait()
            wait_until(lambda: len(topic.messages) > 20, "wrenches of the tank")
            self.node.pause()
        self.assertEqual(topic.messages[-1].header.frame_id, "ice_ice_baby/scene/tank")
        forces = [message.wrench.force.z for message in topic.messages[5:]]
        weight_n = IN_TANK * PARTICLE_M3 * 1000 * 9.81
        self.assertAlmostEqual(sum(forces) / len(forces), -weight_n, delta=0.02 * weight_n)

    def test_2_a_cup_that_moves(self):
        self.node.start("gauged")
        self.node.resume()
        with Latest("/sim/vessels", Vessels) as topic:
            begin = time.monotonic()
            while time.monotonic() < begin + 3.0:
                self.put_gripper(-0.3 - 0.1 * math.sin(time.monotonic() - begin))
                time.sleep(0.02)
            self.assertGreater(len(topic.messages), 30)
            for message in topic.messages:
                self.assertEqual(named(message)["cup"].particles, IN_CUP)
                self.assertEqual(named(message)["tank"].particles, IN_TANK)
            stamps = [message.time_s for message in topic.messages]
        self.node.pause()
        self.assertEqual(stamps, sorted(stamps))

    def test_3_flows_are_counted(self):
        """Gravity points up, so the water leaves the tank."""
        self.node.start("gauged")
        with Latest("/sim/vessels", Vessels) as topic:
            topic.wait()
            self.node.set_gravity(gravity=Vector3(0.0, 0.0, 9.81))
            state = self.node.run_frames(40)
            tank = named(topic.wait(lambda m: abs(m.time_s - state.time_s) < 1e-9))["tank"]
        left = IN_TANK * PARTICLE_M3 - tank.water_m3
        self.assertGreater(left, 0.0)
        self.assertAlmostEqual(tank.left_m3 - tank.entered_m3, left, delta=0.01 * left)
        self.assertGreater(tank.outflow_m3_s, 0.0)

    def test_4_without_subscribers_nothing_is_measured(self):
        self.node.start("gauged")

        def load():
            return next(t for t in self.node.state().topics if t.name == "/sim/vessels")

        wait_until(lambda: load().subscribers == 0, "the end of other tests' subscriptions")
        before = load().messages
        state = self.node.run_frames(30)
        self.assertEqual(load().messages, before)
        self.assertNotIn("vessels", [stage.name for stage in state.stages])
        with Latest("/sim/vessels", Vessels) as topic:
            topic.wait()
            state = self.node.run_frames(3)
            self.assertIn("vessels", [stage.name for stage in state.stages])


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "vessels", VesselsOfTheNode)
