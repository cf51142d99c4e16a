"""What a case of scripts/verify is made of: measured figures, their bounds, and the list of cases."""

import dataclasses
import math
import typing

import numpy as np


@dataclasses.dataclass
class Check:
    """One measured figure. Without a bound it is told but decides nothing."""

    what: str
    measured: float
    relation: str = ""
    bound: float = math.nan
    unit: str = ""

    def passed(self):
        if not self.relation:
            return True
        return self.measured <= self.bound if self.relation == "<=" else self.measured >= self.bound


def at_most(what, measured, bound, unit=""):
    return Check(what, float(measured), "<=", bound, unit)


def at_least(what, measured, bound, unit=""):
    return Check(what, float(measured), ">=", bound, unit)


def told(what, measured, unit=""):
    return Check(what, float(measured), unit=unit)


@dataclasses.dataclass
class Case:
    name: str
    measure: typing.Callable
    meaning: str
    long: bool


CASES = {}


def case(long=False):
    def register(function):
        CASES[function.__name__] = Case(function.__name__, function, function.__doc__.splitlines()[0], long)
        return function

    return register


def percent(ratio):
    return 100.0 * float(ratio)


def relative(measured, expected):
    return float(np.max(np.abs(measured - expected) / np.abs(expected)))
