"""A run of run_scene with every file that it writes, read back."""

import csv
import dataclasses
import json
import pathlib
import tempfile

import numpy as np

from iib.common import run_scene


def columns(path):
    """Name to array of numbers, of a CSV file whose first row has the names."""
    with open(path, newline="") as file:
        names, *rows = csv.reader(file)
    return dict(zip(names, np.array(rows, dtype=float).T))


@dataclasses.dataclass
class Recording:
    """series: columns over time, the start first; particles: columns of the last frame, by id.

    positions: (samples, particles, 3) in m, None unless they were asked for.
    """

    report: dict
    series: dict
    particles: dict
    positions: np.ndarray = None


def record(program, scene, sets=(), positions=False, **options):
    """Runs a scene. options: as of run_scene.words."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        files = {"report": folder / "report.json", "series": folder / "series.csv"}
        files["particles"] = folder / "particles.csv"
        files["record"] = folder / "positions.npy" if positions else None
        run_scene.finish_well(program, scene, sets, **options, **files)
        return Recording(
            json.loads(files["report"].read_text()),
            columns(files["series"]),
            columns(files["particles"]),
            np.load(files["record"]) if positions else None,
        )
