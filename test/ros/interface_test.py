#!/usr/bin/python3
"""The content of every topic, and every service with good and bad requests, on a paused scene."""
import math
import pathlib
import struct
import sys
import time
import unittest

import rospy
from geometry_msgs.msg import Vector3
from ice_ice_baby.msg import State
from sensor_msgs import point_cloud2
from sensor_msgs.msg import PointCloud2, PointField
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node, wait_until

PARTICLES = 216  # 0.3 m cubed at 0.05 m


def colour(packed):
    """Red, green and blue of the bits of a float."""
    bits = struct.unpack("<I", struct.pack("<f", packed))[0]
    return bits >> 16 & 255, bits >> 8 & 255, bits & 255


class Interface(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("interface_test")
        cls.node = Node()

    def setUp(self):
        self.node.start()

    def cloud(self, frame=None):
        with Latest("/sim/particles", PointCloud2) as clouds:
            return clouds.wait(what="a cloud")

    def messages_built(self):
        return {t.name: t.messages for t in self.node.state().topics}

    # Topics

    def test_particles(self):
        self.node.run_frames(2)
        cloud = self.cloud()
        self.assertEqual(cloud.header.frame_id, "ice_ice_baby/scene")
        self.assertEqual((cloud.width, cloud.height, cloud.point_step), (PARTICLES, 1, 52))
        self.assertEqual(len(cloud.data), PARTICLES * 52)
        self.assertTrue(cloud.is_dense)
        names = [
            "x",
            "y",
            "z",
            "vx",
            "vy",
            "vz",
            "temperature",
            "ice_fraction",
            "density",
            "pressure",
            "id",
            "phase",
            "rgb",
        ]
        self.assertEqual([f.name for f in cloud.fields], names)
        self.assertEqual([f.offset for f in cloud.fields], [4 * k for k in range(13)])
        self.assertEqual(
            [f.datatype for f in cloud.fields],
            10 * [PointField.FLOAT32] + [PointField.UINT32, PointField.UINT8, PointField.FLOAT32],
        )
        points = list(point_cloud2.read_points(cloud, field_names=names))
        self.assertEqual(sorted(p[10] for p in points), list(range(PARTICLES)))
        for point in points:
            self.assertTrue(all(math.isfinite(value) for value in point))
            self.assertLess(max(abs(point[0]), abs(point[1])), 0.3)
            self.assertTrue(0.0 < point[2] < 0.6)
            self.assertEqual(point[6:8], (20.0, 0.0))
            self.assertTrue(0.2 < point[8] < 1.5)
            self.assertEqual(point[11], 0)  # water
            self.assertEqual(colour(point[12]), colour(points[0][12]))
        self.assertLess(min(p[5] for p in points), -0.1)  # it falls

    def test_state(self):
        self.node.run_frames(3)
        with Latest("/sim/state", State) as states:
            state = states.wait(lambda s: s.frame == 3, "frame 3")
        self.assertEqual(state.header.frame_id, "ice_ice_baby/scene")
        self.assertEqual(
            (state.scene, state.preset, state.precision), ("small", "default", "float")
        )
        self.assertAlmostEqual(state.time_s, 3 / 60.0)
        self.assertEqual((state.particles, state.springs), (PARTICLES, 0))
        self.assertEqual((state.temperature, state.strictness), (20.0, 0.0))
        self.assertEqual((state.thermal, state.targets), (False, []))
        self.assertTrue(state.paused)
        self.assertGreater(state.kinetic_energy_j, 0.0)
        self.assertGreater(state.frame_wall_s, 0.0)
        stages = [stage.name for stage in state.stages]
        self.assertIn("lambda", stages)
        self.assertNotIn("correct_springs", stages)  # water has no springs, so no such stage

    def test_colliders_are_latched(self):
        with Latest("/sim/colliders", MarkerArray) as arrays:
            markers = arrays.wait().markers
        self.assertEqual(markers[0].action, Marker.DELETEALL)
        self.assertEqual({m.ns for m in markers[1:]}, {"container"})
        for marker in markers[1:]:
            norm = sum(getattr(marker.pose.orientation, c) ** 2 for c in "xyzw")
            self.assertAlmostEqual(norm, 1.0)
            self.assertEqual(marker.header.frame_id, "ice_ice_baby/scene")

    def test_static_tf(self):
        with Latest("/tf_static", TFMessage) as static:
            transforms = {t.child_frame_id: t for t in static.wait().transforms}
        scene = transforms["ice_ice_baby/scene"]
        self.assertEqual(scene.header.frame_id, "world")
        self.assertAlmostEqual(scene.transform.translation.x, 1.5)
        self.assertAlmostEqual(scene.transform.rotation.z, math.sqrt(0.5))  # 90 degrees of yaw
        container = transforms["ice_ice_baby/scene/container"]
        self.assertEqual(container.header.frame_id, "ice_ice_baby/scene")
        self.assertAlmostEqual(container.transform.rotation.w, 1.0)

    def test_springs_come_with_ice_and_go_with_it(self):
        with Latest("/sim/springs", MarkerArray) as arrays:
            self.node.set_temperature(temperature=-5.0, ramp_s=0.0)
            springs = self.node.run_frames(2).springs
            self.assertGreater(springs, PARTICLES)
            lines = arrays.wait(lambda a: a.markers[-1].points, "lines").markers[-1]
            self.assertEqual(lines.type, Marker.LINE_LIST)
            self.assertEqual(len(lines.points), 2 * springs)
            self.node.set_temperature(temperature=20.0, ramp_s=0.0)
            self.assertEqual(self.node.run_frames(2).springs, 0)
            arrays.wait(
                lambda a: [m.action for m in a.markers] == [Marker.DELETEALL],
                "the end of the lines",
            )

    def test_diagnostics(self):
        self.node.run_frames(1)
        status = self.node.diagnostic("solver", lambda s: True)
        values = {v.key: v.value for v in status.values}
        self.assertEqual(values["particles"], str(PARTICLES))
        self.assertIn("density_error_mean", values)
        self.assertEqual(values["non_finite"], "0")
        stages = [v.key for v in self.node.diagnostic("real time", lambda s: True).values]
        self.assertIn("lambda [ms per frame]", stages)

    def test_an_error_above_the_promise_is_a_warning(self):
        self.node.start("coarse_steps")
        state = self.node.run_frames(60)
        self.assertFalse(state.quality_met)
        self.assertGreater(state.density_error_run, state.promised_error)
        status = self.node.diagnostic("solver", lambda s: s.level == 1)
        self.assertIn("larger than the 0.2 % asked for; set solver.substeps to 0", status.message)
        self.node.start("small")

    def test_without_subscribers_nothing_is_built(self):
        wait_until(
            lambda: all(t.subscribers == 0 for t in self.node.state().topics),
            "the end of other tests' subscriptions",
        )
        self.node.run_frames(1)
        time.sleep(0.5)  # for the colliders that the reset before this test latches
        before = self.messages_built()
        self.node.set_temperature(temperature=-5.0, ramp_s=0.0)
        self.node.run_frames(30)
        time.sleep(1.2)
        self.assertEqual(self.messages_built(), before)
        self.cloud()
        after = self.messages_built()
        self.assertGreater(after["/sim/particles"], before["/sim/particles"])
        self.assertEqual(after["/sim/springs"], before["/sim/springs"])

    def test_water_sends_no_spring_messages(self):
        with Latest("/sim/springs", MarkerArray) as arrays:
            first = arrays.wait()  # clears what an earlier run may have drawn
            self.assertEqual([m.action for m in first.markers], [Marker.DELETEALL])
            self.node.run_frames(30)
            time.sleep(1.5)
            self.assertEqual(len(arrays.messages), 1)

    # Services

    def test_set_temperature_freezes_and_melts(self):
        fluid = self.node.run_frames(10)
        answer = self.node.set_temperature(temperature=-5.0, ramp_s=0.0)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.temperature, -5.0)
        ice = self.node.run_frames(40)
        self.assertGreater(ice.springs, 0)
        self.assertEqual((ice.strictness, ice.temperature), (1.0, -5.0))
        self.assertLess(ice.rms_speed_m_s, 0.2 * fluid.rms_speed_m_s)
        with Latest("/sim/particles", PointCloud2) as clouds:
            cloud = clouds.wait()
        points = list(
            point_cloud2.read_points(cloud, ["temperature", "ice_fraction", "phase", "rgb"])
        )
        self.assertEqual({p[:3] for p in points}, {(-5.0, 1.0, 1)})
        self.assertTrue(all(min(colour(p[3])) > 200 for p in points))  # nearly white
        self.node.set_temperature(temperature=20.0, ramp_s=0.0)
        self.assertEqual(self.node.run_frames(2).springs, 0)

    def test_set_temperature_over_a_ramp(self):
        answer = self.node.set_temperature(temperature=0.0, ramp_s=1.0)
        self.assertEqual((answer.success, answer.temperature), (True, 20.0))
        self.assertAlmostEqual(self.node.run_frames(30).temperature, 10.0, delta=0.7)

    def test_set_temperature_refuses(self):
        for temperature, ramp_s, named in (
            (math.nan, 0.0, "nan"),
            (-300.0, 0.0, "-300"),
            (5000.0, 0.0, "5000"),
            (0.0, -1.0, "ramp"),
            (0.0, math.inf, "ramp"),
        ):
            answer = self.node.set_temperature(temperature=temperature, ramp_s=ramp_s)
            self.assertFalse(answer.success)
            self.assertIn(named, answer.message)
            self.assertIn("[", answer.message)  # the range
            self.assertEqual(answer.temperature, 20.0)
        self.assertEqual(self.node.run_frames(1).temperature, 20.0)

    def test_reset(self):
        self.node.set_temperature(temperature=-5.0, ramp_s=0.0)
        self.node.run_frames(5)
        answer = self.node.reset(scene="", preset="")
        self.assertEqual((answer.success, answer.particles), (True, PARTICLES))
        state = self.node.when(lambda s: s.frame == 0, "the start")
        self.assertEqual((state.time_s, state.temperature, state.springs), (0.0, 20.0, 0))
        self.assertEqual(state.scene, "small")

    def test_reset_to_another_scene_and_preset(self):
        answer = self.node.reset(scene="followed", preset="paper")
        self.assertTrue(answer.success, answer.message)
        state = self.node.when(lambda s: s.scene == "followed", "the other scene")
        self.assertEqual((state.particles, state.preset), (answer.particles, "paper"))
        with Latest("/sim/colliders", MarkerArray) as arrays:
            arrays.wait(
                lambda a: {m.ns for m in a.markers[1:]} == {"container", "ground", "ball"},
                "the colliders of the other scene",
            )

    def test_reset_refuses(self):
        self.node.run_frames(3)
        for scene, preset in (
            ("smal", ""),
            ("/etc/passwd", ""),
            ("../scenes/small", ""),
            ("small.yaml", ""),
            ("small", "quick"),
        ):
            answer = self.node.reset(scene=scene, preset=preset)
            self.assertFalse(answer.success)
            self.assertIn(preset or scene, answer.message)
            self.assertEqual(answer.particles, PARTICLES)
        self.assertIn("did you mean small", self.node.reset(scene="smal", preset="").message)
        self.assertEqual(self.node.run_frames(1).frame, 4)

    def test_step_and_pause(self):
        self.assertEqual(self.node.run_frames(7).frame, 7)
        self.assertTrue(self.node.step(frames=0).success)  # counts as 1
        self.node.when(lambda s: s.frame == 8, "one frame")
        time.sleep(0.3)
        self.assertEqual(self.node.state().frame, 8)
        answer = self.node.step(frames=100001)
        self.assertFalse(answer.success)
        self.assertIn("100001", answer.message)

    def test_resume(self):
        self.assertTrue(self.node.resume().success)
        self.node.when(lambda s: s.frame > 5 and not s.paused, "frames")
        answer = self.node.step(frames=1)
        self.assertFalse(answer.success)
        self.assertIn("paused", answer.message)
        self.assertTrue(self.node.pause().success)
        frame = self.node.when(lambda s: s.paused, "the pause").frame
        time.sleep(0.3)
        self.assertEqual(self.node.state().frame, frame)

    def test_set_gravity(self):
        answer = self.node.set_gravity(gravity=Vector3(0.0, 0.0, 0.0))
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.gravity.z, 0.0)
        self.assertLess(self.node.run_frames(10).rms_speed_m_s, 0.05)
        self.node.set_gravity(gravity=Vector3(0.0, 0.0, 2.0))
        self.assertGreater(self.node.run_frames(10).rms_speed_m_s, 0.2)
        for bad in (math.nan, 1e5):
            answer = self.node.set_gravity(gravity=Vector3(0.0, bad, 0.0))
            self.assertFalse(answer.success)
            self.assertIn("gravity", answer.message)
            self.assertEqual(answer.gravity.z, 2.0)

    def test_set_source(self):
        self.node.start("tap")
        self.assertEqual(self.node.run_frames(10).poured, 0)
        answer = self.node.set_source(name="tap", open=True, flow_l_min=0.0)
        self.assertTrue(answer.success, answer.message)
        self.assertAlmostEqual(answer.flow_l_min, 60000 * math.pi * 0.08**2, places=6)
        state = self.node.run_frames(30)
        expected = 0.5 * math.pi * 0.08**2 / 0.05**3
        self.assertAlmostEqual(state.poured, expected, delta=8)
        self.assertEqual(state.particles, state.poured)
        answer = self.node.set_source(name="tap", open=True, flow_l_min=2400.0)
        self.assertEqual((answer.success, answer.flow_l_min), (True, 2400.0))
        faster = self.node.run_frames(15)
        self.assertAlmostEqual(faster.poured - state.poured, 0.25 * 0.04 / 0.05**3, delta=8)
        answer = self.node.set_source(name="tap", open=False, flow_l_min=0.0)
        self.assertEqual((answer.success, answer.flow_l_min), (True, 2400.0))
        self.assertEqual(self.node.run_frames(15).poured, faster.poured)

    def test_set_source_refuses(self):
        self.node.start("tap")
        for name, flow_l_min, named in (
            ("tab", 0.0, "tap, hose"),
            ("", 0.0, "tap, hose"),
            ("tap", -1.0, "-1"),
            ("tap", math.nan, "nan"),
            ("tap", 1e5, "range [0, 36191"),
        ):
            answer = self.node.set_source(name=name, open=True, flow_l_min=flow_l_min)
            self.assertFalse(answer.success)
            self.assertIn(named, answer.message)
        self.assertEqual(self.node.run_frames(20).poured, 0)

    def test_a_source_that_stops_at_the_limit_is_a_warning(self):
        self.node.start("tap")
        self.node.set_source(name="tap", open=True, flow_l_min=0.0)
        state = self.node.run_frames(90)
        self.assertEqual(state.sources_stopped, 1)
        self.assertLessEqual(state.particles, 200)
        status = self.node.diagnostic("solver", lambda s: s.level == 1)
        self.assertIn("1 source has stopped", status.message)
        self.assertIn("limits.max_particles = 200", status.message)
        self.node.set_source(name="tap", open=False, flow_l_min=0.0)
        self.node.diagnostic("solver", lambda s: s.level == 0)

    def test_get_state(self):
        answer = self.node.get_state()
        self.assertTrue(answer.success)
        scenes = pathlib.Path(__file__).resolve().parent.glob("scenes/*.yaml")
        self.assertEqual(answer.scenes, sorted(scene.stem for scene in scenes))
        self.assertEqual(
            [t.name for t in answer.state.topics],
            ["/sim/" + t for t in ("particles", "springs", "colliders", "state", "vessels")],
        )


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "interface", Interface)
