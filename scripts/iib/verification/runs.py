"""The runs that a case asks for."""

import re

import numpy as np

from iib.common.paths import SCENES
from iib.common.recording import Recording, record


class Run(Recording):
    """A run and what follows from its scene file and overrides."""

    def __init__(self, recording, scene, sets):
        super().__init__(**vars(recording))
        self.spacing_m = setting(scene, sets, "fluid.spacing_m")
        self.density_kg_m3 = setting(scene, sets, "fluid.rest_density_kg_m3", 1000.0)
        self.frame_rate_hz = self.report["settings"]["solver"]["frame_rate_hz"]
        self.lattice_kg = self.report["particles"] * self.density_kg_m3 * self.spacing_m**3
        self.substeps = round(self.report["steps"] / self.report["frames"])
        fastest = np.argmax(self.series["kinetic_energy_j"])
        speed = self.series["rms_speed_m_s"][fastest]
        self.mass_kg = 2 * self.series["kinetic_energy_j"][fastest] / speed**2  # of all water


def setting(scene, sets, key, default=None):
    """A number of the scene file, or what --set has in its place."""
    for override in reversed(sets):
        if override.startswith(key + "="):
            return float(override.split("=", 1)[1])
    text = (SCENES / "verification" / f"{scene}.yaml").read_text()
    found = re.search(key.split(".")[-1] + r":\s*([-+.\deE]+)", text)
    return float(found[1]) if found else default


class Runner:
    """Runs scenes with the overrides of the command line beneath what a case asks for.

    options: threads, preset and quality, as of run_scene.words.
    """

    def __init__(self, program, sets, **options):
        self.program, self.sets, self.options = program, sets, options

    def __call__(self, scene, duration_s=None, precision="float", sets=(), positions=False):
        sets = [*self.sets, *sets]
        options = {**self.options, "precision": precision, "duration": duration_s}
        return Run(record(self.program, scene, sets, positions, **options), scene, sets)
