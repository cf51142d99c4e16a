"""Trials of scripts/leaks: which there are, and what one of them finds."""

import dataclasses
import json

from iib.common.processes import run

SPACINGS_M = (0.02, 0.012, 0.006, 0.003)
QUICK_SPACINGS_M = (0.02, 0.012)
QUALITIES = ("fast", "balanced", "accurate")

# Plates are colliders without an inside: placed elsewhere, they leave the water behind.
LEFT_OUT = {("plates", "teleported")}


@dataclasses.dataclass(frozen=True)
class Trial:
    vessel: str
    motion: str
    spacing_m: float
    quality: str
    seconds: float
    seed: int

    def words(self):
        return (
            f"--vessel {self.vessel} --motion {self.motion} --spacing {self.spacing_m:g} "
            f"--quality {self.quality} --seconds {self.seconds:g} --seed {self.seed}"
        ).split()

    def command(self):
        return " ".join(["leak_trial", *self.words()])


def names(program):
    """Vessels and motions that the program has."""
    listed = json.loads(run([program, "--list"]))
    return listed["vessels"], listed["motions"]


def of_round(vessels, motions, spacings_m, seconds, number=0):
    """All pairs of a vessel and a motion at each spacing. The quality changes from trial to trial
    and from round to round, so three rounds have every combination."""
    found = []
    for v, vessel in enumerate(vessels):
        for m, motion in enumerate(motions):
            if (vessel, motion) in LEFT_OUT:
                continue
            for s, spacing_m in enumerate(spacings_m):
                quality = QUALITIES[(v + m + s + number) % len(QUALITIES)]
                found.append(Trial(vessel, motion, spacing_m, quality, seconds, 1000 * number + 1))
    # The longest first, so that the last ones end together.
    return sorted(found, key=lambda trial: trial.spacing_m)


def measure(program, trial):
    return json.loads(run([program, *trial.words()]))
