"""Shipped scenes at few and many substeps: the energy that rises without work."""

import dataclasses

import numpy as np

from iib.stability.runs import Asked

SCENES = ("dam_break", "container_splash", "sphere_splash", "freeze_on_sphere", "sheet")
SUBSTEPS = (2, 8, 24)
DURATION_S = 2.0


@dataclasses.dataclass
class Balance:
    """Rises relative to what the fall sets free.

    mechanical: of kinetic and potential energy alone; lived: finite, inside.
    """

    scene: str
    substeps: int
    mechanical: float
    total: float
    fastest_m_s: float
    lived: bool
    command: str


def rise(energy_j):
    """The furthest above its own running minimum."""
    return float(np.max(energy_j - np.minimum.accumulate(energy_j)))


def measure(runner, pool, bar):
    def balance(place):
        scene, substeps = place
        asked = Asked(scene, (f"solver.substeps={substeps}",), duration_s=DURATION_S, series=True)
        outcome = runner.run(asked)
        bar.end("energy", outcome.seconds)
        series = outcome.series()
        mechanical_j, total_j = (
            series["kinetic_energy_j"] + series["potential_energy_j"],
            series["total_energy_j"],
        )
        scale_j = mechanical_j[0] - series["potential_energy_j"].min()
        return Balance(
            scene,
            substeps,
            rise(mechanical_j) / scale_j,
            rise(total_j) / scale_j,
            outcome.report["fastest_m_s"],
            outcome.survived(),
            outcome.reproduce(),
        )

    return list(pool.map(balance, [(scene, n) for scene in SCENES for n in SUBSTEPS]))
