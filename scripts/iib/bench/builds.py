"""Copies of the source at some commit, built alike in a folder of their own."""

import os
import pathlib
import shutil
import subprocess
import sys

from iib.common.paths import ROOT
from iib.common.processes import run


def git(*arguments):
    return run(["git", "-C", ROOT, *arguments]).strip()


class Tree:
    """A source tree and its build. `source` None: the working tree itself, copied."""

    def __init__(self, name, folder):
        self.name = name
        self.source = pathlib.Path(folder) / name / "source"
        self.build = pathlib.Path(folder) / name / "build"

    def check_out(self, commit):
        """The source as of a commit."""
        self._empty()
        archive = subprocess.Popen(
            ["git", "-C", str(ROOT), "archive", commit], stdout=subprocess.PIPE
        )
        run(["tar", "-x", "-C", self.source], stdin=archive.stdout)
        return self

    def copy_working_tree(self):
        """The source as it lies in the working tree, committed or not."""
        self._empty()
        for name in git("ls-files", "-co", "--exclude-standard").splitlines():
            if (ROOT / name).is_file():
                (self.source / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(ROOT / name, self.source / name)
        return self

    def _empty(self):
        shutil.rmtree(self.source, ignore_errors=True)
        self.source.mkdir(parents=True)

    def make(self, *targets, ros=False):
        """Builds what of `targets` this tree knows."""
        print(f"building {self.name}", file=sys.stderr)
        benches = (self.source / "bench" / "CMakeLists.txt").exists()
        command = ["cmake", "-S", self.source, "-B", self.build]
        command += [
            f"-DIIB_ROS={'ON' if ros else 'OFF'}",
            f"-DIIB_BENCH={'ON' if benches else 'OFF'}",
        ]
        command += ["-DBUILD_TESTING=OFF", "-DCATKIN_ENABLE_TESTING=OFF"]
        command += ["-DPYTHON_EXECUTABLE=/usr/bin/python3"] if ros else []
        if shutil.which("ninja") and not (self.build / "CMakeCache.txt").exists():
            command += ["-G", "Ninja"]
        if shutil.which("ccache"):
            command += ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]
        run(command)
        wanted = [t for t in targets if benches or t not in ("microbench", "time_node")]
        run(["cmake", "--build", self.build, "--parallel", os.cpu_count(), "--target", *wanted])
        return self

    def program(self, name):
        """Path of a built program; None if this tree has none of that name."""
        found = [p for p in self.build.rglob(name) if p.is_file() and os.access(p, os.X_OK)]
        return found[0] if found else None
