#!/usr/bin/python3
"""Save, load, autosave and resume, also of a node that is killed at any moment."""
import glob
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import rospy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Node, wait_until

from processes import SIMULATION_NODE

SPACING_M = 0.02  # 3375 particles: a file that takes a while to write


class Checkpoint(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("checkpoint_test")

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.child = None
        if rospy.has_param("/sim"):
            rospy.delete_param("/sim")

    def tearDown(self):
        try:
            if self.child:  # a clean end, so that coverage is written
                self.child.terminate()
                self.child.wait(timeout=30)
        finally:
            self.kill()
            self.folder.cleanup()

    def kill(self):
        if self.child:
            self.child.kill()
            self.child.wait()

    def start(self, *parameters, prefix=(), scene="small"):
        """A paused node /sim that keeps its checkpoints in the folder of the test."""
        self.run_node(
            "scene:=" + scene, "checkpoint_folder:=" + self.folder.name, *parameters, prefix=prefix
        )
        return self.wait_for_node()

    def run_node(self, *parameters, prefix=(), env=None):
        self.kill()
        words = [
            "threads:=1",
            "start_paused:=true",
            "overrides/fluid/spacing_m:=%g" % SPACING_M,
            *parameters,
        ]
        with open(os.path.join(self.folder.name, "log"), "a", encoding="utf-8") as log:
            self.child = subprocess.Popen(
                [*prefix, SIMULATION_NODE, "__name:=sim", *("_" + word for word in words)],
                stdout=log,
                stderr=log,
                env=env,
            )

    def wait_for_node(self):
        node = Node()
        wait_until(lambda: self.ready(node), "the node")
        return node

    @staticmethod
    def ready(node):
        try:
            return node.state().state_hash
        except rospy.ServiceException:
            return False  # the master still names the killed node

    def log(self):
        with open(os.path.join(self.folder.name, "log"), encoding="utf-8") as log:
            return log.read()

    def files(self):
        return sorted(os.path.basename(f) for f in glob.glob(self.folder.name + "/*.ckpt"))

    def wait_for_quiet(self):
        """Waits until autosaves have caught up with the paused scene."""

        def written():
            return [os.stat(f).st_mtime_ns for f in sorted(glob.glob(self.folder.name + "/*.ckpt"))]

        before = None
        while written() != before:
            before = written()
            time.sleep(1.0)

    def test_goes_on_with_the_same_bits(self):
        node = self.start()
        node.run_frames(3)
        saved = node.save(name="three")
        self.assertTrue(saved.success, saved.message)
        self.assertEqual(saved.file, os.path.join(self.folder.name, "three.ckpt"))
        self.assertEqual(saved.bytes, os.path.getsize(saved.file))
        node.set_temperature(temperature=-5.0)
        frozen = node.save(name="cold")  # with a command that no frame has seen yet
        self.assertTrue(frozen.success, frozen.message)
        node.run_frames(4)
        expected = node.hash()
        node.start("warm")
        answer = node.load(name="three")
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.message, "scene small goes on from frame 3")
        state = node.when(lambda s: s.scene == "small" and s.state_hash, "the loaded scene")
        self.assertEqual((state.frame, state.particles, state.temperature), (3, 3375, 20.0))
        self.assertEqual(answer.particles, 3375)
        node.load(name="cold")
        node.run_frames(4)
        self.assertEqual(node.hash(), expected)
        self.assertIn("came from a checkpoint", node.reset(scene="", preset="paper").message)
        self.assertTrue(node.reset(scene="", preset="").success)
        node.when(lambda s: s.frame == 0 and s.scene == "small", "its start")

    # The default folder

    def home(self):
        """The environment of a user whose home is empty."""
        home = os.path.join(self.folder.name, "home")
        os.makedirs(home, exist_ok=True)
        env = dict(os.environ, HOME=home)
        env.pop("ROS_HOME", None)
        return env, os.path.join(home, ".ros", "ice_ice_baby", "sim")

    def assert_ends_with_1(self, *words):
        self.assertEqual(self.child.wait(timeout=20), 1, self.log())
        for word in words:
            self.assertIn(word, self.log())

    def test_save_and_load_create_the_default_folder(self):
        env, default = self.home()
        self.run_node("scene:=small", env=env)
        node = self.wait_for_node()
        self.assertFalse(os.path.exists(default))  # not before it is needed
        self.assertIn("call save first", node.load(name="first").message)
        answer = node.save(name="first")
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.file, os.path.join(default, "first.ckpt"))
        self.assertTrue(os.path.isfile(answer.file))
        answer = node.load(name="first")
        self.assertTrue(answer.success, answer.message)

    def test_autosave_and_resume_create_the_default_folder(self):
        env, default = self.home()
        parameters = ["scene:=small", "autosave_s:=0.1", "resume:=true"]
        self.run_node(*parameters, env=env)
        node = self.wait_for_node()

        def saved_twice():
            node.run_frames(1)  # a paused node saves after a frame only
            return os.path.exists(os.path.join(default, "autosave_2.ckpt"))

        wait_until(saved_twice, "autosaves")
        self.run_node(*parameters, env=env)
        self.assertGreater(self.wait_for_node().state().frame, 0)
        self.assertNotIn("ERROR", self.log())

    def test_a_folder_that_cannot_be_created_is_a_warning_and_save_is_refused(self):
        env, default = self.home()
        with open(os.path.join(env["HOME"], ".ros"), "w", encoding="utf-8"):
            pass  # a file where the folder should be
        env["ROS_LOG_DIR"] = self.folder.name
        self.run_node("scene:=small", env=env)
        node = self.wait_for_node()
        self.assertIn(
            "save will be refused: cannot use the checkpoint folder " + default, self.log()
        )
        before = node.hash()
        for answer in (node.save(name="first"), node.load(name="first")):
            self.assertFalse(answer.success)
            self.assertIn("cannot use the checkpoint folder " + default, answer.message)
            self.assertIn("set ~checkpoint_folder", answer.message)
        self.assertEqual(node.hash(), before)
        node.run_frames(1)
        os.unlink(os.path.join(env["HOME"], ".ros"))
        self.assertTrue(node.save(name="first").success)  # cured while the node runs

    def test_autosave_or_resume_without_a_usable_folder_ends_with_exit_code_1(self):
        env, default = self.home()
        with open(os.path.join(env["HOME"], ".ros"), "w", encoding="utf-8"):
            pass
        env["ROS_LOG_DIR"] = self.folder.name
        for parameter in ("autosave_s:=10", "resume:=true"):
            if rospy.has_param("/sim"):
                rospy.delete_param("/sim")
            self.run_node("scene:=small", parameter, env=env)
            self.assert_ends_with_1(default, "set ~checkpoint_folder")
        del env["HOME"]
        rospy.delete_param("/sim")
        self.run_node("scene:=small", "autosave_s:=10", env=env)
        self.assert_ends_with_1("neither ROS_HOME nor HOME")

    def test_a_read_only_folder_is_refused_by_name(self):
        if subprocess.run(["unshare", "-m", "true"], check=False, capture_output=True).returncode:
            self.skipTest("needs the right to mount a read-only folder")
        env, _ = self.home()
        read_only = [
            "unshare",
            "-m",
            "sh",
            "-c",
            'mount -t tmpfs -o ro tmpfs %s; exec "$0" "$@"' % env["HOME"],
        ]
        env["ROS_LOG_DIR"] = self.folder.name
        self.run_node("scene:=small", prefix=read_only, env=env)
        answer = self.wait_for_node().save(name="first")
        self.assertFalse(answer.success)
        self.assertIn("Read-only file system", answer.message)
        self.run_node("scene:=small", "autosave_s:=10", prefix=read_only, env=env)
        self.assert_ends_with_1("Read-only file system")

    # Broken and interrupted

    def test_a_broken_file_is_refused_and_changes_nothing(self):
        node = self.start()
        node.run_frames(2)
        saved = node.save(name="good")
        before = node.hash()
        with open(saved.file, "rb") as good:
            whole = good.read()
        flipped = bytearray(whole)
        flipped[len(whole) // 2] ^= 1
        for name, content in (
            ("empty", b""),
            ("cut", whole[: len(whole) // 2]),
            ("flipped", bytes(flipped)),
            ("text", b"name: small\n"),
        ):
            with open(os.path.join(self.folder.name, name + ".ckpt"), "wb") as broken:
                broken.write(content)
            answer = node.load(name=name)
            self.assertFalse(answer.success)
            self.assertIn(name + ".ckpt", answer.message)
            self.assertEqual((node.hash(), node.state().frame), (before, 2))

    def test_killed_at_any_moment_it_goes_on(self):
        chance = random.Random(7)
        hashes, saved = {}, [0]
        for _ in range(6):
            node = self.start("autosave_s:=0.1", "resume:=true")
            state = node.state()
            if hashes:
                self.assertGreaterEqual(state.frame, saved[0])
                self.assertEqual(state.state_hash, hashes[state.frame])
            frame = state.frame
            hashes[frame] = state.state_hash
            saver = threading.Thread(target=self.save_on, args=(node, saved))
            saver.start()
            for frame in range(frame + 1, frame + 1 + chance.randrange(2, 8)):
                hashes[frame] = self.hash_after_a_frame(node, frame)
            time.sleep(chance.random() * 0.2)
            self.child.send_signal(signal.SIGKILL)
            self.child.wait()
            saver.join()
        self.assertGreater(saved[0], 0)
        self.assertNotIn("Cannot resume", self.log())
        self.assertLessEqual(
            set(self.files()), {"autosave_1.ckpt", "autosave_2.ckpt", "by_hand.ckpt"}
        )

    @staticmethod
    def hash_after_a_frame(node, frame):
        node.step(frames=1)
        return node.when(lambda s: s.frame == frame and s.state_hash, "a frame").state_hash

    @staticmethod
    def save_on(node, saved):
        """Saves until the node is killed; notes the last frame known to be on disk."""
        try:
            while True:
                frame = node.state().frame
                if node.save(name="by_hand").success:
                    saved[0] = frame
        except rospy.ServiceException:
            pass  # killed

    def test_resumes_from_the_newest_whole_one(self):
        node = self.start("autosave_s:=0.1", "resume:=true")  # no checkpoint yet: the scene
        self.assertEqual(node.state().frame, 0)
        node.run_frames(2)
        wait_until(lambda: "autosave_1.ckpt" in self.files(), "an autosave")
        node.run_frames(2)
        wait_until(lambda: len(self.files()) == 2, "two autosaves")
        node.run_frames(1)
        self.wait_for_quiet()
        self.assertEqual(len(self.files()), 2)
        self.assertEqual(self.start("resume:=true", "autosave_s:=0").state().frame, 5)
        newest = max(glob.glob(self.folder.name + "/*.ckpt"), key=os.path.getmtime)
        os.truncate(newest, 100)
        node = self.start("resume:=true")
        self.assertIn(node.state().frame, (1, 2, 3, 4))
        status = node.diagnostic("checkpoints", lambda s: s.level == 1)
        self.assertIn(newest, status.message)
        self.assertIn("resumed from autosave", status.message)
        for file in glob.glob(self.folder.name + "/*.ckpt"):
            os.truncate(file, 100)
        node = self.start("resume:=true")
        self.assertEqual(node.state().frame, 0)
        status = node.diagnostic("checkpoints", lambda s: s.level == 1)
        self.assertIn("started the scene instead", status.message)

    def test_a_full_disk_is_reported_and_the_node_goes_on(self):
        if subprocess.run(["unshare", "-m", "true"], check=False, capture_output=True).returncode:
            self.skipTest("needs the right to mount a small disk")
        full = [
            "unshare",
            "-m",
            "sh",
            "-c",
            'mount -t tmpfs -o size=64k tmpfs %s; exec "$0" "$@"' % self.folder.name,
        ]
        node = self.start("autosave_s:=0.3", prefix=full)
        node.run_frames(2)
        before = node.hash()
        answer = node.save(name="large")
        self.assertFalse(answer.success)
        self.assertIn("large.ckpt", answer.message)
        self.assertIn("No space left", answer.message)
        status = node.diagnostic("checkpoints", lambda s: s.level == 2)
        self.assertIn("No space left", status.message)
        self.assertEqual(node.hash(), before)
        node.run_frames(2)

    def test_colliders_follow_on_after_a_load(self):
        node = self.start(scene="followed")
        node.run_frames(1)
        node.save(name="followed")
        node.start("small")
        self.assertTrue(node.load(name="followed").success)
        node.when(lambda s: s.scene == "followed", "the load")
        node.run_frames(1)
        status = node.diagnostic("followed frames", lambda s: s.level == 1)
        self.assertIn("follows tf frame hand", status.message)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "checkpoint", Checkpoint)
