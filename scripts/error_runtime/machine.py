"""On what, of what and when a number was measured."""

import datetime
import hashlib
import os
import pathlib
import platform
import subprocess

from .refusal import Refusal

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def processor():
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine() or "unknown processor"


def commit():
    """Of the sources; "unknown" outside of a repository and where there is no git."""
    words = ["git", "-C", str(ROOT), "describe", "--always", "--dirty", "--exclude=*"]
    try:
        run = subprocess.run(words, capture_output=True, text=True)
    except FileNotFoundError:
        return "unknown"
    return run.stdout.strip() or "unknown"


def now():
    return datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC")


def find_run_scene(given=None):
    """Path of the program: the given one, or the newest in the build folders."""
    if given is not None:
        path = pathlib.Path(given)
        if not (path.is_file() and os.access(path, os.X_OK)):
            raise Refusal(f"--run-scene {given} is no program; build it with scripts/build")
        return path.resolve()
    built = [p for p in ROOT.glob("build*/**/run_scene") if p.is_file() and os.access(p, os.X_OK)]
    if not built:
        raise Refusal(
            "no run_scene found in the build folders; run scripts/build, or name one with --run-scene"
        )
    return max(built, key=lambda p: p.stat().st_mtime)


def fingerprint(program):
    """Twelve digits that change with the program, so that no table mixes two builds."""
    return hashlib.sha256(pathlib.Path(program).read_bytes()).hexdigest()[:12]


def about(program, command):
    return {
        "command": command,
        "commit": commit(),
        "processor": processor(),
        "cores": os.cpu_count(),
        "date": now(),
        "program": fingerprint(program),
    }
