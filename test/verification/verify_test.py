"""Contract of scripts/verify: exit codes, one line a bound, overrides that reach the solver."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

RUN_SCENE = sys.argv.pop()
VERIFY = sys.argv.pop()


class Verify(unittest.TestCase):
    def verify(self, *words):
        return subprocess.run([VERIFY, *words, "--run-scene", RUN_SCENE], capture_output=True, text=True, timeout=100)

    def test_bounds_that_hold_are_told_with_what_was_measured(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "figures.json"
            done = self.verify("--case", "spinning_disk", "--json", str(file))
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            figures = json.loads(file.read_text())["spinning_disk"]
        self.assertEqual(done.stderr, "", "no progress in a pipe")
        self.assertEqual(done.stdout.count("  pass  "), len(figures))
        self.assertIn(" <= 1e-06", done.stdout)
        for figure in figures:
            self.assertTrue(figure["passed"])
            self.assertLessEqual(figure["measured"], figure["bound"])

    def test_a_bound_that_does_not_hold_has_its_own_exit_code(self):
        done = self.verify("--case", "spinning_disk", "--set", "solver.viscosity_1_s=30")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("  FAIL  ", done.stdout)
        self.assertIn(" do not", done.stdout)

    def test_bad_input_is_said_in_a_line(self):
        for words, clue in ((["--case", "free_fal"], "free_fall"),
                            (["--case", "free_fall", "--set", "solver.substep=4"], "solver.substeps"),
                            (["--case", "free_fall", "--preset", "fast"], "default, paper")):
            done = self.verify(*words)
            self.assertEqual(done.returncode, 1, words)
            self.assertIn(clue, done.stderr)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def test_a_program_that_is_not_there(self):
        done = subprocess.run([VERIFY, "--run-scene", "/no/run_scene"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        refusal = "--run-scene /no/run_scene is no program; build it with scripts/build"
        self.assertEqual(done.stderr.strip(), f"scripts/verify: {refusal}")

    def test_list_and_help(self):
        self.assertIn("hydrostatic_column_minute", self.verify("--list").stdout)
        self.assertNotIn("hydrostatic_column_minute", self.verify("--list", "--fast").stdout)
        help_text = self.verify("--help").stdout
        self.assertIn("Examples:", help_text)
        self.assertIn("Exit code", help_text)


if __name__ == "__main__":
    unittest.main()
