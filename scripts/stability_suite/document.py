"""What the suite prints, and the tables of doc/stability.md, made of stability.json."""

import math
import shutil

from error_runtime.machine import ROOT
from verification_checks import Check

from . import maps
from .results import kept
from .verdict import DEGRADED, REFUSED, STABLE, UNSTABLE, reason

DOCUMENT = ROOT / "doc" / "stability.md"
PICTURES = {"maps": "stability_maps.png", "long": "stability_long.png"}


def number(value, scale=1.0, digits=3):
    """Nothing for what was not measured."""
    if value is None or math.isnan(value):
        return ""
    return f"{scale * value:.{digits}g}"


def check_text(check):
    bound = f" {check.relation} {check.bound:g}" if check.relation else ""
    return f"{check.what}: {number(check.measured) or 'not measured'}{bound} {check.unit}".strip()


def told(line):
    """Of a case, for the terminal."""
    head = f"{line.name}: {line.title} ({number(line.simulated_s)} s, {line.substeps} substeps, {number(line.wall_s)} s wall)"
    words = {True: "pass", False: "FAIL"}
    rows = [f"  {words[c.passed()] if c.relation else '    '}  {check_text(c)}" for c in line.checks]
    if not line.passed():
        rows += [f"        {command}" for command in line.commands]
    return "\n".join([head, *rows])


def told_long(line):
    rows = [f"  {what}: {number(first)} -> {number(last)}" for what, first, last in line.rows]
    rows += [f"  {'pass' if c.passed() else 'FAIL'}  {check_text(c)}" for c in line.checks]
    lived = "" if line.lived else f"\n  FAIL  did not stay up: {line.command}"
    return "\n".join([f"{line.name}: {line.steps} steps, {number(line.simulated_s)} s", *rows]) + lived


def told_energy(line):
    return (f"{line.scene}, {line.substeps} substeps: risen by {number(line.total, 100)} %, "
            f"without the elastic part {number(line.mechanical, 100)} %")


def told_map(one, points):
    counts = ", ".join(f"{count} {word}" for word, count in sorted(maps.counts(points).items()))
    wrong = [f"  FAIL  {p.verdict}: {reason(p.outcome)}\n        {p.outcome.reproduce()}" for p in points
             if not p.as_expected()]
    return "\n".join([f"{one.name}: {counts}", *wrong])


