"""Contract of scripts/stability: exit codes, what it keeps, and how it judges and reads ranges."""
import contextlib
import json
import pathlib
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.common.paths import ROOT
from iib.stability import cases, document, energy, long_runs, maps, pictures, results, verdict
from iib.stability import cases_ice, cases_starts, cases_water  # noqa: F401  (fill CASES)
from iib.stability.map_list import MAPS, step_sets
from iib.stability.ranges import parse

RUN_SCENE = sys.argv.pop()


def outcome(status="ok", **report):
    told = {
        "particles": 100,
        "steps": 10,
        "non_finite": 0,
        "escaped": 0,
        "speed_limited": 0,
        "correction_limited": 0,
        "density_error_mean": 0.001,
        "error": {},
        **report,
    }
    finite, inside = told["non_finite"] == 0, told["escaped"] == 0
    lived = status in ("ok", "unstable") and finite and inside
    return types.SimpleNamespace(
        status=status,
        message="",
        report=told,
        survived=lambda: lived,
        metric=lambda name: told["error"].get(name, float("nan")),
    )


class Verdict(unittest.TestCase):
    def test_four_words(self):
        self.assertEqual(verdict.verdict(outcome()), "stable")
        self.assertEqual(verdict.verdict(outcome("refused")), "refused")
        for worse in (
            {"speed_limited": 1},
            {"density_error_mean": 0.5},
            {"error": {"energy_rise": 0.02}},
            {"correction_limited": 11},
        ):
            self.assertEqual(verdict.verdict(outcome(**worse)), "degraded", worse)
        for lost in ({"non_finite": 1}, {"escaped": 1}):
            self.assertEqual(verdict.verdict(outcome("unstable", **lost)), "unstable", lost)
        for end in ("crashed", "stopped"):
            self.assertEqual(verdict.verdict(outcome(end)), "unstable")

    def test_a_few_corrections_may_be_cut(self):
        self.assertEqual(verdict.verdict(outcome(correction_limited=10)), "stable")

    def test_what_steam_lifts_is_not_judged(self):
        lifted = {"error": {"energy_rise": 2.0}}
        self.assertEqual(verdict.verdict(outcome(max_steam=5, **lifted)), "stable")

    def test_a_limit_that_run_scene_calls_unstable_is_degraded(self):
        self.assertEqual(verdict.verdict(outcome("unstable", speed_limited=900)), "degraded")


class Ranges(unittest.TestCase):
    def test_of_every_kind_of_key(self):
        found = parse((ROOT / "config" / "default.yaml").read_text())
        self.assertEqual((found["duration_s"].low, found["duration_s"].high), (0, 1e6))
        self.assertEqual(
            (found["solver.warm_start"].low, found["solver.warm_start"].high), (0, 0.5)
        )
        self.assertTrue(found["gravity_m_s2"].vector)
        self.assertTrue(found["blocks.velocity_gradient_1_s"].matrix)
        self.assertEqual(found["containers.wall_m"].high, 10)
        self.assertNotIn("thermal.enabled", found)

    def test_every_range_of_the_manual_is_read(self):
        text = (ROOT / "config" / "default.yaml").read_text()
        self.assertEqual(len(parse(text)), text.count("{["))


class Maps(unittest.TestCase):
    def test_at_least_six_decades_of_three_points(self):
        self.assertGreaterEqual(len(MAPS), 10)
        for one in MAPS.values():
            self.assertGreaterEqual(one.values[-1] / one.values[0], 0.999e6, one.name)
            for low, high in zip(one.values, one.values[1:]):
                self.assertLess(high / low, 2.2, one.name)

    def test_points_stand_on_both_sides_of_an_end(self):
        found = parse((ROOT / "config" / "default.yaml").read_text())
        row = MAPS["viscosity"].rows[0]
        points = row.points([1.0], found)
        self.assertEqual(sum(abs(point / 1e4 - 1) < 1e-5 for point in points), 2)
        self.assertEqual(len({point <= 1e4 for point in points}), 2)

    def test_a_step_is_what_was_asked_for(self):
        for step in (1e-7, 3.3e-5, 1e-4, 0.1, 1.0):
            rate, substeps = (float(text.split("=")[1]) for text in step_sets(step))
            self.assertAlmostEqual(rate * substeps * step, 1.0, 6)
            self.assertLessEqual(max(rate / 1e4, substeps / 1e3), 1 + 1e-9)

    def test_cells_meet_half_way_and_at_the_ends_of_a_range(self):
        borders = pictures.cells([1.0, 100.0, 1e4 * (1 - 1e-6), 1e4 * (1 + 1e-6), 1e6])
        self.assertEqual([high for _, high in borders][:-1], [low for low, _ in borders][1:])
        for (_, high), expected in zip(borders, (10, 1e3, 1e4, 1e5, 1e7)):
            self.assertAlmostEqual(high / expected, 1, 5)

    def test_the_default_of_a_key_is_known(self):
        found = parse((ROOT / "config" / "default.yaml").read_text())
        usual = {
            name: MAPS[name].rows[0].usual(found)
            for name in ("gravity", "viscosity", "density", "impact")
        }
        self.assertEqual(usual, {"gravity": 9.81, "viscosity": 30, "density": 1000, "impact": None})

    def test_decades(self):
        self.assertEqual(maps.decades(0.1, 10), [0.1, 0.215, 0.464, 1.0, 2.15, 4.64, 10.0])


