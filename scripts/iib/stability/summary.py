"""What stability.json holds of the probes and the maps."""

from iib.stability import maps
from iib.stability.verdict import DEGRADED, REFUSED, STABLE, reason


def of_probes(probes):
    """Counts, and what another rule refuses within a range."""
    within = [probe for probe in probes if probe.inside and probe.verdict == REFUSED]
    return {
        "values": len(probes),
        "as expected": sum(probe.as_expected() for probe in probes),
        "outside and refused": sum(not p.inside and p.verdict == REFUSED for p in probes),
        "inside and run": sum(p.inside and p.verdict == "ran" for p in probes),
        "inside and refused": {
            f"{p.key} = {p.value}": p.outcome.message.split(".yaml: ")[-1] for p in within
        },
        "not as expected": {
            f"{p.key} = {p.value}": p.outcome.reproduce() for p in probes if not p.as_expected()
        },
    }


def of_map(one, points, ranges):
    rows = {}
    for row in one.rows:
        own = [point for point in points if point.row == row.name]
        rows[row.name] = {
            **maps.counts(own),
            "stable in": stretches(own),
            "degraded by": worst(own),
            "range": list(row.range(ranges)),
            "usual": row.usual(ranges),
            "points": [[point.value, point.verdict] for point in own],
        }
    wrong = [[reason(p.outcome), p.outcome.reproduce()] for p in points if not p.as_expected()]
    return {
        "title": one.title,
        "what": one.what,
        "across": one.across,
        "rows": rows,
        "not as expected": wrong,
    }


def stretches(points):
    """Values between which every point is stable, as text."""
    found, begin, last = [], None, None
    for point in [*sorted(points, key=lambda p: p.value), None]:
        good = point is not None and point.verdict == STABLE
        if good and begin is None:
            begin = point.value
        if not good and begin is not None:
            found.append(f"{begin:.3g} … {last:.3g}" if last != begin else f"{begin:.3g}")
            begin = None
        last = point.value if point is not None else None
    return ", ".join(found)


def worst(points):
    degraded = [point for point in points if point.verdict == DEGRADED]
    if not degraded:
        return ""
    point = max(
        degraded,
        key=lambda p: (p.outcome.report["density_error_mean"], p.outcome.report["speed_limited"]),
    )
    return f"at {point.value:.3g}: {reason(point.outcome)}"
