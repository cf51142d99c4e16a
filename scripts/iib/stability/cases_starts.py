"""Cases of water that starts crowded, coincident or in no room."""

from iib.common.checks import at_most
from iib.stability.cases import case
from iib.stability.cases_water import D, tank


def point(x=0.0, y=0.0, z=0.0):
    """A block of one particle, there."""
    low, high = (", ".join(f"{c + side * D / 2:.15g}" for c in (x, y, z)) for side in (-1, 1))
    return f"{{min_m: [{low}], max_m: [{high}]}}"


def copied(block, x, y, z, also=None):
    """That block so many times, in one place unless a step is given."""
    words = [f"copies: [{x}, {y}, {z}]", *([also] if also else [])]
    return block.replace("}", f", {', '.join(words)}}}")


@case(3)
def all_coincident(run):
    """A thousand particles at one point: refused by name"""
    run.refused(
        "blocks.1 overlaps blocks.0", "splash", f"blocks=[{copied(point(z=0.3), 10, 10, 10)}]"
    )


@case(4)
def nearly_coincident_pair(run):
    """Two particles 1e-12 m apart, in single and double precision: refused by name"""
    for precision in ("float", "double"):
        blocks = f"blocks=[{point(z=0.3)}, {point(x=1e-12, z=0.3)}]"
        run.refused("blocks.1 overlaps blocks.0", "splash", blocks, precision=precision)


@case(5)
def centre_of_a_sphere(run):
    """A particle at the exact centre of a sphere, and a block around a sphere: refused by name"""
    ball = "spheres=[{name: ball, position_m: [0, 0, 0.3], radius_m: 0.1}]"
    run.refused("sphere ball (spheres.0)", "splash", f"blocks=[{point(z=0.3)}]", ball)
    run.refused("sphere ball (spheres.0)", "splash", ball.replace("[0, 0, 0.3]", "[-0.3, 0, 0.4]"))


@case(6)
def too_full(run):
    """A tank with eight times its water, and a million particles in space for half of them:
    refused by
    name
    """
    full = copied("{min_m: [-0.25, -0.25, 0], max_m: [0.25, 0.25, 0.5]}", 2, 2, 2)
    run.refused("blocks.1 overlaps blocks.0", "splash", f"blocks=[{full}]", tank(0.5, 0.5, 0.5))
    crowd = copied("{min_m: [-0.5, -0.5, 0], max_m: [0.5, 0.5, 0.5]}", 1, 1, 2)
    run.refused(
        "blocks.1 overlaps blocks.0",
        "splash",
        f"blocks=[{crowd}]",
        tank(1, 1, 0.5),
        "fluid.spacing_m=0.01",
    )


@case(14)
def one_particle(run):
    """One particle without gravity: no force acts on it"""
    end = run("splash", f"blocks=[{point(z=0.3)}]", "gravity_m_s2=[0, 0, 0]", duration_s=10)
    run("splash", f"blocks=[{point(z=0.3)}]")
    return [at_most("fastest", end.report["fastest_m_s"], 0.0, "m/s")]


@case(17)
def gap_below_a_particle(run):
    """Gaps of less than a spacing between sphere, plate and floor, a tank narrower than a particle:
    contained
    """
    run("splash", "spheres=[{name: ball, position_m: [0.2, 0, 0.17], radius_m: 0.15}]")
    run(
        "splash",
        "planes=[{name: plate, position_m: [0, 0, 0.04], size_x_m: 0.9, size_y_m: 0.5, "
        "thickness_m: 0.02}]",
    )
    run("splash", f"blocks=[{point(z=0.03)}]", tank(0.03, 0.03, 0.5))
    run("splash", f"blocks=[{point(z=0.03)}, {point(z=0.08)}]", tank(0.03, 0.03, 0.11))
    run.refused(
        "blocks.1 overlaps blocks.0",
        "splash",
        f"blocks=[{point(z=0.03)}, {point(z=0.06)}]",
        tank(0.03, 0.03, 0.5),
    )


@case(22)
def ten_thousand_in_a_cell(run):
    """Ten thousand particles within two fifths of a spacing: refused by name"""
    block = copied(point(x=-0.3, y=-0.1, z=0.3), 10, 10, 10, "copies_step_m: [0.002, 0.002, 0.002]")
    shifted = [block.replace("min_m: [", f"rpy_deg: [0, 0, {9 * k}], min_m: [") for k in range(10)]
    run.refused(
        "blocks.1 overlaps blocks.0", "splash", f"blocks=[{', '.join(shifted)}]", tank(1.6, 1, 2)
    )


@case(23)
def overlapping_spawn(run):
    """Water spawned twice in one place, half a spacing apart, and inside a wall: refused by name"""
    block = "{min_m: [-0.5, -0.25, 0.1], max_m: [-0.1, 0.25, 0.7]}"
    aside = "{min_m: [-0.475, -0.25, 0.1], max_m: [-0.075, 0.225, 0.7]}"
    for other in (block, aside):
        run.refused("blocks.1 overlaps blocks.0", "splash", f"blocks=[{block}, {other}]")
    run.refused(
        "the wall of container tank (containers.0)",
        "splash",
        "blocks.0.min_m=[-0.535, -0.25, 0.1]",
        "containers.0.open_top=true",
    )
