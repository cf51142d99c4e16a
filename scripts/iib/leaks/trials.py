"""Trials of scripts/leaks: which there are, and what one of them finds."""

import dataclasses
import json

from iib.common.processes import run

SPACINGS_M = (0.02, 0.012, 0.006, 0.003)
QUICK_SPACINGS_M = (0.012,)
QUALITIES = ("fast", "balanced", "accurate")

CLOSED = ("container", "bottle")
# Plates are colliders without an inside: placed elsewhere, only the box takes their water along.
ONLY_IN_BOX = ("plates", "teleported")


@dataclasses.dataclass(frozen=True)
class Trial:
    """Motions one after the other with the same water."""

    vessel: str
    motions: tuple
    spacing_m: float
    quality: str
    in_box: bool
    seconds: float
    seed: int

    def words(self):
        return (
            f"--vessel {self.vessel} --spacing {self.spacing_m:g} --quality {self.quality} "
            f"--seconds {self.seconds:g} --seed {self.seed}{' --in-box' if self.in_box else ''} "
            f"--motion {' '.join(self.motions)}"
        ).split()

    def command(self):
        return " ".join(["leak_trial", *self.words()])


def names(program):
    """Vessels and motions that the program has."""
    listed = json.loads(run([program, "--list"]))
    return listed["vessels"], listed["motions"]


def of_round(vessels, motions, spacings_m, seconds, number=0, in_boxes=False):
    """All vessels at each spacing. The quality, and whether an open vessel stands in a box, change
    from trial to trial and from round to round, so six rounds have every combination.

    in_boxes: every open vessel stands in one, so that each motion has water.
    """
    found = []
    for v, vessel in enumerate(vessels):
        for s, spacing_m in enumerate(spacings_m):
            turn = v + s + number
            quality = QUALITIES[turn % len(QUALITIES)]
            in_box = (in_boxes or turn % 2 == 0) and vessel not in CLOSED
            kept = tuple(m for m in motions if in_box or (vessel, m) != ONLY_IN_BOX)
            if kept:
                found.append(
                    Trial(vessel, kept, spacing_m, quality, in_box, seconds, 1000 * number + 1)
                )
    # The longest first, so that the last ones end together.
    return sorted(found, key=lambda trial: trial.spacing_m)


def measure(program, trial):
    """One result for each motion."""
    return [json.loads(line) for line in run([program, *trial.words()]).splitlines()]
