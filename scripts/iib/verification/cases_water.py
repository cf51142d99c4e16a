"""Cases of water: free fall, rest, the elliptical patch, impacts, sloshing."""

import math

import numpy as np

from iib.known import answers as known
from iib.common.checks import at_least, at_most, reported
from iib.verification.cases import case, energy_rise, percent, relative


def mean_height(run):
    """Of the centre of mass, in double: the series' own mean is of single precision positions."""
    return run.series["potential_energy_j"] / (run.mass_kg * known.GRAVITY_M_S2)


def landing(run, drop_m, surface_m, frame_s):
    """Frames between the touch of the lowest particle and the landing of a stone."""
    touches = run.series["min_z_m"] <= surface_m + 0.5 * run.spacing_m + 1e-5
    time = run.series["time_s"][np.argmax(touches)] if touches.any() else math.inf
    return at_most(
        "time of landing, difference from free fall, in frames",
        abs(time - known.fall_time(drop_m)) / frame_s,
        1.0,
    )


@case()
def free_fall(run):
    """thrown water keeps to the parabola"""
    end = run("free_fall", precision="double")
    time, step = end.series["time_s"], 1.0 / (60 * end.substeps)
    height = mean_height(end)
    stepped = known.symplectic_fall(10.125, 3.0, time, step)
    speed2 = 1.0 + 4.0 + (3.0 - known.GRAVITY_M_S2 * time) ** 2
    halved = run("free_fall", precision="double", sets=[f"solver.substeps={2 * end.substeps}"])
    single = run("free_fall", precision="float")
    parabola = known.parabola(10.125, 3.0, time)
    ratio = abs(height[-1] - parabola[-1]) / abs(mean_height(halved)[-1] - parabola[-1])
    return [
        at_most(
            "height against the stepped closed form, relative", relative(height, stepped), 1e-12
        ),
        at_most(
            "kinetic energy against the closed form, relative",
            relative(end.series["kinetic_energy_j"], 0.5 * end.mass_kg * speed2),
            1e-12,
        ),
        at_most(
            "height after 1 s in single precision, difference",
            1e3 * abs(single.series["mean_z_m"][-1] - stepped[-1]),
            1.0,
            "mm",
        ),
        at_most(
            "ratio of the errors to the parabola for a step and half of it, difference from 2",
            abs(ratio - 2.0),
            1e-6,
        ),
    ]


def still(run, since_s):
    """What holds of water at rest."""
    late = run.series["time_s"] >= since_s
    height = run.series["mean_z_m"]
    speed = math.sqrt(np.mean(run.series["rms_speed_m_s"][late] ** 2))
    return [
        at_least(
            "height of the centre of mass, relative to the start",
            height[late].mean() / height[0],
            0.98,
        ),
        at_most(
            "mean density error", percent(run.series["density_error_mean"][late].mean()), 0.1, "%"
        ),
        at_most("residual speed", 1e3 * speed, 10.0, "mm/s"),
    ]


def pressure_error(run):
    """Of particles further than the support radius from walls and surface, at the end."""
    if "pressure_pa" not in run.particles:
        return reported(
            "interior pressure against rho g depth (no pressure_pa in --particles)", math.nan, "%"
        )
    p, reach = run.particles, 2 * run.spacing_m
    surface = 2 * p["z"].mean()
    half = np.abs(p["x"]).max() + run.spacing_m / 2
    inside = (
        (np.maximum(np.abs(p["x"]), np.abs(p["y"])) < half - reach)
        & (p["z"] > reach)
        & (p["z"] < surface - reach)
    )
    expected = run.density_kg_m3 * known.GRAVITY_M_S2 * (surface - p["z"][inside])
    apart = p["pressure_pa"][inside] - expected
    error = math.sqrt(np.mean(apart**2) / np.mean(expected**2))
    return at_most("interior pressure against rho g depth, RMS", percent(error), 5.0, "%")


@case()
def hydrostatic_column(run):
    """a column at rest carries its weight and keeps its height"""
    end = run("hydrostatic_column")
    return [pressure_error(end), *still(end, 3.0), energy_rise(end)]


@case()
def deep_column(run):
    """eighty layers of water rest as accurately as twenty"""
    end = run("deep_column")
    return [pressure_error(end), *still(end, 1.0), energy_rise(end)]


@case()
def deepest_column(run):
    """160 layers of small particles rest as accurately as twenty"""
    end = run("deepest_column")
    return [pressure_error(end), *still(end, 1.0), energy_rise(end)]


def minute_at_rest(end):
    height, time = end.series["mean_z_m"], end.series["time_s"]
    energy = end.series["total_energy_j"]
    early, late = (time > 5) & (time <= 15), time > 50
    drift = abs(height[late].mean() / height[early].mean() - 1)
    rise = (energy[late].mean() - energy[early].mean()) / abs(energy[0])
    return [
        *still(end, 50.0),
        at_most("volume drift from the first 15 s to the last 10 s", percent(drift), 1.0, "%"),
        at_most("energy gained from the first 15 s to the last 10 s", percent(rise), 0.1, "%"),
    ]


@case(long=True)
def hydrostatic_column_minute(run):
    """the column again, for 60 s"""
    return minute_at_rest(run("hydrostatic_column", duration_s=60))


