"""Cases of water at rest around solids of every shape."""

import math

import numpy as np

from iib.common.checks import at_most, reported
from iib.verification.cases import case


def at_rest(run, scene):
    """Water comes to rest at every quality, and no correction is cut then."""
    checks = []
    for quality in ("fast", "balanced", "accurate"):
        end = run(scene, sets=[f"solver.quality={quality}"])
        late = end.series["time_s"] >= 5.0
        speed = math.sqrt(np.mean(end.series["rms_speed_m_s"][late] ** 2))
        checks += [
            at_most(f"{quality}: residual speed", 1e3 * speed, 2.0, "mm/s"),
            at_most(f"{quality}: corrections cut", end.series["correction_limited"][late].sum(), 0),
            reported(
                f"{quality}: the same since the start", end.series["correction_limited"].sum()
            ),
        ]
    return checks


@case()
def shelf_at_rest(run):
    """water rests around a plate that stands free in a tank"""
    return at_rest(run, "shelf_at_rest")


@case()
def step_at_rest(run):
    """water rests on and beside a step"""
    return at_rest(run, "step_at_rest")


@case()
def oblique_wall_at_rest(run):
    """water rests in the joint of a floor and a wall at 45 degrees"""
    return at_rest(run, "oblique_wall_at_rest")


@case()
def turned_box_at_rest(run):
    """water rests around a box that is turned about all three axes"""
    return at_rest(run, "turned_box_at_rest")


@case()
def round_cup_at_rest(run):
    """water rests in a round cup with thin walls"""
    return at_rest(run, "round_cup_at_rest")
