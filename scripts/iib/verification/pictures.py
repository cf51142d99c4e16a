"""Pictures of doc/verification.md: what a table cannot tell of a case. Needs matplotlib."""

import numpy as np

from iib.known import answers as known
from iib.known import spheric_2
from iib.verification.cases_dams import level_m


def figure(columns, width_in=9.0, height_in=3.6):
    from iib.common.plotting import pyplot

    return pyplot.subplots(1, columns, figsize=(width_in, height_in), constrained_layout=True)


def save(drawing, path):
    drawing.savefig(path, dpi=110)
    print(f"wrote {path}")


def dams(run, path):
    drawing, places = figure(2)
    scenes = (
        ("martin_moyce_tall", 2, "twice as high as wide"),
        ("martin_moyce_square", 1, "as high as wide"),
    )
    for place, (scene, ratio, title) in zip(places, scenes):
        end, width = run(scene), 2.25 * 0.0254
        time = known.martin_moyce_time(end.series["time_s"], width, ratio)
        place.plot(time, (end.series["max_x_m"] + 0.5 * end.spacing_m) / width, label="simulated")
        for (n2, inches), data in known.MARTIN_MOYCE.items():
            if n2 == ratio:
                place.plot(
                    *data,
                    "o" if inches == 2.25 else "^",
                    ms=4,
                    mfc="none",
                    label=f"measured, a = {inches} in",
                )
        place.set(title=title, xlabel="T", ylabel="x / a", xlim=(0, 4.2), ylim=(1, 6.5))
        place.legend()
    save(drawing, path)


def patch(run, path):
    end = run("elliptical_patch", positions=True)
    drawing, places = figure(3, height_in=2.2)
    angle = np.linspace(0, 2 * np.pi, 200)
    for place, strain in zip(places, (0.5, 1.0, 2.0)):
        frame = int(np.argmin(np.abs(4.0 * end.series["time_s"] - strain)))
        x, y, _ = end.positions[frame].T
        a, b = 0.5 * known.elliptical_patch(4.0, [end.series["time_s"][frame]])[0]
        place.plot(x, y, ".", ms=0.6, color="tab:blue")
        place.plot(a * np.cos(angle), b * np.sin(angle), color="tab:red", lw=0.8)
        place.set(
            title=f"A0 t = {strain:g}", aspect="equal", xlim=(-1.95, 1.95), ylim=(-0.55, 0.55)
        )
    save(drawing, path)


def swing(run, path):
    end = run("sloshing")
    time, mean = end.series["time_s"], end.series["mean_x_m"]
    period, decay, amplitude = known.damped_swing(time, mean)
    drawing, place = figure(1, width_in=6, height_in=3)
    place.plot(time, 1e3 * mean, label="centre of mass, simulated")
    for sign in (-1, 1):
        place.plot(time, sign * 1e3 * amplitude * np.exp(-decay * time), color="tab:gray", lw=0.8)
    for k in range(1, int(time[-1] / known.standing_wave_period(0.6, 0.3)) + 1):
        place.axvline(k * known.standing_wave_period(0.6, 0.3), color="tab:red", lw=0.6)
    place.set(xlabel="s", ylabel="mm", title=f"period {period:.3f} s; linear theory: the red lines")
    place.legend()
    save(drawing, path)


def column(run, path):
    """Pressure over depth, and the speed of water that should be still."""
    end = run("hydrostatic_column")
    drawing, (left, right) = figure(2)
    p = end.particles
    measured = "pressure_pa" in p
    left.plot(p["pressure_pa"] if measured else p["density"], p["z"], ".", ms=2, label="particles")
    if measured:
        surface = 2 * p["z"].mean()
        left.plot(
            [1e3 * known.GRAVITY_M_S2 * surface, 0],
            [0, surface],
            color="tab:red",
            label="rho g depth",
        )
    left.set(xlabel="Pa" if measured else "density / rest density", ylabel="height, m")
    left.legend()
    right.semilogy(end.series["time_s"], 1e3 * np.maximum(end.series["rms_speed_m_s"], 1e-6))
    right.set(xlabel="s", ylabel="rms speed, mm/s", title="how still it is")
    save(drawing, path)


def levels(run, path):
    """Water levels of SPHERIC benchmark 2 at two spacings, and the experiment."""
    drawing, places = figure(4, width_in=12, height_in=2.8)
    for spacing_m in (0.05, 0.025):
        end = run("spheric_2", positions=True, sets=[f"fluid.spacing_m={spacing_m}"])
        for place, gauge in zip(places, spheric_2.GAUGES):
            time, level = end.series["time_s"], level_m(end, gauge)
            place.plot(time, level, lw=0.9, label=f"{100 * spacing_m:g} cm")
    for place, gauge in zip(places, spheric_2.GAUGES):
        place.plot(spheric_2.TIME_S, gauge.level_m, "ko", ms=3, mfc="none", label="measured")
        place.set(title=gauge.name, xlabel="s", ylim=(0, 0.6))
    places[0].set(ylabel="level, m")
    places[0].legend()
    save(drawing, path)


PICTURES = {
    "verification_spheric_2.png": levels,
    "verification_dams.png": dams,
    "verification_patch.png": patch,
    "verification_column.png": column,
    "verification_sloshing.png": swing,
}


def draw(run, folder):
    for name, picture in PICTURES.items():
        picture(run, folder / name)
