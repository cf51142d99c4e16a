"""The table of doc/verification.md, and its pictures."""

from iib.common import markdown
from iib.common.checks import number
from iib.common.machine import commit, processor
from iib.common.paths import DOC, IMAGES
from iib.verification import pictures


def row(name, check):
    measured = f"{number(check.measured)} {check.unit}".strip()
    if not check.relation:
        return [name, measured, "", "", check.what]
    sign = "≤" if check.relation == "<=" else "≥"
    bound = f"{sign} {check.bound:g} {check.unit}".strip()
    return [name, measured, bound, "yes" if check.passed() else "**no**", check.what]


def table(results):
    rows = [row(name, check) for name, checks in results.items() for check in checks]
    return markdown.table(
        ["case", "measured", "bound", "holds", "what"], rows, left=["case", "holds", "what"]
    )


def write(results, runner):
    made = f"`scripts/verify --document` at commit {commit()} on {processor()}:"
    markdown.write_part(DOC / "verification.md", "figures", f"{made}\n\n{table(results)}")
    pictures.draw(runner, IMAGES)
