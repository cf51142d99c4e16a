"""The command line of scripts/verify."""

import dataclasses
import json
import pathlib
import time

from iib.common.command_line import Parser, exit_code
from iib.common.progress import Progress
from iib.common.refusal import Refusal
from iib.common.run_scene import find_run_scene
from iib.verification import document
from iib.verification.cases import CASES
from iib.verification.runs import Runner

# Each of them adds its cases to CASES.
from iib.verification import (  # noqa: F401
    cases_dams,
    cases_heat,
    cases_ice,
    cases_rest,
    cases_water,
)

DESCRIPTION = """Runs the cases with known answers and compares what comes out with bounds.

Each line states what was measured, the bound, and whether it holds; a line without a bound is for
information. Scenes: config/scenes/verification; meaning, pictures and the latest figures:
doc/verification.md.

Examples:
  scripts/verify                    # all, also the two that take a minute of simulated rest
  scripts/verify --fast             # without those two
  scripts/verify --case elliptical_patch --case sloshing
  scripts/verify --fast --set solver.substeps=16 --set solver.iterations=2
  scripts/verify --list
  scripts/verify --document         # writes the table of doc/verification.md, and its pictures

Exit code: 0 all bounds hold, 1 bad input or a run that failed, 2 a bound does not hold.
"""


def parser():
    p = Parser("scripts/verify", DESCRIPTION)
    p.add_argument(
        "--case", action="append", metavar="NAME", help="only this case; may be given several times"
    )
    p.add_argument(
        "--fast", action="store_true", help="leave out the cases of a minute of simulated time"
    )
    p.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="KEY=VALUE",
        help="any key of config/default.yaml",
    )
    p.add_argument("--preset", help="default or paper, for every scene")
    p.add_argument("--quality", help="passed on to run_scene")
    p.add_argument("--threads", type=int, default=0, help="0: all of the machine's")
    p.add_run_scene()
    p.add_argument("--json", metavar="FILE", help="write every figure to this file")
    p.add_argument(
        "--document",
        action="store_true",
        help="write the table of doc/verification.md, and the pictures",
    )
    p.add_argument("--list", action="store_true", help="print the cases and what they show")
    return p


def chosen(args):
    if not args.case:
        return [case for case in CASES.values() if not (args.fast and case.long)]
    for name in args.case:
        if name not in CASES:
            raise Refusal(f"no case {name}; there are: {', '.join(CASES)}")
    return [CASES[name] for name in args.case]


def measure(runner, cases):
    """Checks by case, printed as they come."""
    results, bar = {}, Progress([case.name for case in cases])
    for case in cases:
        start = time.monotonic()
        with bar.run(case.name):
            results[case.name] = case.measure(runner)
        bar.close()
        print(f"{case.name}: {case.meaning} ({time.monotonic() - start:.1f} s)")
        for check in results[case.name]:
            print(check.line(), flush=True)
    return results


def write_json(path, results):
    figures = {
        name: [{**dataclasses.asdict(check), "passed": check.passed()} for check in checks]
        for name, checks in results.items()
    }
    pathlib.Path(path).write_text(json.dumps(figures, indent=2) + "\n")


def run(words):
    args = parser().parse_args(words)
    cases = chosen(args)
    if args.list:
        for case in cases:
            print(f"{case.name:28}{case.meaning}{' (long)' if case.long else ''}")
        return 0
    program = find_run_scene(args.run_scene)
    options = {"threads": args.threads, "preset": args.preset, "quality": args.quality}
    runner = Runner(program, args.set, **options)
    results = measure(runner, cases)
    if args.json:
        write_json(args.json, results)
    if args.document:
        document.write(results, runner)
    bounds = [check for checks in results.values() for check in checks if check.relation]
    failed = sum(not check.passed() for check in bounds)
    print(
        f"{len(bounds) - failed} of {len(bounds)} bounds hold"
        + (f", {failed} do not" if failed else "")
    )
    return 2 if failed else 0


def main():
    return exit_code("scripts/verify", run)
