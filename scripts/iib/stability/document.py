"""The tables of doc/stability.md, made of stability.json."""

import math
import shutil

from iib.common import markdown
from iib.common.checks import Check
from iib.common.paths import DOC, IMAGES
from iib.stability.printed import DIGITS, number
from iib.stability.results import kept
from iib.stability.verdict import DEGRADED, REFUSED, STABLE, UNSTABLE

DOCUMENT = DOC / "stability.md"
# Columns of text, in every table.
LEFT = {
    "case",
    "what",
    "expected",
    "holds",
    "map",
    "row",
    "stable in",
    "most degraded",
    "run",
    "value",
    "why",
    "scene",
}
PICTURES = {"maps": "stability_maps.png", "long": "stability_long.png"}


def case_row(line):
    checks = [
        Check(
            **{
                **c,
                "measured": math.nan if c["measured"] is None else c["measured"],
                "bound": math.nan if c["bound"] is None else c["bound"],
            }
        )
        for c in line["checks"]
    ]
    bounds = "; ".join(c.text(DIGITS) for c in checks if "stayed finite" not in c.what)
    lived = line["non_finite"] == 0 and line["escaped"] == 0
    ran = line["particles"] > 0 or line["substeps"] > 0
    return [
        line["number"] or "",
        f"{line['title']}: **{line['expected']}**",
        ("yes" if lived else "**no**") if ran else "",
        f"{line['particles']:,}" if ran else "",
        number(line["fastest_m_s"]),
        number(line["density_error_mean"], 100),
        number(line["energy_rise"], 100),
        number(line["simulated_s"]) if ran else "",
        f"{line['substeps']:,}" if ran else "",
        number(line["wall_s"]) if ran else "",
        bounds,
        "yes" if all(c.passed() for c in checks) else "**no**",
    ]


def case_table(lines):
    names = (
        "case",
        "what",
        "finite, inside",
        "particles",
        "max speed m/s",
        "density error %",
        "energy risen %",
        "simulated s",
        "substeps",
        "wall s",
        "bounds",
        "holds",
    )
    ordered = sorted(
        lines.values(), key=lambda line: (line["number"] or 100, line["name"].casefold())
    )
    return markdown.table(names, map(case_row, ordered), LEFT)


def boundary_table(found):
    text = (
        f"{found['values']} values at the ends of every range: "
        f"{found['as expected']} as expected, "
        f"{found['outside and refused']} outside and refused by name, "
        f"{found['inside and run']} inside and run."
    )
    text += "\n\nValues within their range that another rule refuses by key:\n\n"
    text += markdown.table(("value", "why"), found["inside and refused"].items(), LEFT)
    wrong = "\n".join(f"- **{key}**: `{how}`" for key, how in found["not as expected"].items())
    return text + (f"\n\nNot as expected:\n\n{wrong}" if wrong else "")


def map_table(found):
    words = (STABLE, DEGRADED, REFUSED, UNSTABLE)
    rows = []
    for one in found.values():
        for name, row in one["rows"].items():
            counts = (row.get(word, 0) for word in words)
            title = f"{one['title']}, {one['what']}"
            rows.append([title, name, *counts, row["stable in"], row["degraded by"]])
    text = markdown.table(["map", "row", *words, "stable in", "most degraded"], rows, LEFT)
    wrong = [f"- {why}: `{how}`" for one in found.values() for why, how in one["not as expected"]]
    return "\n".join([text, "", "Not as expected:", "", *wrong] if wrong else [text])


def energy_table(lines):
    """A row per scene, a pair of columns per number of substeps."""
    counts = sorted({line["substeps"] for line in lines.values()})
    names = (f"{n} substeps, {what}" for n in counts for what in ("total", "without elastic"))
    rows = []
    for scene in dict.fromkeys(line["scene"] for line in lines.values()):
        found = [lines[f"{scene} {n}"] for n in counts]
        cells = [
            number(line[what], 100) + " %" for line in found for what in ("total", "mechanical")
        ]
        rows.append([scene, *cells])
    return markdown.table(["scene", *names], rows, LEFT)


def long_table(lines):
    rows = []
    for line in lines.values():
        title = f"{line['title']}, {line['steps']:,} steps, {number(line['simulated_s'])} s"
        rows += [
            [title, what, number(first, digits=4), number(last, digits=4)]
            for what, first, last in line["rows"]
        ]
    table = markdown.table(("run", "what", "first tenth", "last tenth"), rows, LEFT)
    return "\n".join([table, "", "![The long runs over time](images/stability_long.png)"])


TABLES = {
    "cases": case_table,
    "boundaries": boundary_table,
    "maps": map_table,
    "energy": energy_table,
    "long": long_table,
}


def write(folders):
    """Replaces every part that a folder holds; the last folder counts."""
    text, pictures = DOCUMENT.read_text(), {}
    for folder in folders:
        for part, found in kept(folder).items():
            made = f"At commit {found['commit']} on {found['processor']}, {found['date']}:"
            text = markdown.with_part(text, part, f"{made}\n\n{TABLES[part](found['lines'])}")
            if (folder / PICTURES.get(part, "")).is_file():
                pictures[part] = folder / PICTURES[part]
    DOCUMENT.write_text(text)
    print(f"wrote {DOCUMENT}")
    for part, picture in pictures.items():
        shutil.copy(picture, IMAGES / PICTURES[part])
        print(f"wrote {IMAGES / PICTURES[part]}")
