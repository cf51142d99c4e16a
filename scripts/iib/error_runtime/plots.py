"""Pictures of a campaign: error.png, and faces.png with every other face of the error."""

import math
import pathlib
import textwrap

from matplotlib import ticker

from iib.common.plotting import pyplot
from iib.error_runtime.labels import annotate
from iib.error_runtime.naming import face, main_axis, sort_key, varying, words
from iib.error_runtime.points import mark_front

# Column along x: that of PER_PARTICLE or of ABSOLUTE, put there by with_cost().
COST = "cost"
PER_PARTICLE = ("us_per_particle_per_s", "µs per particle and simulated second")
ABSOLUTE = ("wall_s_per_s", "run time per simulated second, s")

# Okabe and Ito: told apart by everybody.
COLORS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#8A7A00"]
MARKERS = "osD^vP*X"
STYLE = {
    "font.size": 9,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlelocation": "left",
    "axes.titleweight": "bold",
    "legend.frameon": False,
    "figure.dpi": 130,
    "savefig.dpi": 130,
}

# Faces worth a panel, in this order, where the scene has them.
PANELS = """density_max column_height_lost front_error energy_rise volume_lost apart
residual_speed_m_s ice_drift_spacings ice_residual_speed_m_s""".split()


def with_cost(rows, column):
    """Copies of the rows with a cost and the front of the mean error by that cost."""
    copies = [dict(row) for row in rows]
    for row in copies:
        for end in ("", "_min", "_max"):
            if column + end in row:
                row[COST + end] = row[column + end]
    mark_front(copies, COST)
    return copies


class Series:
    """Points that differ only along the main axis, cheapest first."""

    def __init__(self, rows, keys, number):
        self.rows = rows
        self.name = ", ".join(words(key, rows[0].get(key)) for key in keys)
        self.color = COLORS[number % len(COLORS)]
        self.marker = MARKERS[number // len(COLORS) % len(MARKERS)]


def series_of(rows, axes):
    """(main axis, list of Series)."""
    along = main_axis(rows, axes)
    keys = [key for key in varying(rows, axes) if key != along]
    groups = {}
    for row in rows:
        groups.setdefault(tuple(str(row.get(key)) for key in keys), []).append(row)
    ordered = sorted(groups, key=lambda values: [sort_key(value) for value in values])
    for group in groups.values():
        group.sort(key=lambda row: sort_key(row.get(along)))
    return along, [Series(groups[values], keys, k) for k, values in enumerate(ordered)]


def value_of(row, name):
    """A face in the unit in which it is drawn; None where the row has none."""
    value = row.get(name, "")
    if value in ("", None) or not math.isfinite(value):
        return None
    return abs(value) * face(name)[2]


def drawable(rows, name):
    return [row for row in rows if COST in row and (value_of(row, name) or 0) > 0]


def plain(value, _=None):
    return f"{value:,.0f}" if value >= 1000 else f"{value:g}"


def log_axis(axis, room=2.8):
    """Plain numbers, at 1, 2 and 5 where the axis spans fewer decades than it has room for."""
    low, high = axis.get_view_interval()
    short = math.log10(high / low) < room
    axis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5) if short else (1,)))
    axis.set_major_formatter(ticker.FuncFormatter(plain))
    axis.set_minor_formatter(ticker.NullFormatter())


def draw_series(axes, series, name):
    rows = drawable(series.rows, name)
    good = [row for row in rows if row["status"] == "ok"]
    bad = [row for row in rows if row["status"] != "ok"]
    xy = [(row[COST], value_of(row, name)) for row in good]
    if xy:
        axes.plot(*zip(*xy), "-", color=series.color, lw=0.9, alpha=0.45, zorder=2)
        axes.plot(*zip(*xy), series.marker, color=series.color, ms=5, zorder=4, label=series.name)
    for row in good:
        spread = [row[COST + "_min"], row[COST + "_max"]]
        axes.plot(
            spread,
            [value_of(row, name)] * 2,
            color=series.color,
            lw=2.4,
            alpha=0.25,
            zorder=3,
            solid_capstyle="butt",
        )
    for row in bad:
        axes.plot(row[COST], value_of(row, name), "x", color=series.color, ms=8, mew=2, zorder=5)


