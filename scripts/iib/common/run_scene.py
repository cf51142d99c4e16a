"""run_scene: where it is, its command line, how a run ended, its report."""

import json
import os
import pathlib
import re
import signal
import subprocess
import tempfile

from iib.common.paths import ROOT
from iib.common.refusal import Refusal

# What the exit codes mean.
STATUS = {0: "ok", 1: "refused", 2: "unstable"}


def find_built(name, given=None):
    """Path of a program of the build: the given one, or the newest in the build folders."""
    option = "--" + name.replace("_", "-")
    if given is not None:
        path = pathlib.Path(given)
        if not (path.is_file() and os.access(path, os.X_OK)):
            raise Refusal(f"{option} {given} is no program; build it with scripts/build")
        return path.resolve()
    built = [p for p in ROOT.glob(f"build*/**/{name}") if p.is_file() and os.access(p, os.X_OK)]
    if not built:
        raise Refusal(
            f"no {name} found in the build folders; run scripts/build, or name one with {option}"
        )
    return max(built, key=lambda p: p.stat().st_mtime)


def find_run_scene(given=None):
    return find_built("run_scene", given)


def words(scene, sets=(), **options):
    """The command line behind the program.

    options: sample_hz=20 becomes --sample-hz 20; what is None is left out. sets: of --set.
    """
    line = [scene]
    for name, value in options.items():
        if value is not None:
            line += ["--" + name.replace("_", "-"), value]
    for override in sets:
        line += ["--set", override]
    return [str(word) for word in line]


def finish(command, timeout_s=None):
    """Runs a command line to its end.

    Returns its status, one of STATUS or "crashed" or "stopped", and the message of what went wrong.
    """
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=timeout_s)
    except subprocess.TimeoutExpired:
        return "stopped", f"took longer than {timeout_s:g} s"
    if done.returncode < 0:
        return "crashed", f"ended by {signal.Signals(-done.returncode).name}"
    lines = done.stderr.strip().splitlines()
    message = re.sub("^run_scene: ", "", lines[-1]) if lines and done.returncode != 0 else ""
    return STATUS.get(done.returncode, "crashed"), message


def finish_well(program, scene, sets=(), accepted=("ok",), **options):
    """As finish, but a Refusal with the message of run_scene where the status is not accepted."""
    status, message = finish([str(program), *words(scene, sets, **options)])
    if status not in accepted:
        raise Refusal(message or f"run_scene {scene} ended as {status} and printed nothing")


def report_of(program, scene, sets=(), accepted=("ok",), **options):
    """The report of a run."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "report.json"
        finish_well(program, scene, sets, accepted, report=path, **options)
        return json.loads(path.read_text())
