"""Runs of run_scene, each kept in a folder of its own, so that a suite that was stopped goes on
where it was.

runs/<key>/outcome.json  status, message, seconds and the words of the command; written last, so
half a run is no run runs/<key>/report.json   what run_scene measured; series.csv and particles.csv
where they were asked for

The key changes with the program, the words and the text of the scene.
"""

import dataclasses
import hashlib
import json
import pathlib
import threading
import time

from iib.common import run_scene
from iib.common.files import write_atomically
from iib.common.machine import fingerprint
from iib.common.paths import ROOT, SCENES
from iib.common.recording import columns

OWN_SCENES = SCENES / "stability"
MOST_MEMORY_BYTES = 8 << 30  # so that no case takes the machine with it


@dataclasses.dataclass(frozen=True)
class Asked:
    """What to run; scene: of config/scenes/stability, or what run_scene takes."""

    scene: str
    sets: tuple = ()
    duration_s: float = None
    precision: str = "float"
    threads: int = 1
    preset: str = None
    series: bool = False
    sample_hz: float = None

    def words(self):
        own = OWN_SCENES / f"{self.scene}.yaml"
        return run_scene.words(
            own if own.exists() else self.scene,
            self.sets,
            threads=self.threads,
            precision=self.precision,
            duration=self.duration_s,
            preset=self.preset,
            sample_hz=self.sample_hz,
        )

    def text(self):
        """Of the scene, where it is a file."""
        path = pathlib.Path(self.words()[0])
        return path.read_text() if path.suffix == ".yaml" and path.exists() else ""


@dataclasses.dataclass
class Outcome:
    """What became of a run. status: of run_scene.finish."""

    asked: Asked
    status: str
    message: str
    seconds: float
    folder: pathlib.Path
    report: dict

    def series(self):
        """Columns over time, the start first."""
        return columns(self.folder / "series.csv")

    def metric(self, name):
        return self.report.get("error", {}).get(name, float("nan"))

    def finite(self):
        return bool(self.report) and self.report["non_finite"] == 0

    def contained(self):
        return bool(self.report) and self.report["escaped"] == 0

    def survived(self):
        return self.status in ("ok", "unstable") and self.finite() and self.contained()

    def reproduce(self):
        words = [
            f'"{word}"' if any(c in word for c in " []{}") else word for word in self.asked.words()
        ]
        return "run_scene " + " ".join(words).replace(str(ROOT) + "/", "")


class Runner:
    """program: path of run_scene; out: folder of the suite. For several threads."""

    def __init__(self, program, out, timeout_s=120.0):
        self.program, self.timeout_s = str(program), timeout_s
        self.folder = pathlib.Path(out) / "runs"
        self.mark = fingerprint(program)
        self.log, self.lock = [], threading.Lock()

    def __call__(self, scene, *sets, **options):
        return self.run(Asked(scene, tuple(sets), **options))

    def run(self, asked):
        key = hashlib.sha256(
            "\0".join([self.mark, *asked.words(), asked.text(), str(asked.series)]).encode()
        )
        folder = self.folder / key.hexdigest()[:20]
        if not (folder / "outcome.json").exists():
            self._make(asked, folder)
        kept = json.loads((folder / "outcome.json").read_text())
        path = folder / "report.json"
        report = json.loads(path.read_text()) if path.exists() and path.stat().st_size > 0 else {}
        outcome = Outcome(asked, kept["status"], kept["message"], kept["seconds"], folder, report)
        with self.lock:
            self.log.append(outcome)
        return outcome

    def _make(self, asked, folder):
        folder.mkdir(parents=True, exist_ok=True)
        command = [
            "prlimit",
            f"--as={MOST_MEMORY_BYTES}",
            self.program,
            *asked.words(),
            "--report",
            str(folder / "report.json"),
        ]
        if asked.series:
            command += [
                "--series",
                str(folder / "series.csv"),
                "--record",
                str(folder / "positions.npy"),
            ]
        start = time.monotonic()
        status, message = run_scene.finish(command, self.timeout_s)
        if status == "refused":
            (folder / "report.json").unlink(missing_ok=True)
        kept = {"status": status, "message": message, "seconds": round(time.monotonic() - start, 3)}
        write_atomically(
            folder / "outcome.json", json.dumps({**kept, "command": asked.words()}, indent=1) + "\n"
        )
