"""Sums of trials, and the table of them."""

import dataclasses

from iib.common import markdown


@dataclasses.dataclass
class Tally:
    particle_seconds: float = 0.0
    through_wall: int = 0
    escaped_over_rim: int = 0
    nan: int = 0
    seconds: float = 0.0

    def add(self, result):
        for field in ("particle_seconds", "through_wall", "escaped_over_rim", "nan", "seconds"):
            setattr(self, field, getattr(self, field) + result[field])

    def failed(self):
        return self.through_wall > 0 or self.nan > 0

    def cells(self):
        counts = (self.particle_seconds, self.through_wall, self.escaped_over_rim, self.nan)
        return [f"{count:,.0f}" for count in counts]


def of(results):
    """Tally of all, and tallies by vessel and motion."""
    total, pairs = Tally(), {}
    for result in results:
        total.add(result)
        pairs.setdefault((result["vessel"], result["motion"]), Tally()).add(result)
    return total, pairs


def table(vessels, motions, total, pairs):
    columns = ["vessel", "motion", "particle-seconds", "through a wall", "over the rim", "NaN"]
    rows = [
        [vessel, motion, *pairs[vessel, motion].cells()]
        for vessel in vessels
        for motion in motions
        if (vessel, motion) in pairs
    ]
    return markdown.table(columns, [*rows, ["all", "all", *total.cells()]], columns[:2])
