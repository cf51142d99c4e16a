"""A million steps of a pool and of an iceberg at rest: does anything drift, grow or slow down?"""

import dataclasses

import numpy as np
from iib.common.checks import at_most, reported

from iib.stability.runs import Asked

SETTLED = 0.05  # share of the run that is left to come to rest
LOOKS = 1000  # samples over the run
SUBSTEPS, FRAME_RATE_HZ = 6, 60.0
SPACING_M = 0.05


@dataclasses.dataclass
class Long:
    """ice_after: particles of this and later ids began as ice."""

    name: str
    scene: str
    title: str
    sets: tuple = ()
    ice: bool = False


LONG = [
    Long("pool", "pool", "A pool at rest"),
    Long("iceberg", "iceberg", "An iceberg at rest", ice=True),
]


def asked(one, steps):
    seconds = steps / (SUBSTEPS * FRAME_RATE_HZ)
    return Asked(
        one.scene,
        (f"solver.substeps={SUBSTEPS}", *one.sets),
        duration_s=seconds,
        series=True,
        sample_hz=LOOKS / seconds,
    )


def tenths(values):
    """Means over the first tenth after it settled, and over the last."""
    begin = int(SETTLED * len(values))
    tenth = max(1, (len(values) - begin) // 10)
    return values[begin : begin + tenth].mean(), values[-tenth:].mean()


def turned_degrees(positions):
    """Rotation of a rigid cloud against the first sample after it settled, by sample."""
    first = positions[int(SETTLED * len(positions))].astype(float)
    first = first - first.mean(axis=0)
    angles = []
    for frame in positions.astype(float):
        u, _, v = np.linalg.svd((frame - frame.mean(axis=0)).T @ first)
        turn = u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v
        angles.append(np.degrees(np.arccos(np.clip((np.trace(turn) - 1) / 2, -1, 1))))
    return np.array(angles)


def curves(one, outcome):
    """Name to values over time, with unit."""
    series = outcome.series()
    over_time = {
        "resident memory, MiB": series["resident_bytes"] / 2**20,
        "time per frame, ms": 1e3 * series["wall_s"],
        "height of the centre of mass, mm": 1e3 * series["mean_z_m"],
        "highest particle, mm": 1e3 * series["max_z_m"],
        "rms speed, mm/s": 1e3 * series["rms_speed_m_s"],
        "mean density error, %": 100 * series["density_error_mean"],
    }
    if one.ice:
        ice = np.load(outcome.folder / "positions.npy")[:, -int(series["ice_particles"][0]) :]
        over_time["height of the ice, mm"] = 1e3 * ice[:, :, 2].mean(axis=1)
        over_time["rotation of the ice, degrees"] = turned_degrees(ice)
    return series["time_s"], over_time


def checks(over_time):
    """Bounds on the last tenth against the first."""
    change = {name: tenths(values) for name, values in over_time.items()}

    def drift(name):
        return abs(change[name][1] - change[name][0])

    memory, cost = change["resident memory, MiB"], change["time per frame, ms"]
    found = [
        at_most("memory grown", memory[1] - memory[0], 1.0, "MiB"),
        at_most("time per frame, last tenth over first", cost[1] / cost[0], 1.2),
        at_most(
            "centre of mass moved",
            drift("height of the centre of mass, mm"),
            0.01 * 1e3 * SPACING_M,
            "mm",
        ),
        at_most(
            "highest particle moved", drift("highest particle, mm"), 0.1 * 1e3 * SPACING_M, "mm"
        ),
        at_most("rms speed at the end", change["rms speed, mm/s"][1], 20.0, "mm/s"),
    ]
    if "height of the ice, mm" in change:
        found += [
            at_most(
                "ice risen or sunk", drift("height of the ice, mm"), 0.05 * 1e3 * SPACING_M, "mm"
            ),
            reported("ice turned", change["rotation of the ice, degrees"][1], "degrees"),
        ]
    return found


@dataclasses.dataclass
class LongMeasured:
    name: str
    title: str
    steps: int
    simulated_s: float
    wall_s: float
    command: str
    lived: bool
    rows: list  # what, first tenth, last tenth
    checks: list

    def passed(self):
        return self.lived and all(check.passed() for check in self.checks)


def measure(one, steps, runner):
    outcome = runner.run(asked(one, steps))
    report = outcome.report
    if not outcome.survived():
        return LongMeasured(
            one.name,
            one.title,
            report.get("steps", 0),
            report.get("simulated_time_s", 0.0),
            outcome.seconds,
            outcome.reproduce(),
            False,
            [],
            [],
        )
    _, over_time = curves(one, outcome)
    rows = [(name, *map(float, tenths(values))) for name, values in over_time.items()]
    return LongMeasured(
        one.name,
        one.title,
        report["steps"],
        report["simulated_time_s"],
        report["wall_time_s"],
        outcome.reproduce(),
        True,
        rows,
        checks(over_time),
    )
