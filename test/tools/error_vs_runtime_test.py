"""error_vs_runtime: tables, pictures, resuming, refusals; a stub in place of run_scene."""
import contextlib
import csv
import io
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import textwrap
import time
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.common.paths import ROOT
from iib.error_runtime import cli, peers, studies

RUN_SCENE = sys.argv.pop(1)
PROGRAM = ROOT / "scripts" / "error_vs_runtime"

# Answers as run_scene does, at once; error halves and time doubles with every doubling of substeps.
STUB = """#!/usr/bin/python3
import json, pathlib, sys, time
words = sys.argv[1:]
keys = dict(w.split("=", 1) for k, w in zip(words, words[1:]) if k == "--set")
substeps = int(keys.get("solver.substeps", 8))
if words[0] == "none": sys.exit(print("run_scene: no scene none", file=sys.stderr) or 1)
if "solver.nonsense" in keys:
    sys.exit(print("run_scene: no key solver.nonsense", file=sys.stderr) or 1)
if substeps == 0:
    sys.exit(print("run_scene: substeps = 0 is outside [1, 1000]", file=sys.stderr) or 1)
if "--duration" in words and words[words.index("--duration") + 1] == "0": sys.exit(0)
log = pathlib.Path(__file__).with_name("log")
with log.open("a") as file: file.write(f"{substeps}\\n")
time.sleep(float(keys.get("sleep", 0)))
unstable = substeps == 1
report = dict(particles=1000, springs=0, simulated_time_s=1.0, frames=60,
              wall_time_s=0.01 * substeps, state_hash="0" * 16,
              max_speed_m_s=1.0, rms_speed_m_s=0.5, residual_speed_m_s=0.5,
              threads=2, precision="float", preset="default",
              error=dict(density_mean=0.08 / substeps, density_max=0.8 / substeps,
                         energy_rise=0.001),
              settings=dict(fluid=dict(spacing_m=0.1),
                            solver=dict(substeps=substeps, frame_rate_hz=60.0)))
pathlib.Path(words[words.index("--report") + 1]).write_text(json.dumps(report))
if unstable: sys.exit(print("run_scene: became unstable: it flew apart", file=sys.stderr) or 2)
"""
PEERS = """\
peer,method,setting,particles,threads,precision,us_per_particle_per_s,mean_error_percent,\
max_error_percent
Other,DFSPH,tol 1 %,5415,2,float,609,0.198,5.0
Other,DFSPH,tol .1 %,5415,2,float,563,0.097,
"""


