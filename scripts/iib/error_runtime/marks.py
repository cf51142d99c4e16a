"""What the pictures of a campaign are drawn with: series, fronts, peers, labels, scales."""

import math
import textwrap

from matplotlib import ticker

from iib.error_runtime.naming import main_axis, metric, sort_key, varying, words
from iib.error_runtime.points import mark_front

# Column along x: a copy of another one, put there by with_cost().
COST = "cost"

# Okabe and Ito: told apart by everybody.
COLORS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#8A7A00"]
MARKERS = "osD^vP*X"


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
    """A metric in the unit in which it is drawn; None where the row has none."""
    value = row.get(name, "")
    if value in ("", None) or not math.isfinite(value):
        return None
    return abs(value) * metric(name)[2]


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
