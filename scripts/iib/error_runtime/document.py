"""The text of doc/error_vs_runtime.md, worked out of the finished runs."""

from iib.common import machine, markdown
from iib.error_runtime import choices
from iib.error_runtime.naming import metric, setting, varying
from iib.error_runtime.studies import PEERS_STUDY, THREADS

# Metrics that the tables show, in this order, where the scene has them.
COLUMNS = """density_mean density_max column_height_lost front_error energy_rise residual_speed_m_s
apart within_a_spacing_s ice_drift_spacings ice_residual_speed_m_s""".split()

MEANING = """## Definitions

- **Cost**: wall time of the frames, without measurements, per particle and simulated second;
  median of the repeats, which ran in rounds. Points joined by a line differ only in the labelled
  value. The bar behind a point is the spread of its repeats; × is unstable.
- **Density error**: max(ρ/ρ0 − 1, 0) with the cubic spline at h = 2 d, walls included, whatever
  kernel the solver uses: mean over particles and frames, and mean over frames of the maximum.
- **Volume lost**: mean of 1 − 1 / max(ρ/ρ0, 1). **Column height**: twice the height of the centre
  of mass of water that fills its container, mean over the last half second; given as the decrease
  from the start (negative: too high).
- **Energy gained without work**: maximum of the total energy above its running minimum, relative
  to the weight of the water times its initial height plus its initial kinetic energy. 0 is ideal.
- **Speed of the last half second**: root mean square over particles and frames. 0 is ideal for
  water at rest. For a splash, compare it with the accurate settings: higher is restless, lower is
  too viscous.
{distance}- **Ice**: root mean square distance of the particles from the best-fit rigid motion of
  the body that they froze into, from the frame in which it froze to the end, in spacings; and the
  residual speed, ideally 0. Sleep is off.
"""


DISTANCE = """\
- **Distance to the reference**: root mean square distance of the particles from those of a run in
  double with {substeps} substeps, in spacings. That reference and one with half its substeps stay
  within a spacing for {horizon}; later, the flow is chaotic and the distance has no meaning.
"""


def compact(number):
    """Two digits, and neither 1.1e+02 nor 7.3e-07."""
    if 0 < abs(number) < 1e-4:
        return "<0.0001"
    return f"{number:.0f}" if abs(number) >= 99.5 else f"{number:.2g}"


def percent(value):
    return compact(100 * value)


def shown(row, name):
    value = row.get(name, "")
    return "–" if value in ("", None) else compact(value * metric(name)[2])


def columns_of(rows):
    apart = [name for row in rows for name in row if name.startswith("apart_spacings_at_")]
    names = [name if name != "apart" else apart[-1] if apart else "" for name in COLUMNS]
    return [name for name in names if any(row.get(name, "") != "" for row in rows)]


def points_table(rows, keys):
    names = columns_of(rows)
    header = ["setting", "µs/particle/s"] + [f"{metric(n)[0]}, {metric(n)[1]}" for n in names]
    lines = []
    for row in sorted(rows, key=lambda row: row.get(choices.COST, 0)):
        cost = f"{row[choices.COST]:.0f}" if choices.COST in row else "–"
        name = setting(row, keys) + ("" if row["status"] == "ok" else f" ({row['status']})")
        lines.append([name, cost] + [shown(row, n) for n in names])
    return markdown.table(header, lines)


def sizes_table(rows, keys):
    """What an accuracy costs at each number of particles."""
    lines = []
    for row in sorted(rows, key=lambda row: (row.get("particles", 0), -row.get("density_mean", 0))):
        if choices.COST not in row:
            continue
        cost = row[choices.COST]
        lines.append(
            [
                f"{row['particles']:,}",
                setting(row, keys),
                percent(row["density_mean"]),
                percent(row["density_max"]),
                percent(row.get("energy_rise", 0)),
                f"{cost:.0f}",
                f"{choices.most_particles({'cost': cost}):,.0f}",
            ]
        )
    return markdown.table(
        [
            "particles",
            "setting",
            "mean error %",
            "maximum %",
            "energy gained without work, %",
            "µs/particle/s",
            "particles in real time",
        ],
        lines,
    )


def study_section(result):
    study, constants, rows = result.study, result.constants, result.rows
    keys = varying(rows, result.axes)
    counts = sorted({row["particles"] for row in rows if "particles" in row})
    text = f"## {study.scene}: {study.shows}\n\n"
    between = f"{counts[0]:,}" if len(counts) == 1 else f"{counts[0]:,} to {counts[-1]:,}"
    text += f"{between} particles, {constants['duration_s']:g} s"
    text += "".join(f", `{word}`" for word in constants["set"]) + ".\n\n"
    if study.sizes:
        text += f"![error and cost over the number of particles](images/{study.picture_name})\n\n"
    elif study.picture:
        name = f"images/error_vs_runtime_{study.name}_"
        text += (
            f"![error against run time]({name}error.png)\n![other metrics]({name}metrics.png)\n\n"
        )
    if study.sizes:
        return text + sizes_table(rows, keys) + "\n"
    if study.water:
        text += "Pareto front:\n\n"
        rows = [row for row in rows if row["on_front"]]
    return text + points_table(rows, keys) + "\n"


