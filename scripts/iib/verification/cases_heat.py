"""Cases of heat: fronts of ice, conserved enthalpy, the volume of freezing and melting."""

import math

import numpy as np

from iib.known import ice as known_ice
from iib.common.checks import at_least, at_most, reported
from iib.verification.cases import case, percent


def front_error(run, freezing, water_c=0.0, layers=14, spacing_m=0.01, depth=10, sets=()):
    """Relative error of the front in the frames from `depth` layers of ice on, until there are
    `layers`.

    The front is the thickness that the ice would have in one piece: what freezes in part counts in
    part.
    """
    seconds = 10.0
    height_m = (layers + 10) * spacing_m
    sets = [
        *sets,
        *freezing.settings(),
        f"thermal.speedup={freezing.time(layers * spacing_m) / seconds!r}",
        f"fluid.spacing_m={spacing_m!r}",
        f"blocks=[{{min_m: [-0.04, -0.04, 0], max_m: [0.04, 0.04, {height_m!r}], "
        f"celsius: {water_c!r}}}]",
    ]
    end = run("stefan", duration_s=seconds, sets=sets)
    series = end.series
    heat_s = np.concatenate([[0.0], np.cumsum(series["thermal_speedup"][1:]) / end.frame_rate_hz])
    ice_m3 = end.lattice_kg * series["strictness"] / freezing.ice_kg_m3
    measured, expected = ice_m3 / 0.08**2, freezing.front(heat_s)
    flowed = (
        np.diff(series["enthalpy_j"], prepend=series["enthalpy_j"][0]) != 0.0
    )  # in some frames heat waits
    scored = flowed & (measured >= depth * spacing_m)
    apart = measured[scored] / expected[scored] - 1.0
    return apart, end


def front_checks(apart, bound):
    worst = apart[np.argmax(np.abs(apart))]
    return [
        at_most("front at ten layers and later, maximum error", percent(abs(worst)), bound, "%"),
        reported("front at ten layers and later, mean signed error", percent(apart.mean()), "%"),
    ]


@case()
def stefan_ice(run):
    """a front of real ice grows from a plate at -10 degrees and lifts the water"""
    apart, end = front_error(run, known_ice.Freezing())
    top = end.series["max_z_m"][-1] + 0.5 * end.spacing_m
    frozen = end.series["strictness"][-1]
    lifted = 0.24 * (1.0 + frozen * (1.0 / 0.917 - 1.0))
    heavy, _ = front_error(run, known_ice.Freezing(), sets=["gravity_m_s2=[0, 0, -9.81]"])
    return [
        *front_checks(apart, 1.0),
        reported("the same under full gravity, mean signed error", percent(heavy.mean()), "%"),
        reported("height of the column, relative to the expected expansion", top / lifted),
        reported("residual speed", 1e3 * end.report["residual_speed_m_s"], "mm/s"),
    ]


def stefan_alike(run, stefan):
    plain, _ = front_error(run, known_ice.alike(stefan))
    swelling, _ = front_error(run, known_ice.alike(stefan, ice_kg_m3=917.0))
    checks = front_checks(plain, 1.0)
    for check in front_checks(swelling, 1.0):
        check.what += ", ice of 917 kg/m3"
        checks.append(check)
    return checks


@case()
def stefan_005(run):
    """a front of ice at a Stefan number of 0.05, without and with expansion"""
    return stefan_alike(run, 0.05)


@case()
def stefan_02(run):
    """a front of ice at a Stefan number of 0.2, without and with expansion"""
    return stefan_alike(run, 0.2)


@case()
def stefan_1(run):
    """a front of ice at a Stefan number of 1, without and with expansion"""
    return stefan_alike(run, 1.0)


@case()
def stefan_superheat(run):
    """a front of real ice below water of 5 degrees, and of the same with expansion at a Stefan
    number of 1
    """
    real, _ = front_error(run, known_ice.Freezing(water_c=5.0), 5.0)
    alike, _ = front_error(run, known_ice.alike(1.0, 5.0, 917.0), 5.0)
    checks = front_checks(real, 2.0)
    for check in front_checks(alike, 2.0):
        check.what += ", Stefan number 1"
        checks.append(check)
    return checks


@case(long=True)
def stefan_order(run):
    """the error of the front falls with the spacing"""
    errors = []
    for layers in (5, 10, 20):
        spacing_m = 0.1 / layers
        apart, _ = front_error(run, known_ice.alike(1.0), 0.0, layers + 1, spacing_m, layers)
        errors.append(abs(apart[0]))
    return [
        *(
            reported(f"front at {n} layers for the same depth, error", percent(e), "%")
            for n, e in zip((5, 10, 20), errors)
        ),
        reported("order from 5 to 10 layers", math.log2(errors[0] / errors[1])),
        reported("order from 10 to 20 layers", math.log2(errors[1] / errors[2])),
    ]


