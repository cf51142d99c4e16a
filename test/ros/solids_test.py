#!/usr/bin/python3
"""Floating solids from outside: topic, frame and shape, and a gripper that takes one along."""
import pathlib
import sys
import unittest

import rospy
from geometry_msgs.msg import TransformStamped
from ice_ice_baby.msg import FloatingSolids
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node, wait_until

RAFT = "ice_ice_baby/scene/raft"


class SolidsOfTheNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("solids_test")
        cls.node = Node()
        cls.tf = rospy.Publisher("/tf", TFMessage, queue_size=10)

    def put_gripper(self, z):
        gripper = TransformStamped()
        gripper.header.stamp = rospy.Time.now()
        gripper.header.frame_id = "world"
        gripper.child_frame_id = "gripper"
        gripper.transform.translation.z = z
        gripper.transform.rotation.w = 1.0
        self.tf.publish(TFMessage([gripper]))

    def lift(self, topic, z, until):
        """Publishes the gripper at z until the raft fulfils the condition."""

        def there():
            self.put_gripper(z)
            return topic.messages and until(topic.messages[-1].solids[0])

        wait_until(there, "the raft at the gripper")
        return topic.messages[-1].solids[0]

    def test_1_topic_frame_and_shape(self):
        self.node.start("raft")
        with Latest("/sim/solids", FloatingSolids) as topic, Latest("/tf", TFMessage) as tf, Latest(
            "/sim/solid_markers", MarkerArray
        ) as markers:
            topic.wait()
            markers.wait()
            state = self.node.run_frames(20)
            message = topic.wait(lambda m: abs(m.time_s - state.time_s) < 1e-9, "the last frame")
            self.assertEqual(message.header.frame_id, "ice_ice_baby/scene")
            self.assertEqual([solid.name for solid in message.solids], ["raft"])
            raft = message.solids[0]
            self.assertLess(raft.pose.position.z, 0.26)
            self.assertEqual((raft.held, raft.asleep), (False, False))
            z = raft.pose.position.z
            wait_until(
                lambda: [
                    t
                    for m in tf.messages[-20:]
                    for t in m.transforms
                    if t.child_frame_id == RAFT and abs(t.transform.translation.z - z) < 1e-9
                ],
                "the frame of the raft",
            )
            drawn = markers.wait(
                lambda a: abs(a.markers[0].pose.position.z - z) < 1e-9, "the drawn raft"
            ).markers[0]
        self.assertEqual((drawn.ns, drawn.type), ("raft", Marker.TRIANGLE_LIST))
        self.assertEqual((state.solids, state.ice_bodies), (1, 0))

    def test_2_a_gripper_takes_it_along_and_lets_it_go(self):
        self.node.start("raft")
        with Latest("/sim/solids", FloatingSolids) as topic:
            self.node.resume()
            answer = self.node.attach(solid="raft", frame="gripper")
            self.assertTrue(answer.success, answer.message)
            self.assertEqual(answer.frame, "gripper")
            topic.wait(lambda m: m.solids[0].held, "a held raft")
            held_z = topic.messages[-1].solids[0].pose.position.z
            status = self.node.diagnostic("followed frames", lambda s: s.level == 1)
            self.assertIn("solid raft, which is attached to tf frame gripper", status.message)
            self.lift(topic, 1.0, lambda s: abs(s.pose.position.z - held_z) < 1e-6)
            self.node.diagnostic("followed frames", lambda s: s.level == 0)
            self.lift(topic, 1.1, lambda s: abs(s.pose.position.z - held_z - 0.1) < 1e-6)
            answer = self.node.attach(solid="raft", frame="")
            self.assertTrue(answer.success, answer.message)
            topic.wait(lambda m: not m.solids[0].held, "a free raft")
            topic.wait(lambda m: m.solids[0].pose.position.z < held_z, "the fall of the raft")
        self.node.pause()

    def test_3_bad_requests_change_nothing(self):
        self.node.start("raft")
        before = self.node.hash()
        for request, words in (
            (dict(solid="rafd", frame="gripper"), ["rafd", "has: raft"]),
            (dict(solid="", frame=""), ["has: raft"]),
            (dict(solid="raft", frame="a b\n"), ["frame"]),
        ):
            answer = self.node.attach(**request)
            self.assertFalse(answer.success, request)
            for word in words:
                self.assertIn(word, answer.message)
        self.assertEqual(self.node.hash(), before)

    def test_4_a_scene_without_solids_has_no_topics_of_them(self):
        self.node.start("small")
        wait_until(
            lambda: "/sim/solids" not in [name for name, _ in rospy.get_published_topics()],
            "the end of the topic",
        )
        answer = self.node.attach(solid="raft", frame="gripper")
        self.assertFalse(answer.success)
        self.assertIn("has none", answer.message)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "solids", SolidsOfTheNode)
