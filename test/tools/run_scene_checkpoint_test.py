"""Contract of run_scene --save, --autosave and --load: a run survives a kill at any time."""
import json
import signal
import subprocess
import time
import unittest

from run_scene_case import RUN_SCENE, RunSceneCase


class Checkpoints(RunSceneCase):
    DURATION_S = 4
    SCHEDULE = "schedule: [{at_s: 1, celsius: -10, ramp_s: 0.5}, {at_s: 2, celsius: 20, ramp_s: 0.5}]"

    def setUp(self):
        super().setUp()
        self.checkpoint = self.folder / "run.ckpt"

    def start(self, *words):
        process = subprocess.Popen([RUN_SCENE, *map(str, words)], text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def report(self, *words):
        path = self.folder / "report.json"
        result = self.run_scene("--report", path, *words)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(path.read_text())

    def wait_for_a_checkpoint(self, process):
        """Until a new file is in place or the run is over."""
        before = self.checkpoint.stat().st_ino if self.checkpoint.exists() else None
        while process.poll() is None:
            if self.checkpoint.exists() and self.checkpoint.stat().st_ino != before:
                return
            time.sleep(0.001)

    def test_a_run_in_two_parts_is_the_run_in_one(self):
        for precision in ("float", "double"):
            whole = self.report(self.scene, "--duration", 2, "--precision", precision)
            self.report(self.scene, "--duration", 1.5, "--precision", precision,
                        "--save", self.checkpoint)
            for threads in (1, 2):
                rest = self.report("--load", self.checkpoint, "--duration", 2,
                                   "--threads", threads)
                for key in ("state_hash", "simulated_time_s", "frames", "kinetic_energy_j",
                            "springs", "precision", "temperature_c"):
                    self.assertEqual(rest[key], whole[key], key)
                self.assertEqual(rest["error"], {}, "metrics are those of whole runs")

    def test_without_a_duration_it_ends_where_the_scene_does_and_then_has_nothing_to_do(self):
        self.report(self.scene, "--duration", 3.5, "--save", self.checkpoint)
        first = self.report("--load", self.checkpoint, "--save", self.checkpoint)
        self.assertEqual(first["simulated_time_s"], 4)
        again = self.report("--load", self.checkpoint)
        self.assertEqual((again["steps"], again["state_hash"]), (0, first["state_hash"]))

    def test_killed_again_and_again_it_comes_to_the_same_end(self):
        whole = self.report(self.scene)
        begin = [self.scene]
        for _ in range(6):
            process = self.start(*begin, "--save", self.checkpoint, "--autosave", 0.1)
            self.wait_for_a_checkpoint(process)
            process.kill()
            process.communicate()
            begin = ["--load", self.checkpoint]
        end = self.report(*begin, "--save", self.checkpoint, "--autosave", 0.1)
        self.assertEqual(end["state_hash"], whole["state_hash"])
        left = sorted(path.name for path in self.folder.iterdir())
        self.assertEqual(left, ["report.json", "run.ckpt", "small.yaml"])

    def test_asked_to_stop_it_saves_and_says_how_to_go_on(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            process = self.start(self.scene, "--save", self.checkpoint, "--autosave", 0.02,
                                 "--duration", 100000)
            self.wait_for_a_checkpoint(process)
            process.send_signal(number)
            _, said = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 0, said)
            self.assertIn(f"--load {self.checkpoint}", said)
            self.assertEqual(self.report("--load", self.checkpoint, "--duration", 0)["steps"], 0)

    def test_an_unstable_end_leaves_the_older_checkpoint(self):
        self.report(self.scene, "--duration", 0.1, "--save", self.checkpoint)
        older = self.checkpoint.read_bytes()
        result = self.run_scene(self.scene, "--set", "solver.max_speed_m_s=0.01",
                                "--duration", 0.2, "--save", self.checkpoint)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(self.checkpoint.read_bytes(), older)

    def test_bad_input_is_one_line_that_says_what(self):
        self.report(self.scene, "--duration", 0.1, "--save", self.checkpoint)
        load = ["--load", self.checkpoint]
        short = self.folder / "short.ckpt"
        short.write_bytes(self.checkpoint.read_bytes()[:-100])
        nowhere = self.folder / "no" / "run.ckpt"
        cases = [([*load, self.scene], "a scene contradict"),
                 ([*load, "--set", "solver.iterations=3"], "--set contradict"),
                 ([*load, "--preset", "paper"], "--preset contradict"),
                 ([*load, "--quality", "fast"], "--quality contradict"),
                 ([*load, "--precision", "double"], "--precision contradict"),
                 (["--load", short], "short.ckpt: truncated"),
                 (["--load", self.scene], "small.yaml: not a checkpoint"),
                 (["--load", nowhere], "no checkpoint"),
                 ([self.scene, "--autosave", 1], "--autosave needs --save"),
                 ([self.scene, "--save", self.checkpoint, "--autosave", "-1"], "--autosave"),
                 ([self.scene, "--save", nowhere], f"{nowhere}: No such file"),
                 ([self.scene, "--save", self.folder], "is not a file"),
                 ([self.scene, "--save", "/dev/full"], "/dev/full")]
        for words, clue in cases:
            with self.subTest(words=words):
                self.assertIn(clue, self.refused(*words))


if __name__ == "__main__":
    unittest.main()