class LongRuns(unittest.TestCase):
    def test_growth_is_seen(self):
        import numpy as np

        still = {
            name: np.ones(1000)
            for name in (
                "time per frame, ms",
                "height of the centre of mass, mm",
                "highest particle, mm",
                "rms speed, mm/s",
            )
        }
        flat = long_runs.checks({**still, "resident memory, MiB": np.full(1000, 50.0)})
        grown = long_runs.checks({**still, "resident memory, MiB": np.linspace(50, 60, 1000)})
        self.assertTrue(all(check.passed() for check in flat))
        self.assertEqual([check.what for check in grown if not check.passed()], ["memory grown"])


class Energy(unittest.TestCase):
    def test_rise_is_above_the_running_minimum(self):
        import numpy as np

        self.assertEqual(energy.rise(np.array([5.0, 3, 4, 1, 3, 2])), 2.0)

    def test_a_case_has_to_keep_its_bound_or_tell_why_not(self):
        one = cases.Case("", 0, "", "", None, cases.MOST_RISE, "")
        told = cases.Case("", 0, "", "", None, None, "steam is lifted")
        self.assertTrue(cases.rise_checks(one, 5e-4)[0].passed())
        self.assertFalse(cases.rise_checks(one, 2e-3)[0].passed())
        self.assertTrue(cases.rise_checks(told, 9.0)[0].passed())
        for known in cases.CASES.values():
            self.assertEqual(known.rise == cases.MOST_RISE, not known.because, known.name)


class Document(unittest.TestCase):
    def test_of_a_part_that_several_folders_hold_the_last_one_counts(self):
        with tempfile.TemporaryDirectory() as name:
            here = pathlib.Path(name)
            page = here / "page.md"
            page.write_text("head\n<!-- energy -->\n<!-- end of energy -->\ntail\n")
            for folder, total in (("first", 0.5), ("last", 0.25)):
                (here / folder).mkdir()
                line = {"scene": "sheet", "substeps": 2, "total": total, "mechanical": 1.0}
                results.Results(here / folder, {"commit": folder, "processor": "", "date": ""}).put(
                    "energy", {"sheet 2": line}
                )
            with unittest.mock.patch.object(document, "DOCUMENT", page), contextlib.redirect_stdout(
                None
            ):
                document.write([here / "first", here / "last"])
            self.assertIn("commit last", page.read_text())
            self.assertIn("| sheet | 25 % | 100 % |", page.read_text())
            self.assertTrue(page.read_text().endswith("<!-- end of energy -->\ntail\n"))


class Program(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = pathlib.Path(folder.name)

    def stability(self, *words):
        return subprocess.run(
            [ROOT / "scripts" / "stability", "--run-scene", RUN_SCENE, "--out", self.out, *words],
            capture_output=True,
            text=True,
            timeout=100,
        )

    def test_a_case_is_told_kept_and_not_run_again(self):
        done = self.stability("--case", "one_particle")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("pass  fastest: 0 <= 0 m/s", done.stdout)
        line = json.loads((self.out / "stability.json").read_text())["cases"]["lines"][
            "one_particle"
        ]
        self.assertEqual((line["number"], line["particles"], line["escaped"]), (14, 1, 0))
        kept = {path: path.stat().st_mtime_ns for path in self.out.glob("runs/*/outcome.json")}
        self.assertEqual(len(kept), 2)
        self.stability("--case", "one_particle")
        self.assertEqual(
            kept, {path: path.stat().st_mtime_ns for path in self.out.glob("runs/*/outcome.json")}
        )

    def test_bad_input_is_said_in_a_line(self):
        for words, clue in (
            (["--case", "one_partikle"], "one_particle"),
            (["--map", "steps"], "step, gravity"),
            (["--write", self.out], "stability.json"),
        ):
            done = self.stability(*words)
            self.assertEqual(done.returncode, 1, words)
            self.assertIn(clue, done.stderr)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def test_options_that_do_not_exist_are_bad_input(self):
        for words in (["--nonsense"], ["--jobs", "0"], ["--steps", "many"]):
            self.assertEqual(self.stability(*words).returncode, 1, words)

    def test_list_and_help(self):
        self.assertIn("gap_below_a_particle", self.stability("--list").stdout)
        self.assertIn("Exit code", self.stability("--help").stdout)


if __name__ == "__main__":
    unittest.main()
