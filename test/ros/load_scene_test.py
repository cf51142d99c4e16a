#!/usr/bin/python3
"""A scene as text replaces the running one with all that belongs to it, or is refused with the
reason while the running one goes on."""
import pathlib
import sys
import unittest

import rosgraph
import rospy
from geometry_msgs.msg import TransformStamped
from ice_ice_baby.msg import Vessels
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node, wait_until

SPOON = "ice_ice_baby/scene/spoon"
TEXT = """
name: stirred
fluid: {spacing_m: 0.05}
blocks: [{min_m: [-0.2, -0.2, 0], max_m: [0.2, 0.2, 0.1]}]
containers: [{name: bowl, size_m: [0.4, 0.4, 0.4]}]
spheres: [{name: spoon, radius_m: 0.05, position_m: [0, 0, 0.3], follow_frame: hand}]
gauges: [{name: window, position_m: [0, 0, 0.1], size_m: [0.1, 0.1, 0.2]}]
"""
# Text, and what the answer must contain.
REFUSED = [
    ("blocks: [{min_m: [0, 0", ["not valid YAML", "line"]),
    ("fluid: {spacing: 0.05}", ["unknown key fluid.spacing", "did you mean fluid.spacing_m"]),
    ("fluid: {spacing_m: 50}", ["fluid.spacing_m = 50", "allowed range ["]),
    (
        "fluid: {spacing_m: 0.001}\nblocks: [{max_m: [1, 1, 1]}]",
        ["1000000000 particles", "limits.max_particles = 2e+06", "enlarge fluid.spacing_m"],
    ),
    ("meshes: [{file: /etc/passwd}]", ["meshes.0.file = /etc/passwd", "begin with package://"]),
    ("meshes: [{file: ../scenes/small.yaml}]", ["begin with package://"]),
    ("meshes: [{file: none.stl}]", ["begin with package://"]),
    ("meshes: [{file: 'package://ice_ice_baby/../../x.stl'}]", ["package://ice_ice_baby/../../x"]),
    ("gauges: [{name: a, frame: b}]", ["gauges.0.frame = b", "no collider"]),
    ("x" * 1100000, ["1100000 bytes, more than 1048576"]),
]


class LoadScene(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("load_scene_test")
        cls.node = Node()
        cls.tf = rospy.Publisher("/tf", TFMessage, queue_size=10)

    def listens_to_tf(self):
        subscribers = dict(rosgraph.Master("/load_scene_test").getSystemState()[1])
        return "/sim" in subscribers.get("/tf", [])

    def load(self, text):
        answer = self.node.load_scene(scene="", yaml=text)
        self.assertTrue(answer.success, answer.message)
        return answer

    def put_hand(self, x):
        hand = TransformStamped()
        hand.header.stamp = rospy.Time.now()
        hand.header.frame_id, hand.child_frame_id = "world", "hand"
        hand.transform.translation.x, hand.transform.rotation.w = x, 1.0
        self.tf.publish(TFMessage([hand]))

    def test_1_everything_follows_the_new_scene(self):
        self.node.start("small")
        self.node.run_frames(3)
        answer = self.load(TEXT)
        self.assertEqual(answer.particles, 8 * 8 * 2)
        self.assertEqual(answer.message, "scene stirred from the start")
        state = self.node.when(lambda s: s.scene == "stirred", "the scene of the text")
        self.assertEqual((state.frame, state.particles, state.paused), (0, 128, True))
        self.assertEqual(state.gravity.z, -5.0)  # from the parameters of the node
        with Latest("/sim/colliders", MarkerArray) as arrays:
            arrays.wait(
                lambda a: {m.ns for m in a.markers[1:]} == {"bowl", "spoon"}, "its colliders"
            )
        with Latest("/sim/vessels", Vessels) as vessels:
            vessels.wait(lambda m: [v.name for v in m.vessels] == ["bowl", "window"], "its vessels")
        wait_until(self.listens_to_tf, "listening, as a collider follows a frame")

    def test_2_its_colliders_follow_tf(self):
        self.node.resume()
        with Latest("/tf", TFMessage) as tf:

            def at_hand():
                self.put_hand(0.1)
                return [
                    t
                    for m in tf.messages[-20:]
                    for t in m.transforms
                    if t.child_frame_id == SPOON and abs(t.transform.translation.x - 0.1) < 1e-6
                ]

            wait_until(at_hand, "the spoon at the hand")
        self.node.pause()

    def test_3_reset_starts_it_again(self):
        self.load(TEXT)
        self.node.run_frames(5)
        self.assertTrue(self.node.reset(scene="", preset="").success)
        state = self.node.when(lambda s: s.frame == 0, "the start")
        self.assertEqual((state.scene, state.particles), ("stirred", 128))
        answer = self.node.reset(scene="", preset="paper")
        self.assertFalse(answer.success)
        self.assertIn("as text", answer.message)

    def test_4_a_refused_scene_changes_nothing(self):
        hashes = []
        for refused in ([], REFUSED):
            self.load(TEXT)
            self.node.run_frames(3)
            for text, words in refused:
                answer = self.node.load_scene(scene="", yaml=text)
                self.assertFalse(answer.success, text[:100])
                self.assertEqual(answer.particles, 128)
                self.assertLess(len(answer.message), 1500)
                for word in words:
                    self.assertIn(word, answer.message)
            state = self.node.run_frames(3)
            self.assertEqual((state.scene, state.frame), ("stirred", 6))
            hashes.append(self.node.hash())
        self.assertEqual(hashes[0], hashes[1])
        self.node.diagnostic("solver", lambda s: s.level == 0)

    def test_5_a_scene_by_its_name(self):
        answer = self.node.load_scene(scene="warm", yaml="")
        self.assertTrue(answer.success, answer.message)
        state = self.node.when(lambda s: s.scene == "warm", "the scene of that name")
        self.assertEqual(state.particles, answer.particles)
        wait_until(lambda: not self.listens_to_tf(), "the end of listening")
        self.assertTrue(self.node.reset(scene="", preset="").success)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "load_scene", LoadScene)
