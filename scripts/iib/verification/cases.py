"""The list of cases: each a function of a Runner that returns checks."""

import dataclasses
import typing

import numpy as np

from iib.common.checks import at_most


@dataclasses.dataclass
class Case:
    name: str
    measure: typing.Callable
    meaning: str
    long: bool


CASES = {}


def case(long=False):
    """Registers a function; the first paragraph of its docstring is the meaning of the case."""

    def register(function):
        meaning = " ".join(function.__doc__.split("\n\n")[0].split())
        CASES[function.__name__] = Case(function.__name__, function, meaning, long)
        return function

    return register


def percent(ratio):
    return 100.0 * float(ratio)


def relative(measured, expected):
    return float(np.max(np.abs(measured - expected) / np.abs(expected)))


def energy_rise(run):
    """Highest total energy above the initial energy, relative to the largest part of it."""
    total = run.series["total_energy_j"]
    scale = max(
        run.series["kinetic_energy_j"].max(), np.abs(run.series["potential_energy_j"]).max()
    )
    return at_most(
        "energy above the initial energy", percent((total.max() - total[0]) / scale), 0.1, "%"
    )
