"""The list of cases: each a function of a Runner that returns checks."""

import dataclasses
import typing

import numpy as np


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
