#!/usr/bin/python3
"""Every bad request is refused with what is wrong and what is allowed, and changes nothing."""
import math
import pathlib
import sys
import unittest

import rospy
from geometry_msgs.msg import Point, Vector3

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import TYPES, Node

NAN, INF = math.nan, math.inf
LONG = "x" * 100000
ODD = 'a\x00b\n"\\'


def torch(**changes):
    return dict(
        dict(
            shape="sphere",
            centre=Point(0.0, 0.0, 0.2),
            size=Vector3(0.2, 0.2, 0.2),
            power_w=500.0,
            duration_s=1.0,
        ),
        **changes,
    )


# Service, request, what the answer must contain: the thing, and the range or the cure.
ALWAYS = [
    ("set_temperature", dict(temperature=NAN), ["temperature", "nan", "[-273.15, 1000]"]),
    ("set_temperature", dict(temperature=-INF), ["temperature", "-inf", "[-273.15, 1000]"]),
    ("set_temperature", dict(temperature=-273.16), ["-273.16", "[-273.15, 1000]"]),
    ("set_temperature", dict(temperature=1e300), ["1e+300", "[-273.15, 1000]"]),
    ("set_temperature", dict(temperature=5.0, ramp_s=-1.0), ["ramp", "-1", "[0, 1e+06]"]),
    ("set_temperature", dict(temperature=5.0, ramp_s=NAN), ["ramp", "nan", "[0, 1e+06]"]),
    ("set_temperature", dict(temperature=5.0, target=LONG), ["xxx"]),
    ("set_temperature", dict(temperature=5.0, target=ODD), ["a"]),
    ("set_gravity", dict(gravity=Vector3(NAN, 0, 0)), ["gravity", "nan", "[-10000, 10000]"]),
    ("set_gravity", dict(gravity=Vector3(0, INF, 0)), ["gravity", "inf", "[-10000, 10000]"]),
    ("set_gravity", dict(gravity=Vector3(0, 0, -10001)), ["-10001", "[-10000, 10000]"]),
    ("set_heat_region", dict(name="gunn", active=True), ["gunn"]),
    ("set_heat_region", dict(name=LONG, active=True), ["xxx"]),
    ("set_heat_region", dict(name=ODD, active=True), ["a"]),
    ("set_source", dict(name="tab", open=True), ["tab"]),
    ("set_source", dict(name=LONG, open=True), ["xxx"]),
    ("set_source", dict(name=ODD, open=True), ["a"]),
    ("attach", dict(solid="cup", frame="gripper"), ["cup", "has none"]),
    ("attach", dict(solid=LONG, frame="gripper"), ["xxx", "has none"]),
    ("attach", dict(solid=ODD), ["a", "has none"]),
    ("reset", dict(scene="smal"), ["smal", "did you mean small"]),
    ("reset", dict(scene="../scenes/small"), ["../scenes/small", "small"]),
    ("reset", dict(scene="/etc/passwd"), ["/etc/passwd", "small"]),
    ("reset", dict(scene=LONG), ["xxx", "small"]),
    ("reset", dict(scene=ODD), ["a", "small"]),
    ("reset", dict(scene="small", preset="quick"), ["quick", "default, paper"]),
    ("reset", dict(preset="quick"), ["quick", "default, paper"]),
    ("reset", dict(scene="warm", preset="paper"), ["thermal.enabled", "paper"]),
    ("step", dict(frames=100001), ["frames to step", "100001", "[1, 1e+05]"]),
    ("step", dict(frames=2**32 - 1), ["4294967295", "[1, 1e+05]"]),
    ("save", dict(name=""), ["name", "1 to 64"]),
    ("save", dict(name="../up"), ["../up", "1 to 64", "~checkpoint_folder"]),
    ("save", dict(name="/tmp/there"), ["/tmp/there", "1 to 64", "~checkpoint_folder"]),
    ("save", dict(name="a.b"), ["a.b", "1 to 64"]),
    ("save", dict(name=LONG), ["xxx", "1 to 64"]),
    ("save", dict(name=ODD), ["1 to 64"]),
    ("save", dict(name="autosave_1"), ["autosave_1", "does not begin with"]),
    ("load", dict(name="never_saved"), ["never_saved", "call save first"]),
    ("load", dict(name="../../etc/passwd"), ["1 to 64", "~checkpoint_folder"]),
    ("load_scene", dict(), ["scene and yaml are both empty"]),
    ("load_scene", dict(scene="small", yaml="{}"), ["small", "both given"]),
    ("load_scene", dict(scene="smal"), ["smal", "did you mean small"]),
    ("load_scene", dict(scene="../scenes/small"), ["../scenes/small", "small"]),
    ("load_scene", dict(scene=LONG), ["xxx", "small"]),
    ("load_scene", dict(yaml=LONG), ["a scene is a map of keys"]),
    ("load_scene", dict(yaml="fluid: {spacing_m: .nan}"), ["fluid.spacing_m = nan", "["]),
    ("load_scene", dict(yaml="gravity: 1"), ["unknown key gravity", "gravity_m_s2"]),
    ("load_scene", dict(yaml="meshes: [{file: /etc/passwd}]"), ["/etc/passwd", "package://"]),
]
WITHOUT_HEAT = [
    ("set_temperature", dict(temperature=5.0, target="container"), ["thermal.enabled"]),
    ("heat_region", torch(), ["thermal.enabled"]),
]
WITH_HEAT = [
    ("set_temperature", dict(temperature=5.0, target="plat"), ["plat", "container, plate"]),
    ("set_temperature", dict(temperature=NAN, target="plate"), ["nan", "[-273.15, 1000]"]),
    ("heat_region", torch(shape="cone"), ["cone", "box, sphere"]),
    ("heat_region", torch(shape=LONG), ["xxx", "box, sphere"]),
    ("heat_region", torch(centre=Point(NAN, 0, 0)), ["centre x", "nan", "["]),
    ("heat_region", torch(centre=Point(0, 1e9, 0)), ["centre y", "1e+09", "["]),
    ("heat_region", torch(size=Vector3(0.1, 0.1, -0.1)), ["size z", "-0.1", "[0, 200]"]),
    ("heat_region", torch(size=Vector3(201, 0.1, 0.1)), ["size x", "201", "[0, 200]"]),
    ("heat_region", torch(power_w=NAN), ["power", "nan", "["]),
    ("heat_region", torch(power_w=-2e9), ["power", "-2e+09", "["]),
    ("heat_region", torch(duration_s=INF), ["duration", "inf", "[0, 1e+06]"]),
]
WITH_SOURCES = [
    ("set_source", dict(name="tab", open=True), ["tab", "tap, hose"]),
    ("set_source", dict(name="tap", open=True, flow_l_min=NAN), ["tap", "nan", "[0, "]),
    ("set_source", dict(name="tap", open=True, flow_l_min=-INF), ["tap", "-inf", "[0, "]),
    ("set_source", dict(name="hose", open=True, flow_l_min=1e9), ["hose", "1e+09", "[0, "]),
]
WITH_REGIONS = [
    ("set_heat_region", dict(name="gunn", active=True), ["gunn", "gun, spray"]),
    ("set_heat_region", dict(name="gun", active=True, power_w=NAN), ["gun", "nan", "[-1e+09"]),
    ("set_heat_region", dict(name="gun", active=True, power_w=INF), ["gun", "inf", "[-1e+09"]),
    ("set_heat_region", dict(name="gun", active=True, power_w=-2e9), ["-2e+09", "[-1e+09"]),
]
RUNNING = [("step", dict(frames=1), ["paused", "call pause first"])]
WITHOUT_FIELDS = {"get_state", "pause", "resume"}  # their requests are empty


