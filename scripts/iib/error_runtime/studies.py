"""The campaigns of the report: which scene, which grid, and what it is there to show."""

import dataclasses

from iib.error_runtime.campaign import Campaign
from iib.error_runtime.grid import expand, identity
from iib.error_runtime.runner import Runner

THREADS = "2"

# The study whose scene other programs were measured on.
PEERS_STUDY = "dam_break"

QUALITIES = ["fast", "balanced", "accurate"]

# The same settings in every scene of water, so that one setting can be judged by all of them.
WATER = (
    {"solver.substeps": ["2", "3", "4", "6", "8", "12", "16", "24"]},
    {"solver.substeps": ["4", "6", "12", "24"], "solver.warm_start": ["0"]},
    {"solver.substeps": ["4", "8", "16"], "solver.iterations": ["1", "4"]},
)


@dataclasses.dataclass
class Study:
    """grids: axes per grid, all points joined; axes that the program lacks are left out."""

    name: str
    scene: str
    shows: str
    grids: tuple
    duration_s: float
    fixed: tuple = ()
    trajectory_s: float = 0.0
    water: bool = True
    picture: bool = True
    sizes: bool = False  # points differ in their number of particles

    @property
    def picture_name(self):
        """Of a study with sizes."""
        return f"error_vs_runtime_{self.name}_sizes.png"


STUDIES = (
    Study(
        "dam_break",
        "dam_break",
        "violent motion, used to compare solvers",
        WATER,
        2.0,
        trajectory_s=0.5,
    ),
    Study(
        "column",
        "hydrostatic_column",
        "water at rest, twenty particles high",
        WATER,
        2.0,
    ),
    Study(
        "splash", "container_splash", "a block falls into a container, as in the demo", WATER, 2.0
    ),
    Study(
        "number",
        "dam_break",
        "the same dam with more and smaller particles",
        (
            {"fluid.spacing_m": ["0.1", "0.05", "0.025"], "solver.quality": QUALITIES},
            {"fluid.spacing_m": ["0.016"], "solver.quality": ["balanced"]},
        ),
        2.0,
        water=False,
        sizes=True,
    ),
    Study(
        "depth",
        "deep_column",
        "the same column with more and thinner layers: 40, 80 and 160",
        ({"fluid.spacing_m": ["0.01", "0.005", "0.0025"], "solver.quality": QUALITIES},),
        2.0,
        water=False,
        sizes=True,
    ),
    Study(
        "ice",
        "freeze_container",
        "a splash that freezes in mid-wave and stays frozen",
        ({"solver.quality": QUALITIES}, {"preset": ["paper"]}),
        3.0,
        ("schedule=[{at_s: 0.5, celsius: -10, ramp_s: 1}]", "springs.sleep_speed_m_s=0"),
        water=False,
    ),
    Study(
        "variants",
        "dam_break",
        "threads, precision and the method of the paper",
        ({"threads": ["1", "2"], "precision": ["float", "double"]}, {"preset": ["paper"]}),
        1.0,
        water=False,
        picture=False,
    ),
)


def supported(runner, axes):
    """Axes and values that this build knows; {} where it knows none."""
    known = {}
    for key, values in axes.items():
        kept = [value for value in values if not runner.refusal_of({key: value})]
        if kept:
            known[key] = kept
    return known


def points_of(study, runner):
    """Every point of the study once; each says how many threads it uses."""
    points = {}
    for axes in study.grids:
        for point in expand(supported(runner, axes)):
            point = {"threads": THREADS, **point}
            points[identity(point)] = point
    return list(points.values())


def campaign_of(study, folder, program, repeats):
    constants = {"scene": study.scene, "duration_s": study.duration_s, "set": list(study.fixed)}
    points = points_of(study, Runner(program, constants))
    return Campaign(
        study.scene,
        folder / study.name,
        {},
        points,
        study.duration_s,
        study.fixed,
        repeats,
        trajectory_s=study.trajectory_s,
    )
