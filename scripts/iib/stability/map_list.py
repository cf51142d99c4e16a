"""Which keys are swept, over which decades, in which scenes."""

import math

from iib.stability.maps import Map, Row, decades

LONGEST_S, MOST_SUBSTEPS = 1.0, 1000
CRUSHED_SUBSTEPS = 240  # where all particles become neighbours of all others
FAST = "solver.max_speed_m_s=1e5"
CALM_SPACING_M = 0.05  # of the scenes of this suite
FLOOR = -0.4  # of the splash at any size, in metres where a spacing is 5 cm


def number(value):
    return f"{value:.10g}"


def always(seconds):
    return lambda value: seconds


def budget(substeps, frame_rate_hz=60.0):
    """As long as MOST_SUBSTEPS last."""
    return always(min(LONGEST_S, MOST_SUBSTEPS / (frame_rate_hz * substeps)))


def swept(scene, key, substeps, sets=(), name=None):
    """Rows that differ in the number of substeps, for a key that is a number."""
    return [
        Row(
            f"{name + ', ' if name else ''}{n}",
            scene,
            lambda value, n=n: (f"solver.substeps={n}", *sets, f"{key}={number(value)}"),
            budget(n),
            key,
        )
        for n in substeps
    ]


def step_sets(step_s):
    """A step as frame rate and substeps, both within their ranges as long as that can be."""
    substeps = min(max(1, math.ceil(1 / (step_s * 1e4) - 1e-9)), 1000)
    return (
        f"solver.frame_rate_hz={number(1 / (step_s * substeps))}",
        f"solver.substeps={substeps}",
    )


def step_map():
    def row(g):
        return Row(
            f"{g:g}",
            "splash",
            lambda step: (f"gravity_m_s2=[0, 0, {-g}]", FAST, *step_sets(step)),
            lambda step: min(10 * LONGEST_S, MOST_SUBSTEPS * step),
            ends=(1e-7, 1.0),
            default=1 / 360,
        )

    rows = [row(g) for g in (0.1, 9.81, 100, 1000)]
    return Map("step", "Step", "substep, s", decades(1e-8, 1e1), "gravity, m/s²", rows)


def gravity_map():
    rows = [
        Row(
            f"{n}",
            "splash",
            lambda g, n=n: (f"solver.substeps={n}", FAST, f"gravity_m_s2=[0, 0, {number(-g)}]"),
            always(min(LONGEST_S, CRUSHED_SUBSTEPS / (60 * n))),
            "gravity_m_s2",
            default=9.81,
        )
        for n in (1, 2, 6, 12, 30)
    ]
    return Map("gravity", "Gravity", "gravity, m/s²", decades(1e-3, 1e5), "substeps", rows)


def strictness_map():
    rows = swept("splash", "springs.slack_1_s", (1, 2, 6, 12, 30), ("temperature.initial_c=2",))
    return Map(
        "strictness",
        "Strictness of springs",
        "springs.slack_1_s at half strictness, 1/s",
        decades(1e-2, 1e5),
        "substeps",
        rows,
    )


def compliance_map():
    rows = swept("iceberg", "ice.compliance_m_n", (2, 6, 12, 30))
    return Map(
        "compliance",
        "Elastic ice",
        "ice.compliance_m_n, m/N",
        decades(1e-10, 1e1),
        "substeps",
        rows,
    )


def jump_map():
    """From 5 down to -273.15, or from -5 up to 1000 degrees: the ends of temperatures."""

    def row(name, scene, start_c, sign, highest, sets=()):
        def all_sets(size):
            entry = f"{{at_s: 0.2, celsius: {number(start_c + sign * size)}}}"
            return (*sets, f"temperature.initial_c={start_c}", f"schedule=[{entry}]")

        return Row(name, scene, all_sets, always(LONGEST_S), ends=(0.0, highest))

    warm_ice = ("thermal.speedup=1000", "thermal.air_heat_transfer_w_m2k=1e5")
    rows = [
        row("springs, colder", "splash", 5, -1, 278.15),
        row("springs, warmer", "splash", -5, 1, 1005.0),
        row("heat, colder", "frost", 5, -1, 278.15),
        row("heat, warmer", "iceberg", -5, 1, 1005.0, warm_ice),
    ]
    return Map("jump", "Temperature step", "degrees", decades(1e-3, 1e4), "what, whither", rows)


def density_map():
    key = "fluid.rest_density_kg_m3"
    rows = [Row("water", "splash", lambda rho: (f"{key}={number(rho)}",), always(0.5), key)]
    rows += [
        Row(
            f"ice {ratio}",
            "iceberg",
            lambda rho, r=ratio: (f"ice.density_ratio={r}", f"{key}={number(rho)}"),
            always(0.5),
            key,
        )
        for ratio in (0.5, 0.917, 2)
    ]
    return Map("density", "Density", "fluid.rest_density_kg_m3", decades(1e-4, 1e10), "what", rows)


