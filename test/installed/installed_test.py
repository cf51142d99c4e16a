#!/usr/bin/python3
"""An installed tree that was moved: its programs run with an empty environment, others build on it.

Arguments: build folder, configured prefix, with ROS the devel space too.
"""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD, PREFIX = Path(sys.argv[1]), Path(sys.argv[2])
DEVEL = Path(sys.argv[3]) if len(sys.argv) > 3 else None
EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def run(*command, **environment):
    """Runs the command with that environment and no other; returns exit code and all output."""
    done = subprocess.run(
        [str(word) for word in command],
        env=environment,
        check=False,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    return done.returncode, done.stdout


def build(source, folder, search_path):
    """Configures and builds a project as people do; fails with what CMake says."""
    environment = {
        name: value
        for name, value in os.environ.items()
        if name not in ("CMAKE_PREFIX_PATH", "DESTDIR")
    }
    search_path = ";".join(
        [str(search_path)]
        + [
            p
            for p in os.environ.get("CMAKE_PREFIX_PATH", "").split(":")
            if p and not (DEVEL and Path(p) == DEVEL)
        ]
    )
    for command in (
        [
            "cmake",
            "-S",
            source,
            "-B",
            folder,
            "-DCMAKE_PREFIX_PATH=" + search_path,
            "-DPYTHON_EXECUTABLE=/usr/bin/python3",
            "-DCATKIN_ENABLE_TESTING=OFF",
        ],
        ["cmake", "--build", folder, "--parallel", "2"],
    ):
        code, output = run(*command, **environment)
        if code != 0:
            raise AssertionError(output)


def elf_files(prefix):
    for path in sorted(prefix.rglob("*")):
        if path.is_file() and not path.is_symlink() and path.open("rb").read(4) == b"\x7fELF":
            yield path


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = Path(scratch.name)
        # With DESTDIR, as catkin installs its setup files below the configured prefix alone.
        code, output = run(
            "cmake",
            "--install",
            BUILD,
            DESTDIR=str(cls.scratch / "staged"),
            PATH=os.environ["PATH"],
        )
        if code != 0:
            raise AssertionError(output)
        cls.prefix = cls.scratch / "moved"
        (cls.scratch / "staged" / PREFIX.relative_to("/")).rename(cls.prefix)
        cls.run_scene = next(cls.prefix.rglob("run_scene"))
        cls.scenes = cls.prefix / "share" / "ice_ice_baby" / "config" / "scenes"
        (cls.scenes / "only_here.yaml").write_text(
            "name: only_here\nblocks: [{min_m: [0, 0, 0], max_m: [0.1, 0.1, 0.1]}]\n"
        )

    def test_programs_run_with_the_scenes_beside_them(self):
        code, scenes = run(self.run_scene, "--list")
        self.assertEqual(code, 0, scenes)
        self.assertIn("only_here", scenes)
        self.assertIn("dam_break", scenes)
        code, output = run(self.run_scene, "only_here", "--duration", "0.05")
        self.assertEqual(code, 0, output)
        self.assertIn("only_here: ", output)

    def test_programs_and_libraries_find_their_libraries(self):
        files = list(elf_files(self.prefix))
        self.assertIn(self.run_scene, files)
        for path in files:
            _, libraries = run("/usr/bin/ldd", path)
            self.assertNotIn("not found", libraries, path)
            for found in re.findall(r"libice_ice_baby\S* => (\S+)", libraries):
                self.assertEqual(
                    Path(found).parent.resolve(),
                    (self.prefix / "lib").resolve(),
                    "%s loads %s" % (path, found),
                )

    def test_a_scene_folder_that_is_missing_or_empty_is_named(self):
        empty = self.scratch / "empty"
        empty.mkdir()
        for folder, why in ((self.scratch / "none", "is not a folder"), (empty, "holds no .yaml")):
            for arguments in (["--list"], ["dam_break"]):
                code, output = run(self.run_scene, *arguments, ICE_ICE_BABY_SCENES=str(folder))
                self.assertEqual(code, 1)
                for word in (str(folder), why, "ICE_ICE_BABY_SCENES"):
                    self.assertIn(word, output)

    def test_a_program_of_somebody_else_builds_and_runs(self):
        build(EXAMPLES / "freeze_a_cup", self.scratch / "cup", self.prefix)
        code, output = run(self.scratch / "cup" / "freeze_a_cup")
        self.assertEqual(code, 0, output)
        ice = [int(percent) for percent in re.findall(r"s: (\d+) % ice", output)]
        self.assertGreater(len(ice), 2, output)
        self.assertEqual(ice, sorted(ice))
        self.assertGreaterEqual(ice[-1], 80)

    @unittest.skipUnless(DEVEL, "needs catkin")
    def test_a_catkin_package_of_somebody_else_builds(self):
        for name, space in (("devel", DEVEL), ("installed", self.prefix)):
            with self.subTest(space=name):
                folder = self.scratch / ("catkin_" + name)
                build(EXAMPLES / "ice_ice_baby_examples", folder, space)
                program = folder / "devel" / "lib" / "ice_ice_baby_examples" / "freeze_when_calm"
                _, libraries = run("/usr/bin/ldd", program)
                self.assertIn("=> %s/lib/libice_ice_baby_core.so" % space, libraries)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