class Refusals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("refusals_test")
        cls.node = Node()

    def scene_state(self):
        """Everything in get_state about the scene, with its hash."""
        state = self.node.when(lambda s: s.state_hash, "a hash, so a pause")
        state.header.stamp, state.topics = rospy.Time(0), []
        return str(state)

    def refuse(self, service, request, words):
        answer = getattr(self.node, service)(**request)
        named = "%s(%s): %s" % (service, str(request)[:200], answer.message[:500])
        self.assertFalse(answer.success, named)
        self.assertLess(len(answer.message), 1500, service)
        for word in words:
            self.assertIn(word, answer.message, named)

    def refuse_all(self, scene, table):
        """The same frames without and with refused requests in between end in the same state."""
        hashes = []
        for bad in ([], table):
            self.node.start(scene)
            self.node.run_frames(3)
            for service, request, words in bad:
                before = self.scene_state()
                self.refuse(service, request, words)
                self.assertEqual(self.scene_state(), before, service)
            self.node.run_frames(5)
            hashes.append(self.node.hash())
        self.assertEqual(hashes[0], hashes[1])

    def test_every_service_is_asked(self):
        asked = {service for service, _, _ in ALWAYS + WITH_HEAT}
        self.assertEqual(asked, set(TYPES) - WITHOUT_FIELDS)

    def test_without_heat(self):
        self.refuse_all("small", ALWAYS + WITHOUT_HEAT)

    def test_with_heat(self):
        self.refuse_all("warm", ALWAYS + WITH_HEAT)

    def test_with_sources(self):
        self.refuse_all("tap", WITH_SOURCES)

    def test_with_heat_regions(self):
        self.refuse_all("steered", WITH_REGIONS)

    def test_while_running(self):
        self.node.start("small")
        self.node.resume()
        for service, request, words in RUNNING:
            self.refuse(service, request, words)
        self.node.pause()
        self.node.diagnostic("solver", lambda s: s.level == 0)  # nothing failed later


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "refusals", Refusals)
