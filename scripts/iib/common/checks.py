"""Measured figures and their bounds."""

import dataclasses
import math


def number(value, digits=4):
    return "not measured" if math.isnan(value) else f"{value:.{digits}g}"


@dataclasses.dataclass
class Check:
    """One measured figure. Without a bound it is for information and decides nothing."""

    what: str
    measured: float
    relation: str = ""
    bound: float = math.nan
    unit: str = ""

    def passed(self):
        if not self.relation:
            return True
        return self.measured <= self.bound if self.relation == "<=" else self.measured >= self.bound

    def text(self, digits=4):
        bound = f" {self.relation} {self.bound:g}" if self.relation else ""
        return f"{self.what}: {number(self.measured, digits)}{bound} {self.unit}".strip()

    def line(self, digits=4):
        """For the terminal: pass, FAIL or neither, then the text."""
        word = ("pass" if self.passed() else "FAIL") if self.relation else ""
        return f"  {word:4}  {self.text(digits)}"


def at_most(what, measured, bound, unit=""):
    return Check(what, float(measured), "<=", bound, unit)


def at_least(what, measured, bound, unit=""):
    return Check(what, float(measured), ">=", bound, unit)


def reported(what, measured, unit=""):
    return Check(what, float(measured), unit=unit)
