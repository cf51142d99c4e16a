"""Cases of ice, heat and steam; and of threads, for all of them."""

import numpy as np
from iib.common.checks import at_least, at_most, reported

from iib.stability.cases import case
from iib.stability.cases_water import AT_ONE_SECOND

IN_A_GALE = ("thermal.air_heat_transfer_w_m2k=1e5",)


def momentum_lost(outcome):
    """Of what the two halves of the scene carried against each other, from the start to the end."""
    series = outcome.series()
    momentum = np.stack([series[f"momentum_{axis}_kg_m_s"] for axis in "xyz"], axis=1)
    mass_kg = 2 * series["kinetic_energy_j"][0] / series["rms_speed_m_s"][0] ** 2
    return np.linalg.norm(momentum - momentum[0], axis=1).max() / (
        mass_kg * series["rms_speed_m_s"][0]
    )


@case(7)
def instant_freeze(run):
    """A splash freezes completely in flight, by springs and by heat: momentum kept, no particle
    faster than before
    """
    checks = []
    for kind, sets in (("springs", ("thermal.enabled=false",)), ("heat", ("thermal.speedup=1e7",))):
        end = run("freeze_in_flight", *sets, series=True)
        series = end.series()
        faster = (
            series["max_speed_m_s"][series["time_s"] > 0.3].max()
            / series["max_speed_m_s"][:18].max()
        )
        checks += [
            at_most(f"{kind}: momentum lost", momentum_lost(end), 1e-5),
            at_most(f"{kind}: maximum speed after / before", faster, 1.05),
            reported(f"{kind}: maximum ice", 100 * end.report["max_ice"], "%"),
        ]
    return checks


@case(9, rise=0.02, because="freezing water lifts the water above")
def absurd_temperatures(run):
    """±10⁶ degrees, NaN and infinity for every temperature in a scene: refused by name"""
    for value in ("1e6", "-1e6", ".nan", ".inf", "-.inf", "-273.16", "1000.001"):
        run.refused("temperature.initial_c", "splash", f"temperature.initial_c={value}")
        run.refused("celsius", "splash", f"schedule=[{{at_s: 0, celsius: {value}}}]")
        run.refused("blocks.0.celsius", "iceberg", f"blocks.0.celsius={value}")
        run.refused(
            "containers.0.celsius",
            "iceberg",
            "containers.0.heat=temperature",
            f"containers.0.celsius={value}",
        )
    for celsius in (-273.15, 1000):
        run(
            "iceberg",
            f"schedule=[{{at_s: 0.1, celsius: {celsius}}}]",
            "thermal.speedup=1e7",
            *IN_A_GALE,
        )
        run("splash", f"schedule=[{{at_s: 0.1, celsius: {celsius}}}]")


@case(24)
def overshooting_settings(run):
    """Relaxation above 1, warm start above 1/2, an impossible mass: refused; epsilon 0:
    stable
    """
    run.refused("solver.relaxation", "splash", "solver.relaxation=1.01")
    run.refused("solver.warm_start", "splash", "solver.warm_start=0.9")
    run.refused("fluid.particle_mass_kg", "splash", "fluid.particle_mass_kg=1e3")
    end = run("splash", "solver.epsilon=0", duration_s=4)
    return [
        at_most(
            "mean density error without epsilon", 100 * end.report["density_error_mean"], 1, "%"
        ),
        at_most("speed limit applied", end.report["speed_limited"], 0),
    ]


@case(25)
def backward_and_nowhere(run):
    """Negative steps; poses, sizes and velocities that are NaN: refused by name"""
    for key in (
        "solver.frame_rate_hz",
        "solver.substeps",
        "solver.iterations",
        "duration_s",
        "thermal.speedup",
    ):
        run.refused(key, "splash", f"{key}=-1")
    for key in ("solver.frame_rate_hz", "fluid.spacing_m", "ice.density_ratio"):
        run.refused(key, "splash", f"{key}=.nan")
    for key in (
        "gravity_m_s2",
        "containers.0.position_m",
        "containers.0.rpy_deg",
        "containers.0.size_m",
        "blocks.0.min_m",
        "blocks.0.velocity_m_s",
    ):
        for value in ("[.nan, 0, 0]", "[0, .inf, 0]"):
            run.refused(key, "splash", f"{key}={value}")


