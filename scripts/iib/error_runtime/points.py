"""Rows of the table: one per point, with the median and the spread over its runs."""

import statistics

from iib.error_runtime.grid import identity
from iib.error_runtime.pareto import front

# Metrics of the error that come before the others, if the scene has them.
FIRST_METRICS = ["density_mean", "density_max"]

# Metrics of which the report keeps the value outside of "error".
SPEEDS = ["rms_speed_m_s", "residual_speed_m_s", "max_speed_m_s"]


def spread(row, name, values):
    row[name] = statistics.median(values)
    row[name + "_min"] = min(values)
    row[name + "_max"] = max(values)


def in_force(report, key):
    """Value of a dotted key, or of an option, in the settings that the run had."""
    value = report.get("settings", {})
    for part in key.split("."):
        value = value.get(part) if isinstance(value, dict) else None
    return report.get(key, "") if value is None else value


def row_of(runs, axes):
    """runs: those of one point; axes: every key that any point of the campaign sets."""
    run = runs[-1]
    report = run.get("report", {})
    row = {"point": identity(run["point"]), "status": worst_status(runs), "message": run["message"]}
    for key in axes:
        row[key] = run["point"].get(key, in_force(report, key))
    row["repeats"] = len(runs)
    timed = [r["report"] for r in runs if r.get("report", {}).get("simulated_time_s", 0) > 0]
    if not timed:
        return row
    row["particles"] = report["particles"]
    per_s = [r["wall_time_s"] / r["simulated_time_s"] for r in timed]
    spread(row, "wall_s_per_s", per_s)
    if report["particles"] > 0:
        spread(row, "us_per_particle_per_s", [1e6 * s / report["particles"] for s in per_s])
    metrics = report.get("error", {})
    for name in FIRST_METRICS + [name for name in metrics if name not in FIRST_METRICS]:
        if name in metrics:
            row[name] = metrics[name]
    row.update(run_metrics(runs))
    for name in SPEEDS:
        row[name] = report[name]
    row["state_hash"] = report["state_hash"]
    return row


def run_metrics(runs):
    """Metrics that this program itself found, as the distance to the reference."""
    metrics = {}
    for run in runs:
        metrics.update(run.get("metrics", {}))
    return metrics


def worst_status(runs):
    """A point that failed once is not a point to take."""
    statuses = [run["status"] for run in runs]
    for status in ("refused", "crashed", "stopped", "unstable"):
        if status in statuses:
            return status
    return "ok"


def axes_of(runs):
    """Every key that some point sets, in the order in which they came."""
    return list(dict.fromkeys(key for run in runs for key in run["point"]))


def mark_front(rows, cost="us_per_particle_per_s", error="density_mean"):
    """Sets on_front of every row: 1 on the Pareto front of the stable points."""
    judged = [
        (row[cost], row[error]) if row["status"] == "ok" and cost in row and error in row else None
        for row in rows
    ]
    chosen = set(front(judged))
    for k, row in enumerate(rows):
        row["on_front"] = int(k in chosen)


def table(runs):
    """Rows in the order in which points were first run."""
    by_point = {}
    for run in runs:
        by_point.setdefault(identity(run["point"]), []).append(run)
    rows = [row_of(group, axes_of(runs)) for group in by_point.values()]
    mark_front(rows)
    return rows