def draw_front(axes, rows, name, joined=True):
    """Rings around the points of the front; joined where the picture is what it is the front of."""
    chosen = sorted((r for r in drawable(rows, name) if r["on_front"]), key=lambda row: row[COST])
    if chosen:
        xy = list(zip(*[(row[COST], value_of(row, name)) for row in chosen]))
        if joined:
            axes.plot(*xy, "-", color="0.15", lw=5, alpha=0.12, zorder=1, solid_joinstyle="round")
        axes.plot(
            *xy,
            "o",
            mfc="none",
            mec="0.15",
            mew=1.1,
            ms=9.5,
            zorder=3,
            label="front of the mean error",
        )


def draw_peers(axes, peers, column):
    """Grey, joined per method, each point with its setting. Returns labels for annotate()."""
    methods, labels = {}, []
    for peer in peers:
        if peer[column] is not None:
            methods.setdefault((peer["peer"], peer["method"]), []).append(peer)
    for number, ((name, method), points) in enumerate(methods.items()):
        points.sort(key=lambda peer: peer["us_per_particle_per_s"])
        xy = [(peer["us_per_particle_per_s"], peer[column]) for peer in points]
        axes.plot(
            *zip(*xy),
            "--" + MARKERS[number % len(MARKERS)],
            color="0.45",
            mfc="white",
            lw=0.9,
            ms=5,
            zorder=3,
            label=f"{name} {method}",
        )
        labels += [
            (x, y, p["setting"], {"fontsize": 7, "color": "0.35"}) for (x, y), p in zip(xy, points)
        ]
    return labels


def point_labels(along, all_series, name):
    labels = []
    for series in all_series:
        for row in drawable(series.rows, name):
            text = str(row.get(along, "")) if along else "as the scene has it"
            style = {"fontsize": 8, "color": series.color if row["status"] == "ok" else "#B00020"}
            if row["on_front"]:
                style["fontweight"] = "bold"
            labels.append((row[COST], value_of(row, name), text, style))
    return sorted(labels, key=lambda label: "fontweight" not in label[3])


def mark_unplaced(axes, rows, name):
    """Points without a place in the picture: crosses in the corner, and how many of what."""
    unplaced = [row for row in rows if row not in drawable(rows, name) and row["status"] != "ok"]
    crosses = any(row["status"] != "ok" for row in drawable(rows, name))
    if crosses:
        axes.plot([], [], "x", color="0.4", mew=2, ms=8, label="unstable")
    if unplaced:
        kinds = " or ".join(sorted({row["status"] for row in unplaced}))
        which = textwrap.shorten(
            "; ".join(row["point"] for row in unplaced), 90, placeholder=" ..."
        )
        axes.text(
            0.012,
            0.012,
            f"× {len(unplaced)} {kinds}: {which}",
            transform=axes.transAxes,
            fontsize=7,
            color="#B00020",
        )


def second_scale(axes, rows):
    """Seconds per simulated second along the top, where all points have as many particles."""
    counts = {row["particles"] for row in rows if COST in row}
    if len(counts) != 1:
        return
    count = counts.pop()
    scale = 1e-6 * count
    top = axes.secondary_xaxis("top", functions=(lambda x: x * scale, lambda s: s / scale))
    top.set_xlabel(f"run time per simulated second with {count:,} particles, s", color="0.3")
    axes.figure.canvas.draw()
    log_axis(top.xaxis)
    low, high = axes.get_xlim()
    if low < 1 / scale < high:
        axes.axvline(1 / scale, color="0.5", lw=0.8, ls=":", zorder=1)
        axes.text(
            1 / scale,
            0.99,
            " real time",
            transform=axes.get_xaxis_transform(),
            fontsize=7,
            color="0.4",
            va="top",
        )