@case(26)
def melting_in_contact(run):
    """Spheres of ice stacked in water melt within a tenth of a second: no impulse, all melted"""
    hot = (
        "thermal.speedup=1e5",
        "schedule=[{at_s: 0.6, celsius: 200}]",
        "thermal.boiling_c=900",
        *IN_A_GALE,
    )
    end = run("hail", *hot, duration_s=3, series=True)
    series = end.series()
    before, after = (
        series["max_speed_m_s"][part].max()
        for part in (series["time_s"] < 0.6, series["time_s"] > 0.6)
    )
    return [
        at_most("maximum speed after / before", after / before, 1.5),
        at_most("ice left", 100 * end.report["strictness"], 1, "%"),
        at_least("maximum number of bodies", end.report["max_ice_bodies"], 27),
    ]


@case(27)
def any_number_of_threads(run):
    """Water, ice, hail, frost and steam with 1, 2, 4 and 8 threads: the same bits"""
    freezing = ("schedule=[{at_s: 0.2, celsius: -100}]",)
    apart = 0
    for scene, sets in (
        ("splash", ()),
        ("iceberg", ()),
        ("hail", ()),
        ("frost", freezing),
        ("kettle", ()),
    ):
        hashes = {run(scene, *sets, threads=n).report["state_hash"] for n in (1, 2, 4, 8)}
        apart += len(hashes) - 1
    return [at_most("scenes that differ in bits", apart, 0)]


@case(rise=None, because="expanding ice does work")
def frozen_in_a_full_tank(run):
    """A full closed tank freezes without room to expand, with ice lighter and heavier than water:
    contained
    """
    full = (
        "blocks=[{min_m: [-0.4, -0.2, 0], max_m: [0.4, 0.2, 0.7], celsius: 1}]",
        "thermal.speedup=1e5",
        "containers.0.heat=temperature",
        "containers.0.celsius=-100",
        *IN_A_GALE,
    )
    for ratio in (0.5, 0.917, 2):
        run(
            "frost",
            *full,
            f"ice.density_ratio={ratio}",
            "schedule=[{at_s: 0, celsius: -100}]",
            duration_s=2,
        )


@case(rise=None, because="steam is lifted")
def all_boils_at_once(run):
    """Boiling at the maximum speed-up and flux, then complete condensation: contained,
    counted
    """
    end = run("kettle", "thermal.speedup=1e7", "containers.0.flux_w_m2=1e7")
    run("kettle", "thermal.speedup=1e7", "containers.0.flux_w_m2=-1e7")
    run(
        "kettle",
        "thermal.speedup=1e7",
        "containers.0.flux_w_m2=1e7",
        "steam.rise_speed_m_s=100",
        "steam.drag_1_s=1e4",
    )
    return [at_least("fraction of steam", end.report["max_steam"] / end.report["particles"], 0.5)]


@case(rise=5e-3, because="crushed in a step")
def ice_at_a_step_of_a_second(run):
    """Icebergs, hail and frost with a substep of a second: contained"""
    for scene, sets in (
        ("iceberg", ()),
        ("hail", ()),
        ("frost", ("schedule=[{at_s: 2, celsius: -100}]",)),
        ("kettle", ()),
    ):
        run(scene, *AT_ONE_SECOND, *sets, duration_s=60)


@case()
def greatest_conductivity(run):
    """Conductivities, specific heats and latent heats at the ends of their ranges, at the maximum
    speed-up: contained
    """
    fast = (
        "thermal.speedup=1e7",
        "schedule=[{at_s: 0.1, celsius: -100}, {at_s: 0.5, celsius: 500}]",
    )
    most = (
        "thermal.ice_conductivity_w_mk=1e4",
        "thermal.water_conductivity_w_mk=1e4",
        "thermal.air_heat_transfer_w_m2k=1e6",
    )
    least = (
        "thermal.ice_specific_heat_j_kgk=1",
        "thermal.water_specific_heat_j_kgk=1",
        "thermal.steam_specific_heat_j_kgk=1",
    )
    latent = ("thermal.latent_heat_fusion_j_kg=1", "thermal.latent_heat_vaporisation_j_kg=1")
    for sets in (
        most,
        (*most, *least),
        (*most, *least, *latent),
        ("thermal.hysteresis_c=0", *latent),
    ):
        run("frost", *fast, *sets)
        run("iceberg", *fast, *sets)


@case(rise=0.02, because="the correction limit cuts springs")
def elastic_ice_that_shatters(run):
    """Elastic ice of any compliance is shot at a wall and breaks: contained"""
    for compliance in ("1e-9", "1e-6", "1e-3", "1"):
        sets = ("thermal.enabled=true", "blocks.0.celsius=-5", f"ice.compliance_m_n={compliance}")
        run("shot", *sets, "ice.break_strain=0.01", "blocks.0.velocity_m_s=[100, 30, 10]")
        run("shot", *sets, "blocks.0.velocity_m_s=[100, 30, 10]")
