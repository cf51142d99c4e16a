"""Runs every command and program of one document as pasted, in a fresh home.

Usage: commands_test.py BUILD DOCUMENT. It does not run the commands that not_run.py lists, nor
those with a word in capitals, which the reader replaces; listing_test.py checks their options.
"""

import pathlib
import re
import sys
import time
import unittest
from fnmatch import fnmatch

from desk import PRELUDE, Desk, Failed
from documents import ROOT, steps_of
from not_run import EXIT_CODES, reason

BUILD, DOCUMENT = pathlib.Path(sys.argv.pop(1)).resolve(), ROOT / sys.argv.pop(1)
HEADLESS = "roslaunch ice_ice_baby headless.launch"
NEEDS_NODE = re.compile(r"(rosservice|rostopic|rosparam|rosnode) ")


def prelude_of_readme():
    """What a reader has done before opening another document."""
    return [s.text for s in steps_of(ROOT / "README.md") if PRELUDE.match(s.text)]


def expected_code(text):
    return next((code for pattern, code in EXIT_CODES.items() if fnmatch(text, pattern)), 0)


class Reader:
    """Pastes the steps one after the other."""

    def __init__(self, document, desk):
        self._desk, self._section, self._launch = desk, None, HEADLESS

    def take(self, step):
        if step.section != self._section:
            self._section, self._launch = step.section, HEADLESS
        if step.kind == "yaml":
            self.keep_scene(step.text)
        elif step.kind == "command":
            self.paste(step)
        else:
            self._desk.serve(self._launch)
            getattr(self._desk, "run_" + step.kind)(step.text)

    def keep_scene(self, text):
        """A scene file of the document is there for the commands behind it."""
        name = re.search(r"^name: (\w+)$", text, re.MULTILINE)
        if name:
            self._desk.write(name[1] + ".yaml", text)

    def paste(self, step):
        if step.text.startswith("roslaunch ") and "replay.launch" not in step.text:
            self._launch = step.text
        elif NEEDS_NODE.match(step.text):
            self._desk.serve(f"{HEADLESS} scene:={step.scene}" if step.scene else self._launch)
        self._desk.run(step.text, expected_code(step.text))


class Commands(unittest.TestCase):
    def test_each_runs_as_pasted(self):
        steps = [s for s in steps_of(DOCUMENT) if s.kind != "command" or self.is_run(s)]
        own_prelude = any(PRELUDE.match(s.text) for s in steps)
        desk = Desk(BUILD, [] if own_prelude else prelude_of_readme())
        reader = Reader(DOCUMENT, desk)
        for step in steps:
            begin = time.monotonic()
            with self.subTest(step.text.splitlines()[0]):
                try:
                    reader.take(step)
                except Failed as failed:
                    raise self.failureException(f"{step.place()}: {failed}") from None
            took_s, title = time.monotonic() - begin, step.text.splitlines()[0][:90]
            print(f"{took_s:5.1f} s  {step.place()}  {title}", flush=True)
        with self.subTest("the last launch ends"):
            desk.close()

    @staticmethod
    def is_run(step):
        return not (step.is_mention() or step.is_template() or reason(step.text))


if __name__ == "__main__":
    unittest.main()
