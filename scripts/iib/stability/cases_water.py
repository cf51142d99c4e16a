"""Cases of water: absurd steps, forces, speeds and sizes."""

import math

import numpy as np
from iib.common.checks import at_most

from iib.stability.cases import case, last_positions
from iib.stability.map_list import FLOOR, froude

D = 0.05  # spacing of the scenes, m
FREE = "solver.max_speed_m_s=1e5"
AT_ONE_SECOND = ("solver.frame_rate_hz=1", "solver.substeps=1")


def tank(*sizes, z=0.0, wall=0.02):
    size = ", ".join(f"{s:g}" for s in sizes)
    return (
        f"containers=[{{name: tank, position_m: [0, 0, {z:g}], size_m: [{size}], "
        f"wall_m: {wall:g}, open_top: false}}]"
    )


def calm(outcome, bound=0.02):
    """The density error in the last tenth of the run."""
    error = outcome.series()["density_error_mean"]
    late = error[-max(1, len(error) // 10) :].mean()
    return at_most("mean density error at the end", 100 * late, 100 * bound, "%")


@case(1, rise=0.05, because="crushed in a step")
def step_of_a_second(run):
    """Substeps of 1 s and of 1/6 s: no faster than the limit, contained"""
    ends = [
        run("splash", *sets, duration_s=60) for sets in (AT_ONE_SECOND, ("solver.frame_rate_hz=1",))
    ]
    return [at_most("fastest", max(end.report["fastest_m_s"] for end in ends), 30.001, "m/s")]


@case(2, rise=1.0, because="crushed in a step")
def gravity_of_1e4(run):
    """Gravity of 10,000 m/s², vertical and oblique, with the default speed limit and without:
    capped, contained
    """
    usual = run("splash", "gravity_m_s2=[0, 0, -1e4]")
    run("splash", "gravity_m_s2=[1e4, 1e4, -1e4]")
    run("splash", "gravity_m_s2=[0, 0, -1e4]", FREE)
    run("iceberg", "gravity_m_s2=[1e4, 1e4, -1e4]")
    return [at_most("maximum speed with the limit", usual.report["fastest_m_s"], 30.001, "m/s")]


@case(10)
def no_iterations(run):
    """No solver iterations: ballistic flight as in the closed form, contained"""
    run("splash", "solver.iterations=0")
    end = run(
        "free_fall",
        "solver.iterations=0",
        "solver.substeps=6",
        precision="double",
        series=True,
    )
    series = end.series()
    time, step = series["time_s"], 1 / 360
    stepped = 10.125 + 3 * time - 0.5 * 9.81 * time * (time + step)
    height = series["potential_energy_j"] / series["potential_energy_j"][0] * 10.125
    return [
        at_most(
            "height against the closed form, relative", np.max(np.abs(height / stepped - 1)), 1e-12
        )
    ]


@case(11)
def any_size(run):
    """Particles of 0.1 mm to 10 m, times scaled with the square root of lengths: the same flow"""
    sizes = (1e-4, 1e-3, 0.01, 0.05, 1, 10)
    ends = {
        d: run(
            "splash", *froude(d), duration_s=math.sqrt(d / D) * 0.5, series=True, precision="double"
        )
        for d in sizes
    }
    runs = {d: end.series() for d, end in ends.items()}
    frames = min(len(series["time_s"]) for series in runs.values())  # rounding may add one
    heights = np.array([series["mean_z_m"][:frames] / d - FLOOR / D for d, series in runs.items()])
    errors = np.array([series["density_error_mean"][:frames] for series in runs.values()])
    base = sizes.index(D)
    return [
        at_most(
            "height of the centre of mass, difference from 5 cm",
            100 * np.abs(heights / heights[base] - 1).max(),
            0.1,
            "%",
        ),
        at_most(
            "density error, difference from 5 cm",
            100 * np.abs(errors - errors[base]).max(),
            0.05,
            "%",
        ),
    ]


@case(12, rise=None, because="relative to almost no weight: rounding")
def denormals(run):
    """Gravity so small that speeds are denormal: at most twice as slow as with ordinary numbers"""

    def cost(gravity):
        return run(
            "pool",
            f"gravity_m_s2=[0, 0, {gravity}]",
            FREE,
            "solver.iterations=2",
            "solver.epsilon=0",
        ).report["wall_time_s"]

    cost("-1e-3")
    return [at_most("wall time relative to 1e-10 m/s²", cost("-1e-38") / cost("-1e-10"), 2.0)]


@case(13)
def nothing_in_it(run):
    """Scenes without water, without walls, and without both: they run"""
    ends = [
        run("splash", "blocks=[]"),
        run("splash", "containers=[]"),
        run("splash", "blocks=[]", "containers=[]"),
    ]
    ends.append(run("iceberg", "blocks=[]"))
    return [
        at_most(
            "particles in the empty ones", sum(ends[k].report["particles"] for k in (0, 2, 3)), 0
        )
    ]


@case(18, rise=2e-3, because="with one substep per frame")
def thousand_metres_a_second(run):
    """Water and ice at 1,000 m/s against walls and a plate a tenth of a millimetre thick: no
    tunnelling
    """
    for speed in ("[1000, 0, 0]", "[-577, 577, 577]", "[0, 0, -1000]"):
        run("shot", f"blocks.0.velocity_m_s={speed}")
        run("shot", f"blocks.0.velocity_m_s={speed}", "solver.substeps=1")
        run("shot", f"blocks.0.velocity_m_s={speed}", "thermal.enabled=true", "blocks.0.celsius=-5")
    plate = (
        "planes=[{name: plate, position_m: [0.35, 0, 0.5], rpy_deg: [0, -90, 0], "
        "size_x_m: 1, size_y_m: 1, thickness_m: 1e-4}]"
    )
    through = [
        run("shot", "blocks.0.velocity_m_s=[1000, 0, 0]", plate, *ice, series=True)
        for ice in ((), ("thermal.enabled=true", "blocks.0.celsius=-5"))
    ]
    beyond = sum(int((last_positions(end)[:, 0] > 0.36).sum()) for end in through)
    return [at_most("particles behind the plate", beyond, 0)]


@case(19)
def step_500_times_longer(run):
    """From 1,000 substeps per frame to 2, through a large target error: rescaled, no impulse"""
    end = run("pool", "solver.substeps=1000", "solver.target_error=0.5", duration_s=3, series=True)
    first = run("pool", "solver.substeps=2", duration_s=3, series=True)
    kick = end.series()["max_speed_m_s"].max() / first.series()["max_speed_m_s"].max()
    return [
        at_most("maximum speed, relative to 2 substeps from the start", kick, 1.2),
        calm(end, 0.05),
    ]


@case(21)
def far_from_the_origin(run):
    """Water 100 km and 99 m from the origin: refused by name; comes to rest as at the origin"""
    run.refused("containers.0.position_m", "pool", "containers.0.position_m=[1e5, 0, 0]")
    run.refused("blocks.0.m", "pool", "blocks.0.min_m=[1e5, 0, 0]", "blocks.0.max_m=[100001, 1, 1]")
    far = (
        "blocks.0.min_m=[98.75, 98.8, 90]",
        "blocks.0.max_m=[99.25, 99.2, 90.4]",
        "containers.0.position_m=[99, 99, 90]",
        "bounds.max_m=[100, 100, 100]",
    )
    near, out = run("pool", duration_s=5, series=True), run("pool", *far, duration_s=5, series=True)
    error = [end.series()["density_error_mean"][-60:].mean() for end in (near, out)]
    return [
        at_most(
            "density error, difference from the origin", 100 * abs(error[1] - error[0]), 0.1, "%"
        ),
        at_most("residual speed", 1e3 * out.report["residual_speed_m_s"], 50, "mm/s"),
    ]


@case(rise=None, because="no limit applies")
def no_guard(run):
    """Relaxation 1, no correction limit, no viscosity, one iteration, tension resisted:
    contained
    """
    bare = (
        "solver.relaxation=1",
        "solver.max_correction_h=0",
        "solver.viscosity_1_s=0",
        "solver.epsilon=0",
        FREE,
    )
    run("splash", *bare, "solver.iterations=1", duration_s=4)
    run("splash", *bare, "solver.resist_tension=true", duration_s=4)
    run("splash", *bare, "fluid.kernel=poly6_spiky", "fluid.boundary_density=false", duration_s=4)


@case(rise=0.01, because="at a hundred times the weight")
def preset_paper(run):
    """The constants of the paper at a hundred times its gravity, as water and as springs:
    contained
    """
    run("splash", "gravity_m_s2=[0, 0, -981]", preset="paper", duration_s=2)
    run(
        "pool",
        "temperature.initial_c=-10",
        "gravity_m_s2=[0, 0, -981]",
        preset="paper",
        duration_s=2,
    )


@case(rise=2e-3, because="ice breaks off at 100 m/s")
def fastest_spin(run):
    """Water and ice spun at 1,000 rad/s and stretched at 1,000 1/s: contained"""
    for ice in ((), ("thermal.enabled=true", "blocks.0.celsius=-5")):
        run(
            "shot",
            "blocks.0.angular_velocity_rad_s=[1000, 1000, 1000]",
            "blocks.0.velocity_m_s=[0, 0, 0]",
            *ice,
        )
        run(
            "shot",
            "blocks.0.velocity_gradient_1_s=[[1000, 0, 0], [0, -1000, 1000], [0, 0, 0]]",
            *ice,
        )


@case(rise=0.05, because="a knot in the sheet is crushed")
def sheet_under_load(run):
    """A sheet falls onto a sphere at a hundred times its weight: contained, the springs hold"""
    block = "blocks=[{min_m: [-0.4, -0.4, 0.5], max_m: [0.4, 0.4, 0.55], sheet: true}]"
    for place in ("0, 0, 0.25", "0, 0, 0.252", "0, 0.001, 0.25", "0.005, 0.005, 0.25"):
        ball = f"spheres=[{{name: ball, position_m: [{place}], radius_m: 0.15}}]"
        run("splash", block, ball, tank(1, 1, 1), "gravity_m_s2=[0, 0, -981]", duration_s=2)
