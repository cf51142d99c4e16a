"""Pictures of a campaign: error.png, and metrics.png with the other metrics of the error."""

import math
import pathlib

from iib.common.plotting import pyplot
from iib.error_runtime.labels import annotate
from iib.error_runtime.marks import (
    draw_front,
    draw_peers,
    draw_series,
    drawable,
    log_axis,
    mark_unplaced,
    point_labels,
    second_scale,
    series_of,
    value_of,
    with_cost,
)
from iib.error_runtime.naming import metric, words

# Columns of the cost.
PER_PARTICLE = ("us_per_particle_per_s", "µs per particle and simulated second")
ABSOLUTE = ("wall_s_per_s", "run time per simulated second, s")

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

# Metrics worth a panel, in this order, where the scene has them.
PANELS = """density_max column_height_lost front_error energy_rise volume_lost apart
residual_speed_m_s ice_drift_spacings ice_residual_speed_m_s""".split()


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
    axes.set_ylabel(f"{metric(name)[0]}, {metric(name)[1]}")
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


def metric_panel(axes, rows, along, all_series, peers, name):
    what, unit, _ = metric(name)
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
    """Metrics that have anything to draw; of the distances to the reference the latest."""
    apart = [name for row in rows for name in row if name.startswith("apart_spacings_at_")]
    names = [name if name != "apart" else apart[-1] if apart else "" for name in PANELS]
    return [name for name in names if len(drawable(rows, name)) > 0]


def metrics_picture(path, rows, axes_keys, peers, title):
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
        metric_panel(axes, rows, along, all_series, peers, name)
        if number + columns >= len(names):
            axes.set_xlabel(PER_PARTICLE[1], fontsize=8)
    strip = figure.add_subplot(grid[lines, :])
    strip.set_axis_off()
    strip.legend(
        *figure.axes[0].get_legend_handles_labels(), loc="upper center", ncols=4, fontsize=8
    )
    figure.suptitle(f"{title}: other metrics of the error", x=0.01, ha="left", fontweight="bold")
    figure.savefig(path)
    pyplot.close(figure)


def draw(folder, rows, axes_keys, peers, title, prefix=""):
    """Writes PREFIXerror.png and PREFIXmetrics.png into the folder.

    Where points differ in their number of particles, the cost per particle hides what a scene
    costs: then PREFIXerror_run_time.png has that.
    """
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    per_particle = with_cost(rows, PER_PARTICLE[0])
    with pyplot.rc_context(STYLE):
        error_picture(folder / f"{prefix}error.png", per_particle, axes_keys, peers, title)
        metrics_picture(folder / f"{prefix}metrics.png", per_particle, axes_keys, peers, title)
        if len({row["particles"] for row in rows if "particles" in row}) > 1:
            error_picture(
                folder / f"{prefix}error_run_time.png",
                with_cost(rows, ABSOLUTE[0]),
                axes_keys,
                [],
                title,
                ABSOLUTE[1],
            )