class Program(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.stub = self.folder / "run_scene"
        self.stub.write_text(STUB)
        self.stub.chmod(0o755)
        self.out = self.folder / "out"

    def words(self, *more):
        tables_only = [] if "--peers" in more else ["--no-pictures"]  # pictures take seconds
        start = [PROGRAM, "--run-scene", self.stub, "--out", self.out]
        return [str(word) for word in (*start, *tables_only, *more)]

    def go(self, *more, code=0):
        """In this process, as a new one imports the same modules again for most of a second."""
        output, errors = io.StringIO(), io.StringIO()
        words, redirected = self.words(*more), contextlib.ExitStack()
        with redirected:
            redirected.enter_context(mock.patch.object(sys, "argv", words))
            redirected.enter_context(contextlib.redirect_stdout(output))
            redirected.enter_context(contextlib.redirect_stderr(errors))
            try:
                left_with = cli.main()
            except SystemExit as left:
                left_with = left.code
        done = subprocess.CompletedProcess(words, left_with, output.getvalue(), errors.getvalue())
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def refused(self, *more):
        done = self.go(*more, code=1)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        return done.stderr

    def rows(self):
        with (self.out / "points.csv").open(newline="") as file:
            return list(csv.DictReader(file))

    def log(self):
        path = self.folder / "log"
        return path.read_text().split() if path.exists() else []

    def test_writes_tables_and_pictures(self):
        table = self.folder / "peers.csv"
        table.write_text(PEERS)
        done = self.go("--scene", "any", "--substeps", "2,4", "--repeats", 2, "--peers", table)
        self.assertEqual(done.stderr, "", "no progress bar in a pipe")
        rows = self.rows()
        self.assertEqual([row["solver.substeps"] for row in rows], ["2", "4"])
        self.assertEqual([row["repeats"] for row in rows], ["2", "2"])
        self.assertAlmostEqual(float(rows[0]["us_per_particle_per_s"]), 20)
        self.assertAlmostEqual(float(rows[0]["density_mean"]), 0.04)
        self.assertEqual([row["on_front"] for row in rows], ["1", "1"])
        document = json.loads((self.out / "points.json").read_text())
        for key in ("processor", "commit", "date", "command", "campaign", "points"):
            self.assertTrue(document[key], key)
        self.assertIn("--substeps 2,4", document["command"])
        for name in ("error.png", "metrics.png"):
            self.assertEqual((self.out / name).read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(self.log(), ["2", "4", "2", "4"], "rounds, one run at a time")

    def test_does_nothing_twice_and_takes_further_points(self):
        self.go("--scene", "any", "--substeps", "2", "--repeats", 1)
        self.go("--scene", "any", "--substeps", "2,4", "--repeats", 1, "--resume")
        self.assertEqual(self.log(), ["2", "4"])
        self.go("--scene", "any", "--substeps", "4", "--repeats", 2)
        self.assertEqual(self.log(), ["2", "4", "4"])
        self.assertEqual(len(self.rows()), 2)
        self.go("--scene", "any", "--substeps", "4", "--repeats", 1, "--fresh")
        self.assertEqual(len(self.rows()), 1)

    def stopped_by(self, number):
        words = ["--scene", "any", "--substeps", "2,4", "--repeats", 2, "--set", "sleep=0.3"]
        child = subprocess.Popen(self.words(*words), stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 30
        while len(self.log()) < 3 and time.monotonic() < deadline:
            time.sleep(0.02)
        child.send_signal(number)
        _, errors = child.communicate(timeout=30)
        begun = len(self.log())
        self.go(*words)
        self.assertEqual([row["repeats"] for row in self.rows()], ["2", "2"])
        self.assertLessEqual(len(self.log()) - begun, 2, "finished runs are not run again")
        return child.returncode, errors

    def test_stopped_by_the_user_keeps_finished_points(self):
        code, errors = self.stopped_by(signal.SIGINT)
        self.assertEqual(code, 130)
        self.assertIn("goes on", errors)

    def test_killed_keeps_finished_points(self):
        self.stopped_by(signal.SIGKILL)

    def test_half_a_line_is_no_run(self):
        self.go("--scene", "any", "--substeps", "2", "--repeats", 1)
        with (self.out / "runs.jsonl").open("a") as file:
            file.write('{"point": {"solver.sub')
        self.go("--scene", "any", "--substeps", "2,4", "--repeats", 1)
        self.assertEqual([row["solver.substeps"] for row in self.rows()], ["2", "4"])
        self.go("--scene", "any", "--substeps", "2,4", "--repeats", 1)
        self.assertEqual(self.log(), ["2", "4"])

    def test_another_build_is_measured_anew_and_not_mixed(self):
        self.go("--scene", "any", "--substeps", "2", "--repeats", 1)
        self.stub.write_text(STUB + "\n# another build\n")
        done = self.go("--scene", "any", "--substeps", "4", "--repeats", 1)
        self.assertIn("another build", done.stderr)
        self.assertEqual([row["solver.substeps"] for row in self.rows()], ["4"])

    def test_unstable_and_refused_points_stay_in_the_table(self):
        self.go("--scene", "any", "--substeps", "0,1,2", "--repeats", 2)
        rows = {row["solver.substeps"]: row for row in self.rows()}
        self.assertEqual([rows[k]["status"] for k in "012"], ["refused", "unstable", "ok"])
        self.assertIn("flew apart", rows["1"]["message"])
        self.assertIn("outside [1, 1000]", rows["0"]["message"])
        self.assertEqual([rows[k]["on_front"] for k in "012"], ["0", "0", "1"])
        self.assertEqual(self.log().count("1"), 1, "what failed once is not repeated")

    def test_no_stable_point_has_its_own_exit_code(self):
        self.go("--scene", "any", "--substeps", "1", "--repeats", 1, code=2)

    def test_a_run_that_takes_too_long_is_kept_as_such(self):
        self.go("--scene", "any", "--substeps", "2", "--set", "sleep=20", "--timeout", 0.5, code=2)
        self.assertEqual(self.rows()[0]["status"], "stopped")

    def test_bad_input_is_one_line_that_says_what(self):
        table = self.folder / "peers.csv"
        table.write_text("peer,method\na,b\n")
        bad_cell = self.folder / "bad.csv"
        bad_cell.write_text(PEERS.replace("609", "fast"))
        any_scene = ["--scene", "any"]
        cases = [
            ([], "--scene"),
            (["--scene", "none"], "no scene none"),
            ([*any_scene, "--repeats", "0"], "[1, 1000]"),
            ([*any_scene, "--repeats", "x"], "invalid int"),
            ([*any_scene, "--duration", "nan"], "--duration"),
            ([*any_scene, "--nonsense"], "--help"),
            ([*any_scene, "--grid", "solver.nonsense=1"], "no key solver.nonsense"),
            ([*any_scene, "--grid", "solver.substeps"], "key=v1"),
            ([*any_scene, "--substeps", "0"], "outside [1, 1000]"),
            ([*any_scene, "--set", "x"], "key=value"),
            ([*any_scene, "--no-run"], "--report"),
            ([*any_scene, "--fresh", "--resume"], "contradict"),
            ([*any_scene, "--peers", self.folder / "no.csv"], "cannot be read"),
            ([*any_scene, "--peers", table], "row 1 lacks setting"),
            ([*any_scene, "--peers", bad_cell], "fast must be a number above 0"),
            ([*any_scene, "--run-scene", self.folder / "no"], "is no program"),
            ([*any_scene, "--out", self.stub], "cannot be written"),
        ]
        for words, clue in cases:
            with self.subTest(words=words):
                self.assertIn(clue, self.refused(*words))

    def test_a_folder_holds_one_campaign(self):
        self.go("--scene", "any", "--repeats", 1)
        self.assertIn("holds results with scene = any", self.refused("--scene", "other"))

    def test_help_has_examples_and_exit_codes(self):
        text = self.go("--help").stdout
        for clue in ("Examples:", "Exit code", "--warm-start", "--report"):
            self.assertIn(clue, text)

    def test_peers_may_lack_a_largest_error(self):
        table = self.folder / "peers.csv"
        table.write_text("# a comment\n" + PEERS)
        rows = peers.read_peers(table)
        self.assertEqual(rows[0]["max_error_percent"], 5.0)
        self.assertIsNone(rows[1]["max_error_percent"])

    def finish_report(self):
        """Folders as --report leaves them: two settings in every study."""
        for study in studies.STUDIES:
            folder = self.out / study.name
            folder.mkdir(parents=True)
            (folder / "campaign.json").write_text(
                json.dumps(
                    {"scene": study.scene, "duration_s": study.duration_s, "set": list(study.fixed)}
                )
            )
            with (folder / "runs.jsonl").open("w") as file:
                for substeps in (4, 8):
                    report = {
                        "particles": 1000,
                        "simulated_time_s": 1,
                        "wall_time_s": 0.01 * substeps,
                        "error": {"density_mean": 0.04 / substeps, "density_max": 0.4 / substeps},
                        "settings": {},
                        "state_hash": "",
                        "rms_speed_m_s": 1,
                        "residual_speed_m_s": 1,
                        "max_speed_m_s": 1,
                    }
                    point = {"threads": "2", "solver.substeps": str(substeps)}
                    file.write(
                        json.dumps(
                            {
                                "point": point,
                                "status": "ok",
                                "message": "",
                                "seconds": 3,
                                "program": "p",
                                "commit": "c0ffee",
                                "date": "2026-01-02 03:04 UTC",
                                "report": report,
                            }
                        )
                        + "\n"
                    )

    def test_report_is_written_from_what_was_measured(self):
        self.finish_report()
        table = self.folder / "peers.csv"
        table.write_text(PEERS)
        done = self.go("--report", "--no-run", "--doc", self.folder / "doc", "--peers", table)
        self.assertIn("its runs took 0.7 min", done.stdout)
        text = (self.folder / "doc" / "error_vs_runtime.md").read_text()
        self.assertIn("For 30 fps with 20,000 particles take 4 substeps**", text)
        self.assertIn("`--set solver.substeps=4`", text)
        self.assertIn("| 1 | 4 substeps | 40 | 25,000 |", text)
        self.assertIn("| Other DFSPH tol 1 % | 609 |", text)
        self.assertIn("c0ffee", text)
        for name in (
            "dam_break_error",
            "dam_break_metrics",
            "column_error",
            "splash_error",
            "ice_error",
            "number_sizes",
            "depth_sizes",
        ):
            self.assertIn(f"images/error_vs_runtime_{name}.png", text)
            picture = self.folder / "doc" / "images" / f"error_vs_runtime_{name}.png"
            self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")

    def test_report_says_what_is_missing(self):
        self.assertIn("no finished runs", self.refused("--report", "--no-run"))

    def test_runs_the_real_program_with_a_reference(self):
        scene = self.folder / "tiny.yaml"
        scene.write_text(
            textwrap.dedent(
                """\
            fluid: {spacing_m: 0.05}
            blocks: [{min_m: [-0.1, -0.1, 0], max_m: [0.1, 0.1, 0.2]}]
            containers: [{name: tank, size_m: [0.4, 0.2, 0.4]}]
            """
            )
        )
        self.go(
            "--scene",
            scene,
            "--duration",
            0.1,
            "--substeps",
            "2,8",
            "--threads",
            1,
            "--repeats",
            1,
            "--trajectory",
            0.1,
            "--trajectory-substeps",
            16,
            "--run-scene",
            RUN_SCENE,
        )
        few, many = self.rows()
        self.assertEqual((few["particles"], few["threads"]), ("64", "1"))
        self.assertLess(float(many["density_mean"]), float(few["density_mean"]))
        self.assertLess(
            float(many["apart_spacings_at_0.10_s"]), float(few["apart_spacings_at_0.10_s"])
        )
        self.assertTrue((self.out / "reference.npy").exists())
        self.assertFalse((self.out / "record.npy").exists())


if __name__ == "__main__":
    unittest.main()
