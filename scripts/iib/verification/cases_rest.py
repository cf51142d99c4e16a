"""Cases of water at rest around solids of every shape."""

import math

import numpy as np

from iib.common.checks import at_least, at_most, reported
from iib.known import answers as known
from iib.verification.cases import case, percent


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


def pressure_gradient(run, water, low_m, high_m):
    """Relative to rho g, over the heights from low_m to high_m; `water` chooses the particles."""
    z, pressure = run.particles["z"], run.particles["pressure_pa"]
    used = water & (z > low_m) & (z < high_m)
    slope = np.polyfit(z[used], pressure[used], 1)[0]
    return -slope / (run.density_kg_m3 * known.GRAVITY_M_S2)


@case()
def cup_in_bath(run):
    """a thin cup holds its water higher than the bath around it, both hydrostatic"""
    radius_m, floor_m = 0.05, 0.02
    end = run("cup_in_bath", positions=True)
    p, d = end.particles, end.spacing_m

    def in_cup(x, y, z):
        return (np.hypot(x, y) < radius_m) & (z > floor_m)

    inside = in_cup(p["x"], p["y"], p["z"])
    outside = np.hypot(p["x"], p["y"]) > radius_m
    checks = []
    for name, water, low_m in (("cup", inside, floor_m), ("bath", outside, 0.0)):
        high_m = p["z"][water].max() - 1.5 * d
        off = abs(pressure_gradient(end, water, low_m + d, high_m) - 1)
        checks.append(at_most(f"{name}: pressure gradient against rho g", percent(off), 2.0, "%"))
    moved = np.count_nonzero(in_cup(*end.positions[0].T) != inside)
    gap_m = p["z"][inside].max() - p["z"][outside].max()
    late = end.series["time_s"] >= 3.0
    speed = math.sqrt(np.mean(end.series["rms_speed_m_s"][late] ** 2))
    return [
        *checks,
        at_least("level of the cup above that of the bath", 1e3 * gap_m, 50.0, "mm"),
        at_most("particles that have left or entered the cup", moved, 0),
        at_most("residual speed", 1e3 * speed, 5.0, "mm/s"),
    ]
