"""Programs, options and links of all documents, and the list of commands that are not run.

Usage: listing_test.py BUILD
"""

import functools
import pathlib
import re
import subprocess
import sys
import unittest
from fnmatch import fnmatch

from documents import DOCUMENTS, ROOT, anchors_of, links_of, steps_of
from not_run import EXIT_CODES, NOT_RUN

BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
COMMANDS = [step for path in DOCUMENTS for step in steps_of(path) if step.kind == "command"]
OWN = ("scripts/", ".ci/", "run_scene")


def own_program(name):
    if name == "run_scene":
        return BUILD / "devel" / "lib" / "ice_ice_baby" / "run_scene"
    return ROOT / name


@functools.lru_cache(maxsize=None)
def help_of(program):
    in_build = f'source "{BUILD}/devel/setup.bash" && exec "$0" --help'
    command = ["bash", "-c", in_build, program]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    return done.stdout + done.stderr if done.returncode == 0 else None


class Listing(unittest.TestCase):
    def test_programs_exist(self):
        for step in COMMANDS:
            if step.program().startswith(OWN):
                with self.subTest(step.place()):
                    program = own_program(step.program())
                    self.assertTrue(program.exists(), f"{step.place()}: no {step.program()}")

    def test_options_are_accepted(self):
        for step in COMMANDS:
            program = own_program(step.program())
            if not step.program().startswith(OWN) or not step.options():
                continue
            with self.subTest(step.place()):
                known = help_of(program)
                self.assertIsNotNone(known, f"{step.place()}: {step.program()} --help fails")
                for option in step.options():
                    listed = re.search(re.escape(option) + r"(?![\w-])", known)
                    self.assertTrue(listed, f"{step.place()}: {step.text}: no {option} in --help")

    def test_what_is_not_run_is_in_a_document(self):
        commands = [step.text for step in COMMANDS if not step.is_mention()]
        for pattern in [*NOT_RUN, *EXIT_CODES]:
            used = any(fnmatch(text, pattern) for text in commands)
            self.assertTrue(used, f"not_run.py lists {pattern!r}, which is in no document")

    def test_links_lead_somewhere(self):
        for document in DOCUMENTS:
            for line, path, anchor in links_of(document):
                target = (document.parent / path).resolve() if path else document
                place = f"{document.name}:{line}: {path}#{anchor}"
                self.assertTrue(target.exists(), place)
                if anchor:
                    self.assertIn(anchor, anchors_of(target), place)


if __name__ == "__main__":
    unittest.main()