def counts_table(settings, keys):
    lines = []
    for count in choices.COUNTS:
        best = choices.for_count(settings, count)
        if best is None:
            fastest = min(settings, key=lambda s: s["cost"])
            factor = 1e6 / (count * fastest["cost"])
            lines.append(
                [
                    f"{count:,}",
                    f"none in real time; {setting(fastest['keys'], keys)}: ×{factor:.2f}",
                    percent(fastest["error"]),
                    percent(fastest["largest"]),
                ]
            )
            break
        lines.append(
            [
                f"{count:,}",
                setting(best["keys"], keys),
                percent(best["error"]),
                percent(best["largest"]),
            ]
        )
    return markdown.table(["particles in real time", "setting", "mean error %", "maximum %"], lines)


def targets_table(settings, keys, names):
    lines = []
    for target in choices.TARGETS:
        best = choices.for_target(settings, target)
        if best is None:
            lines.append(
                [percent(target), "none of the measured settings"] + ["–"] * (len(names) + 2)
            )
            continue
        errors = [percent(row["density_mean"]) for row in best["rows"]]
        lines.append(
            [
                percent(target),
                setting(best["keys"], keys),
                f"{best['cost']:.0f}",
                f"{choices.most_particles(best):,.0f}",
                *errors,
            ]
        )
    return markdown.table(
        [
            "mean error at most %",
            "take",
            "µs/particle/s",
            "particles in real time",
            *(f"% in {name}" for name in names),
        ],
        lines,
    )


def advice(settings, keys, count=20_000):
    best = choices.for_count(settings, count)
    if best is not None:
        return (
            f"**For 30 fps with {count:,} particles take {setting(best['keys'], keys)}** "
            f"(`{choices.overrides({k: best['keys'][k] for k in keys})}`): real time, mean density "
            f"error {percent(best['error'])} % in the worst of these scenes."
        )
    fastest = min(settings, key=lambda s: s["cost"])
    return (
        f"**{count:,} particles do not reach real time on this machine**: the fastest setting, "
        f"{setting(fastest['keys'], keys)}, runs at ×{1e6 / (count * fastest['cost']):.2f}, "
        f"and in real time at up to {choices.most_particles(fastest):,.0f} particles."
    )


def conclusions(results):
    water = [result for result in results if result.study.water]
    axes = list(dict.fromkeys(key for result in water for key in result.axes))
    settings = choices.sound(choices.joined([result.rows for result in water], axes))
    if not settings:
        return "No setting was stable and kept its energy in every scene of water.\n"
    keys = varying([s["keys"] for s in settings], axes)
    names = [result.study.scene for result in water]
    judged = (
        f"Each setting is judged by the worst of {', '.join(names[:-1])} and {names[-1]}; settings "
        f"that gain more than {percent(choices.MAX_ENERGY_RISE)} % of energy without work are "
        "excluded. Real time holds at any frame rate: "
        "a viewer at 30 fps shows every second frame of 1/60 s."
    )
    tables = [counts_table(settings, keys), targets_table(settings, keys, names)]
    return "\n\n".join([advice(settings, keys), judged, *tables]) + "\n"


def peers_section(results, peers):
    if not peers:
        return ""
    (result,) = [r for r in results if r.study.name == PEERS_STUDY]
    keys = varying(result.rows, result.axes)
    lines = []
    for peer, best, ratio in choices.against_peers(result.rows, peers):
        ours = ["none", "–", "–"]
        if best:
            ours = [setting(best, keys), f"{best[choices.COST]:.0f}", f"**{ratio:.1f}**"]
        lines.append(
            [
                f"{peer['peer']} {peer['method']} {peer['setting']}",
                f"{peer['us_per_particle_per_s']:.0f}",
                f"{peer['mean_error_percent']:g}",
                f"{peer['max_error_percent'] or '–'}",
                *ours,
            ]
        )
    header = [
        "peer",
        "µs/particle/s",
        "mean error %",
        "maximum %",
        "cheapest setting here with no larger errors",
        "µs/particle/s",
        "times cheaper",
    ]
    return (
        f"## Comparison with SPlisHSPlasH\n\nIn {result.study.scene}:\n\n"
        + markdown.table(header, lines)
        + "\n\n"
    )


def origin(results):
    runs = [run for result in results for run in result.runs]
    commits = sorted({run["commit"] for run in runs})
    dates = sorted(run["date"] for run in runs)
    took = sum(run["seconds"] for run in runs) / 60
    return (
        f"Made by `scripts/error_vs_runtime --report` at commit {', '.join(commits)} on "
        f"{machine.processor()}, {THREADS} threads and float unless stated otherwise, "
        f"{dates[0][:10]}; {len(runs)} runs, {took:.0f} min of machine time. The cost of a "
        "setting depends on the processor; measure it on yours."
    )


def meaning(results):
    kept = next((result.reference for result in results if result.reference), None)
    if kept is None:
        return MEANING.format(distance="")
    horizon = f"{kept['horizon_s']:.2g} s"
    if kept["horizon_s"] >= kept["seconds"] - 1e-9:
        horizon = f"all of the {kept['seconds']:g} s compared"
    distance = DISTANCE.format(substeps=kept["substeps"], horizon=horizon)
    return MEANING.format(distance=distance)


def document(results, peers):
    sections = [study_section(result) for result in results]
    return "\n".join(
        [
            "# Error and run time\n",
            "Which settings should I use: what error do I get for which run time?\n",
            origin(results) + "\n",
            "## Recommended settings\n",
            conclusions(results),
            peers_section(results, peers) + "\n".join(sections),
            meaning(results),
        ]
    )
