"""What the suite prints."""

import math

from iib.stability import maps
from iib.stability.verdict import reason

DIGITS = 3


def number(value, scale=1.0, digits=DIGITS):
    """Nothing for what was not measured."""
    if value is None or math.isnan(value):
        return ""
    return f"{scale * value:.{digits}g}"


def case_text(line):
    """Of a case, for the terminal."""
    cost = f"{number(line.simulated_s)} s, {line.substeps} substeps, {number(line.wall_s)} s wall"
    head = f"{line.name}: {line.title} ({cost})"
    rows = [check.line(DIGITS) for check in line.checks]
    if not line.passed():
        rows += [f"        {command}" for command in line.commands]
    return "\n".join([head, *rows])


def long_text(line):
    rows = [f"  {what}: {number(first)} -> {number(last)}" for what, first, last in line.rows]
    rows += [check.line(DIGITS) for check in line.checks]
    lived = "" if line.lived else f"\n  FAIL  did not stay up: {line.command}"
    return (
        "\n".join([f"{line.name}: {line.steps} steps, {number(line.simulated_s)} s", *rows]) + lived
    )


def energy_text(line):
    return (
        f"{line.scene}, {line.substeps} substeps: risen by {number(line.total, 100)} %, "
        f"without the elastic part {number(line.mechanical, 100)} %"
    )


def map_text(one, points):
    counts = ", ".join(f"{count} {word}" for word, count in sorted(maps.counts(points).items()))
    wrong = [
        f"  FAIL  {p.verdict}: {reason(p.outcome)}\n        {p.outcome.reproduce()}"
        for p in points
        if not p.as_expected()
    ]
    return "\n".join([f"{one.name}: {counts}", *wrong])
