"""Pictures of doc/stability.md. Needs matplotlib."""

from .verdict import DEGRADED, REFUSED, STABLE, UNSTABLE

LOOKS = {
    STABLE: {"color": "#2a9d5c", "marker": "s", "s": 16},
    DEGRADED: {"color": "#e9b44c", "marker": "s", "s": 16},
    REFUSED: {"color": "#9aa0a8", "marker": "x", "s": 12, "linewidths": 0.8},
    UNSTABLE: {"color": "#c1121f", "marker": "X", "s": 60},
}


def plotting():
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    return pyplot


def panel(place, one):
    """one: of stability.json, as document.of_map made it."""
    for k, row in enumerate(one["rows"].values()):
        for word, look in LOOKS.items():
            chosen = [value for value, verdict in row["points"] if verdict == word]
            place.scatter(chosen, [k] * len(chosen), label=word if k == 0 else None, **look)
        for end in row["range"]:
            if end > 0:
                place.plot([end, end], [k - 0.45, k + 0.45], color="black", lw=0.8)
    count = len(one["rows"])
    place.set(xscale="log", title=one["title"], xlabel=one["what"], ylabel=one["across"], ylim=(-0.6, count - 0.4))
    place.set_yticks(range(count), one["rows"], fontsize=7)


def draw_maps(maps, path):
    pyplot = plotting()
    rows = (len(maps) + 1) // 2
    drawing, places = pyplot.subplots(rows, 2, figsize=(11, 1.9 * rows), constrained_layout=True, squeeze=False)
    for place in places.flat[len(maps):]:
        place.axis("off")
    for place, one in zip(places.flat, maps):
        panel(place, one)
    drawing.suptitle(" ")  # room for the legend
    drawing.legend(*places.flat[0].get_legend_handles_labels(), loc="upper center", ncols=4, frameon=False)
    drawing.savefig(path, dpi=100)
    pyplot.close(drawing)


def draw_long(runs, path):
    """runs: of each long run its description and its outcome."""
    from .long_runs import SETTLED, faces

    pyplot = plotting()
    told = [(one, *faces(one, outcome)) for one, outcome in runs if outcome.survived()]
    if not told:
        return
    columns = max(len(over_time) for _, _, over_time in told)
    drawing, places = pyplot.subplots(columns, len(told), figsize=(5 * len(told), 1.3 * columns), squeeze=False,
                                      sharex="col", constrained_layout=True)
    for column, (one, time, over_time) in enumerate(told):
        for place in places[len(over_time):, column]:
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
