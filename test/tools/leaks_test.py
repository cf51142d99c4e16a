"""scripts/leaks: nothing leaks in coarse water; what leaks is reported.

Usage: leaks_test.py LEAK_TRIAL
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import textwrap
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.common.paths import ROOT
from iib.leaks import trials

PROGRAM = sys.argv.pop(1)

# Stands in for leak_trial: a cup that is shaken leaks.
STUB = textwrap.dedent(
    """\
    #!/usr/bin/python3
    import json, sys
    words = sys.argv[1:]
    if "--list" in words:
        print(json.dumps({"vessels": ["cup", "bottle"], "motions": ["spun", "shaken"]}))
        sys.exit(0)
    vessel = words[words.index("--vessel") + 1]
    for motion in words[words.index("--motion") + 1 :]:
        leaks = 3 if (vessel, motion) == ("cup", "shaken") else 0
        print(json.dumps({
            "vessel": vessel, "motion": motion, "seconds": 0.6, "particle_seconds": 100.0,
            "through_wall": leaks, "escaped_over_rim": 5, "nan": 0}))
    """
)


class Leaks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.stub = self.folder / "leak_trial"
        self.stub.write_text(STUB)
        os.chmod(self.stub, 0o755)

    def go(self, *words, program=None, code=0):
        command = [ROOT / "scripts" / "leaks", "--leak-trial", program or self.stub, *words]
        command = [str(word) for word in command]
        done = subprocess.run(command, text=True, capture_output=True, timeout=850)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def test_nothing_leaks_in_coarse_water(self):
        picture = self.folder / "leaks.png"
        done = self.go("--quick", "--picture", picture, program=PROGRAM)
        self.assertEqual(done.stderr, "", "no progress bar in a pipe")
        self.assertIn(" 0 through a wall, 0 NaN", done.stdout)
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_a_leak_has_its_command_and_its_exit_code(self):
        text = self.go("--quick", "--vessel", "cup", code=1).stdout
        self.assertIn("shaken: 3 through a wall, 0 NaN: leak_trial --vessel cup", text)
        self.assertIn("--motion spun shaken", text)
        self.assertIn("| cup | shaken | 100 | 3 | 5 | 0 |", text)
        self.go("--quick", "--motion", "spun")

    def test_six_rounds_have_every_combination(self):
        words = [["cup", "bottle"], ["shaken", "spun"], trials.SPACINGS_M, 1.0]
        found = [trial for number in range(6) for trial in trials.of_round(*words, number)]
        kinds = {(t.vessel, t.spacing_m, t.quality, t.in_box) for t in found}
        each = len(trials.SPACINGS_M) * len(trials.QUALITIES)
        self.assertEqual(len(kinds), (2 + 1) * each, "a cup with and without a box")

    def test_bad_input_is_one_line_that_says_what(self):
        cases = [
            (["--vessel", "sieve"], "no vessel sieve; there are: cup, bottle"),
            (["--motion", "rest"], "no motion rest"),
            (["--seconds", "nan"], "[0.01, 100000]"),
            (["--jobs", "0"], "1 or more"),
            (["--quick", "--long"], "contradict"),
            (["--picture", "/no/leaks.png"], "no folder"),
            (["--leak-trial", "/no/program"], "is no program"),
        ]
        for words, clue in cases:
            with self.subTest(words=words):
                errors = self.go(*words, code=1).stderr
                self.assertEqual(len(errors.strip().splitlines()), 1, errors)
                self.assertIn(clue, errors)

    def test_the_trial_refuses_bad_input(self):
        for words, clue in [
            (["--vessel", "sieve"], "no vessel sieve"),
            (["--motion", "rest"], "no motion rest"),
            (["--quality", "best"], "no quality best"),
        ]:
            done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 1)
            self.assertIn(clue, done.stderr)


if __name__ == "__main__":
    unittest.main()
