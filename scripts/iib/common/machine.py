"""Where, of what and when a number was measured."""

import datetime
import hashlib
import os
import pathlib
import platform
import subprocess

from iib.common.paths import ROOT


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


def fingerprint(program):
    """Twelve digits that change with the program and its library, so that no table mixes builds."""
    program = pathlib.Path(program).resolve()
    digest = hashlib.sha256(program.read_bytes())
    for library in sorted(program.parent.parent.glob("libice_ice_baby_core*")):
        digest.update(library.read_bytes())
    return digest.hexdigest()[:12]


def about(program, command):
    return {
        "command": command,
        "commit": commit(),
        "processor": processor(),
        "cores": os.cpu_count(),
        "date": now(),
        "program": fingerprint(program),
    }
