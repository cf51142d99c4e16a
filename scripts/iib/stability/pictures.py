"""Pictures of doc/stability.md. Needs matplotlib."""

import math

from iib.stability.long_runs import SETTLED, curves
from iib.stability.verdict import DEGRADED, REFUSED, STABLE, UNSTABLE

LOOKS = {
    STABLE: {"facecolor": "#3a9d6a", "edgecolor": "white"},
    DEGRADED: {"facecolor": "#efb73e", "edgecolor": "white"},
    REFUSED: {"facecolor": "#e6e8eb", "hatch": "//////", "edgecolor": "#b4b8be"},
    UNSTABLE: {"facecolor": "#b3001b", "edgecolor": "white"},
}
HEIGHT = 0.72  # of a row of cells, of the distance between rows
STYLE = {
    "font.size": 9.5,
    "axes.titlesize": 11,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.spines.left": False,
    "hatch.linewidth": 0.5,
}


def cells(values):
    """Where the cell of each value begins and ends: half way, in decades, to those beside it."""
    logs = [math.log10(value) for value in values]
    inner = [(low + high) / 2 for low, high in zip(logs, logs[1:])]
    borders = [10**log for log in (2 * logs[0] - inner[0], *inner, 2 * logs[-1] - inner[-1])]
    return list(zip(borders, borders[1:]))


def panel(place, one):
    """one: of stability.json, as summary.of_map made it."""
    for k, row in enumerate(one["rows"].values()):
        for (low, high), (_, verdict) in zip(
            cells([value for value, _ in row["points"]]), row["points"]
        ):
            # A point a hair beside an end has a cell too thin for a border.
            place.barh(
                k,
                high - low,
                left=low,
                height=HEIGHT,
                linewidth=0.6 if high > 1.01 * low else 0,
                **LOOKS[verdict],
            )
        for end in row["range"]:
            if end > 0:
                place.plot(
                    [end, end], [k - 0.48, k + 0.48], color="black", lw=1.6, solid_capstyle="butt"
                )
        if row["usual"]:
            place.plot(
                row["usual"], k, marker="o", color="white", markeredgecolor="black", markersize=4.5
            )
    count = len(one["rows"])
    first, *_, last = (value for value, _ in next(iter(one["rows"].values()))["points"])
    place.set(
        xscale="log",
        title=one["title"],
        xlabel=one["what"],
        ylabel=one["across"],
        ylim=(-0.6, count - 0.4),
        xlim=(first / 1.6, last * 1.6),
    )
    place.set_yticks(range(count), one["rows"])
    place.tick_params(left=False)


def legend(drawing):
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    keys = [Patch(label=word, **look) for word, look in LOOKS.items()]
    keys += [
        Line2D(
            [],
            [],
            color="black",
            marker="|",
            ls="",
            markersize=12,
            markeredgewidth=1.6,
            label="end of the range",
        ),
        Line2D(
            [],
            [],
            color="white",
            marker="o",
            markeredgecolor="black",
            ls="",
            markersize=6,
            label="default",
        ),
    ]
    drawing.legend(handles=keys, loc="upper center", ncols=len(keys), frameon=False, fontsize=11)


def draw_maps(maps, path):
    from iib.common.plotting import pyplot

    tallest = [max(len(one["rows"]) for one in maps[k : k + 2]) for k in range(0, len(maps), 2)]
    heights = [1.15 + 0.27 * rows for rows in tallest]
    with pyplot.rc_context(STYLE):
        drawing, places = pyplot.subplots(
            len(tallest),
            2,
            figsize=(13, sum(heights) + 0.5),
            height_ratios=heights,
            layout="constrained",
            squeeze=False,
        )
        for place in places.flat[len(maps) :]:
            place.axis("off")
        for place, one in zip(places.flat, maps):
            panel(place, one)
        drawing.suptitle(" ", fontsize=16)  # room for the legend
        legend(drawing)
        drawing.savefig(path, dpi=100)
    pyplot.close(drawing)


def draw_long(runs, path):
    """runs: of each long run its description and its outcome."""
    from iib.common.plotting import pyplot

    drawn = [(one, *curves(one, outcome)) for one, outcome in runs if outcome.survived()]
    if not drawn:
        return
    columns = max(len(over_time) for _, _, over_time in drawn)
    drawing, places = pyplot.subplots(
        columns,
        len(drawn),
        figsize=(5 * len(drawn), 1.3 * columns),
        squeeze=False,
        sharex="col",
        constrained_layout=True,
    )
    for column, (one, time, over_time) in enumerate(drawn):
        for place in places[len(over_time) :, column]:
            place.axis("off")
        for place, (name, values) in zip(places[:, column], over_time.items()):
            begin = int(SETTLED * len(time))
            place.plot(time[begin:] / 3600, values[begin:], lw=0.6)
            place.set_title(name, fontsize=8)
        places[0, column].set_title(f"{one.title}: {next(iter(over_time))}", fontsize=8)
        places[len(over_time) - 1, column].set_xlabel("simulated hours")
        places[len(over_time) - 1, column].tick_params(labelbottom=True)
    drawing.savefig(path, dpi=100)
    pyplot.close(drawing)