@case()
def insulated_splash(run):
    """ice splashes into water that nothing heats: some freezes, some melts, the heat stays"""
    checks = []
    for precision, bound in (("float", 1e-6), ("double", 1e-10)):
        end = run("insulated_splash", precision=precision)
        heat, ice = end.series["enthalpy_j"], end.series["strictness"]
        drift = np.abs(heat - heat[0]).max() / np.abs(heat).max()
        checks += [
            at_most(f"change of enthalpy, relative, {precision}", drift, bound),
            reported(f"ice fraction at the start, {precision}", ice[0]),
            reported(f"maximum ice fraction, {precision}", ice.max()),
            reported(f"ice fraction at the end, {precision}", ice[-1]),
        ]
    return checks


def volume(run, time_s):
    """Height of the centre of mass above the lowest particle, to which the volume of what fills a
    basin is proportional.

    The lowest layer lies half a spacing above the floor whatever it is, so the height above the
    floor would count its half layer as one that does not swell.
    """
    frame = np.argmin(np.abs(run.series["time_s"] - time_s))
    return run.series["mean_z_m"][frame] - run.series["min_z_m"][frame]


@case()
def freeze_thaw(run):
    """a basin freezes through, stands a tenth higher, and thaws to where it was"""
    end = run("freeze_thaw")
    ice, time = end.series["strictness"], end.series["time_s"]
    settled, frozen, thawed = (volume(end, at_s) for at_s in (0.4, 2.9, time[-1]))
    gained = percent(frozen / settled - 1.0)
    return [
        at_least("ice fraction when cold", ice[np.argmin(np.abs(time - 2.9))], 1.0),
        at_most("ice fraction at the end", ice[-1], 0.0),
        at_most("volume gained by freezing, difference from 9.05", abs(gained - 9.05), 1.0, "%"),
        reported("volume gained by freezing", gained, "%"),
        at_most(
            "volume after thawing, difference from before",
            percent(abs(thawed / settled - 1.0)),
            1.0,
            "%",
        ),
    ]


@case(long=True)
def freeze_thaw_100(run):
    """a basin freezes and thaws a hundred times: water, heat and volume return"""
    cycles, period_s = 100, 4.0
    schedule = ", ".join(
        f"{{at_s: {k * period_s + 0.5!r}, celsius: -40}}, "
        f"{{at_s: {k * period_s + 2.25!r}, celsius: 40}}"
        for k in range(cycles)
    )
    end = run("freeze_thaw", duration_s=cycles * period_s, sets=[f"schedule=[{schedule}]"])
    time, ice = end.series["time_s"], end.series["strictness"]
    ends = [int(np.argmin(np.abs(time - k * period_s))) for k in range(1, cycles + 1)]
    colds = [int(np.argmin(np.abs(time - (k * period_s + 2.2)))) for k in range(cycles)]
    # A cycle ends before the water is as warm as the air, which differs from cycle to cycle.
    first, last = (
        {name: end.series[name][ends[ten]].mean() for name in ("enthalpy_j", "mean_z_m")}
        for ten in (slice(0, 10), slice(-10, None))
    )
    energy = end.series["total_energy_j"][ends]
    return [
        at_least("ice fraction when cold, minimum of all cycles", ice[colds].min(), 1.0),
        at_most("ice fraction when warm, maximum of all cycles", ice[ends].max(), 0.0),
        at_most("ice bodies left", end.series["ice_bodies"][-1], 0.0),
        at_most("springs left", end.series["springs"][-1], 0.0),
        at_most(
            "particles that left or broke", end.report["escaped"] + end.report["non_finite"], 0.0
        ),
        at_most(
            "enthalpy after the last ten cycles, relative to the first ten",
            percent(abs(last["enthalpy_j"] / first["enthalpy_j"] - 1.0)),
            1.0,
            "%",
        ),
        at_most(
            "volume after the last ten cycles, relative to the first ten",
            percent(abs(last["mean_z_m"] / first["mean_z_m"] - 1.0)),
            1.0,
            "%",
        ),
        at_most(
            "mechanical energy after the last cycle, relative to the first",
            percent(abs(energy[-1] / energy[0] - 1.0)),
            1.0,
            "%",
        ),
    ]