def density_ratio_map():
    inside = [0.52, 0.6, 0.7, 0.8, 0.9, 0.917, 1.0, 1.09, 1.25, 1.5, 1.75, 1.95]
    rows = swept("iceberg", "ice.density_ratio", (1, 2, 6, 30))
    return Map(
        "density_ratio",
        "Density of ice relative to water",
        "ice.density_ratio",
        sorted({*decades(1e-3, 1e3), *inside}),
        "substeps",
        rows,
    )


def scaled_splash(spacing_m):
    """The splash at another size; its floor keeps the largest within 100 m of the origin."""
    s = spacing_m / CALM_SPACING_M
    low, high, size, floor = (
        "[" + ", ".join(f"{s * x:.9g}" for x in corner) + "]"
        for corner in (
            (-0.5, -0.25, FLOOR + 0.1),
            (-0.1, 0.25, FLOOR + 0.7),
            (1.0, 0.5, 1.0),
            (0, 0, FLOOR),
        )
    )
    wall = min(max(0.02 * s, 1e-4), 10.0)
    tank = (
        f"{{name: tank, position_m: {floor}, size_m: {size}, wall_m: {wall:.9g}, open_top: false}}"
    )
    return (
        f"fluid.spacing_m={number(spacing_m)}",
        f"blocks=[{{min_m: {low}, max_m: {high}}}]",
        f"containers=[{tank}]",
        "bounds={min_m: [-100, -100, -100], max_m: [100, 100, 100]}",
    )


def froude(spacing_m):
    """Times as the square root of lengths: the same flow at any size."""
    root = math.sqrt(spacing_m / CALM_SPACING_M)
    return (
        *scaled_splash(spacing_m),
        f"solver.frame_rate_hz={60 / root:.9g}",
        f"solver.viscosity_1_s={30 / root:.9g}",
        f"solver.max_speed_m_s={30 * root:.9g}",
    )


def size_map():
    """Alike: the same flow. Otherwise a frame is 1/60 s: the smaller the stiffer."""
    rows = [
        Row("alike", "splash", froude, lambda d: math.sqrt(d / CALM_SPACING_M), "fluid.spacing_m")
    ]
    rows += [
        Row(
            f"60 Hz, {n}",
            "splash",
            lambda d, n=n: (*scaled_splash(d), f"solver.substeps={n}"),
            budget(n),
            "fluid.spacing_m",
        )
        for n in (1, 6, 30)
    ]
    return Map(
        "size", "Particle size", "fluid.spacing_m", decades(1e-5, 1e2), "rate, substeps", rows
    )


def impact_map():
    rows = [
        Row(
            f"{n}",
            "shot",
            lambda v, n=n: (f"solver.substeps={n}", f"blocks.0.velocity_m_s=[{number(v)}, 0, 0]"),
            budget(n),
            "blocks.0.velocity_m_s",
        )
        for n in (1, 2, 6, 12, 30)
    ]
    return Map("impact", "Impact speed", "speed, m/s", decades(1e-3, 1e4), "substeps", rows)


def viscosity_map():
    rows = swept("splash", "solver.viscosity_1_s", (1, 2, 6, 12, 30))
    return Map(
        "viscosity", "Viscosity", "solver.viscosity_1_s", decades(1e-3, 1e5), "substeps", rows
    )


def friction_map():
    rows = swept("splash", "containers.0.friction", (2, 6), name="water, wall")
    rows += swept(
        "iceberg", "containers.0.friction", (6,), ("blocks.0.max_m=[0.35, 0.3, 0.06]",), "ice, wall"
    )
    rows += swept("hail", "ice.friction", (2, 6), name="ice, ice")
    return Map(
        "friction", "Friction", "Coulomb coefficient", decades(1e-5, 1e2), "on what, substeps", rows
    )


def speedup_map():
    key = "thermal.speedup"

    def row(name, scene, *sets):
        return Row(
            name, scene, lambda value: (*sets, f"{key}={number(value)}"), always(LONGEST_S), key
        )

    cold = "schedule=[{at_s: 0.2, celsius: -100}]"
    rows = [
        row("freezing, still air", "frost", cold, "thermal.air_heat_transfer_w_m2k=20"),
        row("freezing, gale", "frost", cold),
        row(
            "melting, gale",
            "hail",
            "schedule=[{at_s: 0, celsius: 100}]",
            "thermal.air_heat_transfer_w_m2k=1e5",
        ),
        row("boiling", "kettle"),
    ]
    return Map("speedup", "Thermal speed-up", "thermal.speedup", decades(1e-2, 1e9), "what", rows)


MAPS = {
    one.name: one
    for one in (
        step_map(),
        gravity_map(),
        strictness_map(),
        compliance_map(),
        jump_map(),
        density_map(),
        density_ratio_map(),
        size_map(),
        impact_map(),
        viscosity_map(),
        friction_map(),
        speedup_map(),
    )
}
