"""Maps of what stays up: one key swept over decades, crossed with a second axis.

Every map runs past the ends of the key's range, so that what is refused shows, and stands just
inside and just outside of each end: there the program has to change its mind.
"""

import dataclasses
import math
import re
import typing

from iib.stability.runs import Asked
from iib.stability.verdict import REFUSED, UNSTABLE, verdict

PER_DECADE = 3
EDGE = 1e-6  # relative distance of the points beside an end of a range


def decades(first, last):
    """Three figures a decade, ends included: 1, 2.15, 4.64, 10 ..."""
    count = round(math.log10(last / first) * PER_DECADE)
    return [float(f"{first * 10 ** (k / PER_DECADE):.3g}") for k in range(count + 1)]


@dataclasses.dataclass
class Row:
    """Of a map. sets: the overrides of a swept value; seconds: how long it runs; key: whose range
    says what is refused; ends: from where to where it may run, where no one key says so."""

    name: str
    scene: str
    sets: typing.Callable
    seconds: typing.Callable
    key: str = ""
    ends: tuple = ()
    default: float = None

    def range(self, ranges):
        if self.ends:
            return self.ends
        found = ranges[re.sub(r"\.\d+\.", ".", self.key)]
        return found.low, found.high

    def usual(self, ranges):
        """What the key is when nobody says otherwise; None where there is no such value."""
        if self.default is not None:
            return self.default
        found = ranges.get(re.sub(r"\.\d+\.", ".", self.key))
        return float(found.default) if found and not found.vector else None

    def points(self, values, ranges):
        """Swept values, and those beside the ends of the range."""
        beside = {
            end * (1 + sign * EDGE) for end in self.range(ranges) if end > 0 for sign in (-1, 1)
        }
        return sorted({*values, *beside})


@dataclasses.dataclass
class Map:
    """what: the swept value, with its unit; values: of it; across: what the rows differ in."""

    name: str
    title: str
    what: str
    values: list
    across: str
    rows: list


@dataclasses.dataclass
class Point:
    row: str
    value: float
    inside: bool
    outcome: object

    @property
    def verdict(self):
        return verdict(self.outcome)

    def as_expected(self):
        """It stays up, and is refused where the range of its key says so and nowhere else."""
        return self.verdict != UNSTABLE and (self.verdict == REFUSED) == (not self.inside)


def places(one, ranges):
    return [(row, value) for row in one.rows for value in row.points(one.values, ranges)]


def measure(one, ranges, runner, pool, bar):
    """Every point of a map, by row and value."""

    def point(place):
        row, value = place
        low, high = row.range(ranges)
        outcome = runner.run(
            Asked(row.scene, tuple(row.sets(value)), duration_s=row.seconds(value))
        )
        bar.end(one.name, outcome.seconds)
        return Point(row.name, value, low <= value <= high, outcome)

    return list(pool.map(point, places(one, ranges)))


def counts(points):
    """Points by verdict."""
    found = {}
    for point in points:
        found[point.verdict] = found.get(point.verdict, 0) + 1
    return found