@case(long=True)
def pool_at_rest(run):
    """a still pool stays still for 60 s"""
    return minute_at_rest(run("pool_at_rest"))


@case()
def elliptical_patch(run):
    """a strained disk turns into the ellipses of the exact solution"""
    end, radius, rate = run("elliptical_patch"), 0.5, 4.0
    time = end.series["time_s"]
    axes = radius * known.elliptical_patch(rate, time)
    half = 0.5 * (end.series["max_x_m"] - end.series["min_x_m"] + end.spacing_m)
    area = end.series["rms_x_m"] * end.series["rms_y_m"]
    inside = rate * time <= 2.0 + 1e-9
    kinetic = end.series["kinetic_energy_j"]
    return [
        at_most(
            "semi-major axis, maximum error up to A0 t = 2",
            percent(relative(half[inside], axes[inside, 0])),
            3.0,
            "%",
        ),
        at_most(
            "area, maximum change up to A0 t = 2",
            percent(relative(area[inside], area[0])),
            1.0,
            "%",
        ),
        reported("final kinetic energy, relative to the start", kinetic[-1] / kinetic[0]),
        energy_rise(end),
    ]


@case()
def spinning_disk(run):
    """what nothing holds together flies apart along straight lines"""
    end = run("spinning_disk", precision="double")
    time, spin = end.series["time_s"], end.series["angular_momentum_z_kg_m2_s"]
    radius = end.series["rms_x_m"][0] * np.sqrt(1 + (2.0 * time) ** 2)
    return [
        at_most(
            "radius against the closed form, relative",
            relative(end.series["rms_x_m"], radius),
            1e-6,
        ),
        at_most(
            "change of kinetic energy, relative",
            relative(end.series["kinetic_energy_j"], end.series["kinetic_energy_j"][0]),
            1e-12,
        ),
        at_most("angular momentum lost or gained, relative", relative(spin, spin[0]), 1e-6),
    ]


@case()
def ball_drop(run):
    """a falling ball of water lands when a stone would"""
    end = run("ball_drop", precision="double")
    frame, step = 1.0 / 480, 1.0 / (480 * end.substeps)
    flying = end.series["time_s"] < known.fall_time(0.5) - 2 * frame
    stepped = known.symplectic_fall(0.62, 0.0, end.series["time_s"], step)
    return [
        at_most(
            "height while it falls, relative",
            relative(mean_height(end)[flying], stepped[flying]),
            1e-12,
        ),
        landing(end, 0.5, 0.0, frame),
        energy_rise(end),
    ]


@case()
def ball_on_sphere(run):
    """water bursts on a sphere and never gets inside"""
    end, step = run("ball_on_sphere", positions=True), 1.0 / 480
    distance = np.linalg.norm(end.positions - np.array([0, 0, 0.25], np.float32), axis=2)
    return [
        at_least(
            "minimum distance to the surface of the sphere, in spacings",
            (distance.min() - 0.15) / end.spacing_m,
            0.5 - 1e-4,
        ),
        landing(end, 0.3, 0.4, step),
        energy_rise(end),
    ]


@case()
def falling_column(run):
    """a column falls down a pipe, lands, and comes to rest"""
    end, step = run("falling_column"), 1.0 / 60
    time = end.series["time_s"]
    flying = time < known.fall_time(0.3) - step
    height, late = end.series["mean_z_m"], time > 3.0
    return [
        at_most(
            "shape while it falls, relative",
            relative(end.series["rms_z_m"][flying], end.series["rms_z_m"][0]),
            1e-3,
        ),
        landing(end, 0.3, 0.0, step),
        at_least("height at rest, relative to the column", 2 * height[late].mean() / 0.4, 0.98),
        energy_rise(end),
    ]


@case()
def collision(run):
    """two balls of water collide: momentum stays, energy falls"""
    end = run("collision", precision="double")
    ball = 0.5 * end.mass_kg
    momentum = np.stack([end.series[f"momentum_{axis}_kg_m_s"] for axis in "xyz"], axis=1)
    spin = np.stack([end.series[f"angular_momentum_{axis}_kg_m2_s"] for axis in "xyz"], axis=1)
    drift = np.linalg.norm(momentum - momentum[0], axis=1).max() / (ball * 2.5)
    turned = np.linalg.norm(spin - spin[0], axis=1).max() / np.linalg.norm(spin[0])
    return [
        # Samples are single precision; test/core holds the solver's own sums to 1e-12.
        at_most("change of momentum, relative to the momentum exchanged", drift, 1e-6),
        reported("change of angular momentum", percent(turned), "%"),
        energy_rise(end),
    ]


@case()
def sloshing(run):
    """water swings in a tank with the period of its first standing wave"""
    end = run("sloshing")
    period, decay, _ = known.damped_swing(end.series["time_s"], end.series["mean_x_m"])
    expected = known.standing_wave_period(0.6, 0.3)
    return [
        at_most("period against linear theory", percent(abs(period / expected - 1)), 5.0, "%"),
        reported(
            "fraction of the amplitude lost per period", percent(1 - math.exp(-decay * period)), "%"
        ),
        energy_rise(end),
    ]