def error_picture(path, rows, axes_keys, peers, title, xlabel=PER_PARTICLE[1], name="density_mean"):
    along, all_series = series_of(rows, axes_keys)
    figure, axes = pyplot.subplots(figsize=(8.6, 5.6), layout="constrained")
    axes.set_xscale("log")
    axes.set_yscale("log")
    for series in all_series:
        draw_series(axes, series, name)
    draw_front(axes, rows, name)
    labels = draw_peers(axes, peers, "mean_error_percent")
    mark_unplaced(axes, rows, name)
    axes.margins(0.09)
    axes.set_xlabel(xlabel)
    axes.set_ylabel(f"{face(name)[0]}, {face(name)[1]}")
    axes.set_title(f"{title}: error against run time", pad=10)
    axes.grid(which="major", color="0.92")
    axes.figure.canvas.draw()
    if drawable(rows, name):
        log_axis(axes.xaxis)
        log_axis(axes.yaxis)
        if xlabel == PER_PARTICLE[1]:
            second_scale(axes, rows)
    caption = f"labels: {words(along, '').strip()}" if along else None
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1), title=caption, alignment="left")
    annotate(axes, point_labels(along, all_series, name) + labels)
    figure.savefig(path)
    pyplot.close(figure)


def face_panel(axes, rows, along, all_series, peers, name):
    what, unit, _ = face(name)
    values = [value_of(row, name) for row in drawable(rows, name)]
    axes.set_xscale("log")
    if max(values) > 5 * min(values):
        axes.set_yscale("log")
    for series in all_series:
        draw_series(axes, series, name)
    draw_front(axes, rows, name, joined=False)
    if name == "density_max":
        draw_peers(axes, peers, "max_error_percent")
    axes.margins(0.12)
    axes.set_title(f"{what}, {unit}", fontsize=9)
    axes.grid(which="major", color="0.92")
    axes.figure.canvas.draw()
    log_axis(axes.xaxis, 1.7)
    if axes.get_yscale() == "log":
        log_axis(axes.yaxis, 1.7)
    annotate(
        axes, [label for label in point_labels(along, all_series, name) if "fontweight" in label[3]]
    )


def panels_of(rows):
    """Faces that have anything to draw; of the distances to the reference the latest."""
    apart = [name for row in rows for name in row if name.startswith("apart_spacings_at_")]
    names = [name if name != "apart" else apart[-1] if apart else "" for name in PANELS]
    return [name for name in names if len(drawable(rows, name)) > 0]


def faces_picture(path, rows, axes_keys, peers, title):
    names = panels_of(rows)
    if not names:
        return
    along, all_series = series_of(rows, axes_keys)
    columns = 2 if len(names) == 4 else min(3, len(names))
    lines = math.ceil(len(names) / columns)
    figure = pyplot.figure(figsize=(3.6 * columns, 1.1 + 2.7 * lines), layout="constrained")
    grid = figure.add_gridspec(lines + 1, columns, height_ratios=[2.7] * lines + [0.4])
    for number, name in enumerate(names):
        axes = figure.add_subplot(grid[divmod(number, columns)])
        face_panel(axes, rows, along, all_series, peers, name)
        if number + columns >= len(names):
            axes.set_xlabel(PER_PARTICLE[1], fontsize=8)
    strip = figure.add_subplot(grid[lines, :])
    strip.set_axis_off()
    strip.legend(
        *figure.axes[0].get_legend_handles_labels(), loc="upper center", ncols=4, fontsize=8
    )
    figure.suptitle(f"{title}: the other faces of the error", x=0.01, ha="left", fontweight="bold")
    figure.savefig(path)
    pyplot.close(figure)


def draw(folder, rows, axes_keys, peers, title, prefix=""):
    """Writes PREFIXerror.png and PREFIXfaces.png into the folder.

    Where points differ in their number of particles, the cost per particle hides what a scene
    costs: then PREFIXerror_run_time.png has that.
    """
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    per_particle = with_cost(rows, PER_PARTICLE[0])
    with pyplot.rc_context(STYLE):
        error_picture(folder / f"{prefix}error.png", per_particle, axes_keys, peers, title)
        faces_picture(folder / f"{prefix}faces.png", per_particle, axes_keys, peers, title)
        if len({row["particles"] for row in rows if "particles" in row}) > 1:
            error_picture(
                folder / f"{prefix}error_run_time.png",
                with_cost(rows, ABSOLUTE[0]),
                axes_keys,
                [],
                title,
                ABSOLUTE[1],
            )