def of_probes(probes):
    """Counts, and what another rule refuses within a range."""
    within = [probe for probe in probes if probe.inside and probe.verdict == REFUSED]
    return {
        "values": len(probes),
        "as expected": sum(probe.as_expected() for probe in probes),
        "outside and refused": sum(not p.inside and p.verdict == REFUSED for p in probes),
        "inside and run": sum(p.inside and p.verdict == "ran" for p in probes),
        "inside and refused": {f"{p.key} = {p.value}": p.outcome.message.split(".yaml: ")[-1] for p in within},
        "not as expected": {f"{p.key} = {p.value}": p.outcome.reproduce() for p in probes if not p.as_expected()},
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
    return {"title": one.title, "what": one.what, "across": one.across, "rows": rows, "not as expected": wrong}


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
    point = max(degraded, key=lambda p: (p.outcome.report["density_error_mean"], p.outcome.report["speed_limited"]))
    return f"at {point.value:.3g}: {reason(point.outcome)}"


def heading(*names):
    left = {"case", "what", "expected", "holds", "map", "row", "stable in", "degraded most", "run", "value", "why", "scene"}
    return ["| " + " | ".join(names) + " |", "|" + "|".join("---" if n in left else "---:" for n in names) + "|"]


def case_row(line):
    checks = [Check(**{**c, "measured": math.nan if c["measured"] is None else c["measured"],
                       "bound": math.nan if c["bound"] is None else c["bound"]}) for c in line["checks"]]
    told_checks = "; ".join(check_text(c) for c in checks if "stayed finite" not in c.what)
    lived = line["non_finite"] == 0 and line["escaped"] == 0
    ran = line["particles"] > 0 or line["substeps"] > 0
    cells = [
        line["number"] or "", f"{line['title']}: **{line['expected']}**",
        ("yes" if lived else "**no**") if ran else "", f"{line['particles']:,}" if ran else "",
        number(line["fastest_m_s"]), number(line["density_error_mean"], 100), number(line["energy_rise"], 100),
        number(line["simulated_s"]) if ran else "", f"{line['substeps']:,}" if ran else "",
        number(line["wall_s"]) if ran else "", told_checks,
        "yes" if all(c.passed() for c in checks) else "**no**",
    ]
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def case_table(lines):
    rows = heading("case", "what", "finite, inside", "particles", "fastest m/s", "density error %", "energy risen %",
                   "simulated s", "substeps", "wall s", "bounds", "holds")
    ordered = sorted(lines.values(), key=lambda line: (line["number"] or 100, line["name"].casefold()))
    return "\n".join([*rows, *map(case_row, ordered)])


def boundary_table(found):
    text = (f"{found['values']} values beside the ends of every range: {found['as expected']} as expected, "
            f"{found['outside and refused']} outside and refused by name, {found['inside and run']} inside and run.")
    rows = [f"| {key} | {why} |" for key, why in found["inside and refused"].items()]
    text += "\n\nWithin a range and refused by another rule, which names the key:\n\n"
    text += "\n".join([*heading("value", "why"), *rows])
    wrong = "\n".join(f"- **{key}**: `{how}`" for key, how in found["not as expected"].items())
    return text + (f"\n\nNot as expected:\n\n{wrong}" if wrong else "")


def map_table(found):
    rows = heading("map", "row", STABLE, DEGRADED, REFUSED, UNSTABLE, "stable in", "degraded most")
    for one in found.values():
        for name, row in one["rows"].items():
            counts = " | ".join(str(row.get(word, 0)) for word in (STABLE, DEGRADED, REFUSED, UNSTABLE))
            rows.append(f"| {one['title']}, {one['what']} | {name} | {counts} | {row['stable in']} | {row['degraded by']} |")
    wrong = [f"- {why}: `{how}`" for one in found.values() for why, how in one["not as expected"]]
    return "\n".join(rows + (["", "Not as expected:", "", *wrong] if wrong else []))


def energy_table(lines):
    """A row per scene, a pair of columns per number of substeps."""
    counts = sorted({line["substeps"] for line in lines.values()})
    rows = heading("scene", *(f"{n} substeps, {what}" for n in counts for what in ("total", "without elastic")))
    for scene in dict.fromkeys(line["scene"] for line in lines.values()):
        found = [lines[f"{scene} {n}"] for n in counts]
        cells = [number(line[what], 100) + " %" for line in found for what in ("total", "mechanical")]
        rows.append(f"| {scene} | {' | '.join(cells)} |")
    return "\n".join(rows)


def long_table(lines):
    rows = heading("run", "what", "first tenth", "last tenth")
    for line in lines.values():
        title = f"{line['title']}, {line['steps']:,} steps, {number(line['simulated_s'])} s"
        rows += [f"| {title} | {what} | {number(first, digits=4)} | {number(last, digits=4)} |"
                 for what, first, last in line["rows"]]
    return "\n".join([*rows, "", "![The long runs over time](images/stability_long.png)"])


TABLES = {
    "cases": case_table,
    "boundaries": boundary_table,
    "maps": map_table,
    "energy": energy_table,
    "long": long_table,
}


def write(folders):
    """Replaces what stands between the markers of each part that a folder holds; of several, by the last that does."""
    text, pictures = DOCUMENT.read_text(), {}
    for folder in folders:
        for part, found in kept(folder).items():
            begin, end = f"<!-- {part} -->", f"<!-- end of {part} -->"
            head, tail = text.split(begin)[0], text.split(end)[1]
            made = f"At commit {found['commit']} on {found['processor']}, {found['date']}:"
            text = f"{head}{begin}\n{made}\n\n{TABLES[part](found['lines'])}\n{end}{tail}"
            if (folder / PICTURES.get(part, "")).is_file():
                pictures[part] = folder / PICTURES[part]
    DOCUMENT.write_text(text)
    print(f"wrote {DOCUMENT}")
    for part, picture in pictures.items():
        shutil.copy(picture, DOCUMENT.parent / "images" / PICTURES[part])
        print(f"wrote {DOCUMENT.parent / 'images' / PICTURES[part]}")
