"""What a case of scripts/stability is: runs that have to survive, and bounds on what they did."""

import dataclasses
import math
import threading
import typing

import numpy as np
from iib.common.checks import at_least, at_most, reported

from iib.stability.verdict import energy_rise


@dataclasses.dataclass
class Case:
    """number: that of the list of extremes which the suite began with, 0 for those added; expected:
    in words.

    rise: how much energy may appear without work, of what the scene holds, or None where that is
    only reported; because: why this case has a bound of its own.
    """

    name: str
    number: int
    title: str
    expected: str
    measure: typing.Callable
    rise: float
    because: str


# Without work no energy appears. Rounding and the samples once a frame leave this much.
MOST_RISE = 1e-3

CASES = {}


def case(number=0, rise=MOST_RISE, because=""):
    """Of a function whose docstring is the title and, behind ": ", what is expected."""

    def register(function):
        title, expected = " ".join(function.__doc__.split()).split(": ", 1)
        CASES[function.__name__] = Case(
            function.__name__, number, title, expected, function, rise, because
        )
        return function

    return register


class Runs:
    """The runs of one case; all but the refused ones have to stay finite and contained."""

    def __init__(self, runner):
        self.runner, self.outcomes, self.refusals = runner, [], []
        self.lock = threading.Lock()

    def __call__(self, scene, *sets, **options):
        outcome = self.runner(scene, *sets, **options)
        with self.lock:
            self.outcomes.append(outcome)
        return outcome

    def refused(self, clue, scene, *sets, **options):
        """Whether the run is refused in one line that names the clue."""
        outcome = self.runner(scene, *sets, duration_s=0, **options)
        self.refusals.append((outcome, outcome.status == "refused" and clue in outcome.message))

    def checks(self):
        checks = []
        if self.outcomes:
            lived = sum(outcome.survived() for outcome in self.outcomes)
            checks.append(at_least("runs that stayed finite and inside", lived, len(self.outcomes)))
        if self.refusals:
            named = sum(good for _, good in self.refusals)
            checks.append(at_least("refusals that name the key", named, len(self.refusals)))
        return checks


@dataclasses.dataclass
class Measured:
    """A line of the table: the worst of all runs of a case. Not a number where nothing ran."""

    name: str
    number: int
    title: str
    expected: str
    checks: list
    particles: int = 0
    simulated_s: float = 0.0
    substeps: int = 0
    non_finite: int = 0
    escaped: int = 0
    fastest_m_s: float = math.nan
    density_error_mean: float = math.nan
    density_error_max: float = math.nan
    energy_rise: float = math.nan
    speed_limited: int = 0
    wall_s: float = 0.0
    commands: list = dataclasses.field(default_factory=list)

    def passed(self):
        return all(check.passed() for check in self.checks)


def most(values):
    known = [value for value in values if value is not None and not math.isnan(value)]
    return max(known) if known else math.nan


def rise_checks(one, rise):
    if math.isnan(rise):
        return []
    what = "energy risen" + (f", {one.because}" if one.because else "")
    return [
        reported(what, 100 * rise, "%")
        if one.rise is None
        else at_most(what, 100 * rise, 100 * one.rise, "%")
    ]


def of_runs(one, runs, checks):
    reports = [outcome.report for outcome in runs.outcomes if outcome.report]
    rise = most([energy_rise(outcome) for outcome in runs.outcomes])
    line = Measured(
        one.name,
        one.number,
        one.title,
        one.expected,
        [*runs.checks(), *rise_checks(one, rise), *checks],
    )
    line.commands = [
        outcome.reproduce()
        for outcome in [*runs.outcomes, *(outcome for outcome, _ in runs.refusals)]
    ]
    if not reports:
        return line
    for name in (
        "particles",
        "non_finite",
        "escaped",
        "fastest_m_s",
        "density_error_mean",
        "density_error_max",
        "speed_limited",
    ):
        setattr(line, name, most([report[name] for report in reports]))
    line.energy_rise = rise
    line.simulated_s = sum(report["simulated_time_s"] for report in reports)
    line.substeps = sum(report["steps"] for report in reports)
    line.wall_s = sum(report["wall_time_s"] for report in reports)
    return line


def measure(one, runner):
    runs = Runs(runner)
    try:
        checks = one.measure(runs) or []
    except (
        FileNotFoundError,
        KeyError,
    ):  # of a run that was refused or ended before it wrote anything
        checks = [
            at_least(
                "runs that wrote a report",
                sum(bool(o.report) for o in runs.outcomes),
                len(runs.outcomes),
            )
        ]
    return of_runs(one, runs, checks)


def last_positions(outcome):
    """Of every particle, m, by id."""
    return np.load(outcome.folder / "positions.npy")[-1]
