"""Picture of a study whose points differ in their number of particles: error and cost over it."""

from iib.common.plotting import pyplot
from iib.error_runtime.marks import COLORS, log_axis
from iib.error_runtime.plots import PER_PARTICLE, STYLE

QUALITIES = {"fast": 1.0, "balanced": 0.2, "accurate": 0.03}  # promised mean error, %


def series_of(rows, quality, value):
    """(particles, value) of one quality, ascending."""
    chosen = [row for row in rows if row.get("solver.quality") == quality and row["status"] == "ok"]
    return sorted((row["particles"], value(row)) for row in chosen)


def panel(axes, rows, value, what):
    for number, quality in enumerate(QUALITIES):
        points = series_of(rows, quality, value)
        if points:
            axes.plot(*zip(*points), "-o", color=COLORS[number], ms=5, label=quality)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("particles")
    axes.set_title(what, fontsize=9)
    axes.grid(which="major", color="0.92")
    axes.margins(0.09)


def draw_sizes(path, rows, title):
    """Writes the picture.

    rows: points of the study, with the column solver.quality
    """
    with pyplot.rc_context(STYLE):
        figure, (error, cost) = pyplot.subplots(1, 2, figsize=(8.6, 4.2), layout="constrained")
        panel(error, rows, lambda row: 100 * row["density_mean"], "mean density error, %")
        for number, promised in enumerate(QUALITIES.values()):
            error.axhline(promised, color=COLORS[number], ls=":", lw=1.2)
        error.plot([], [], ":", color="0.3", label="promised")
        error.legend(fontsize=8)
        panel(cost, rows, lambda row: row[PER_PARTICLE[0]], PER_PARTICLE[1])
        cost.set_ylim(bottom=50)
        for axes in (error, cost):
            figure.canvas.draw()
            log_axis(axes.xaxis)
            log_axis(axes.yaxis)
        figure.suptitle(title, x=0.01, ha="left", fontweight="bold")
        figure.savefig(path)
        pyplot.close(figure)
