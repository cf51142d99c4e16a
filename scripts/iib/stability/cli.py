"""The command line of scripts/stability."""

import concurrent.futures
import dataclasses
import itertools
import pathlib

from iib.common.command_line import Parser, exit_code
from iib.common.machine import about
from iib.common.paths import ROOT
from iib.common.progress import Progress
from iib.common.refusal import Refusal
from iib.common.run_scene import find_run_scene
from iib.stability import boundaries, cases, commands, document, energy, long_runs, maps, pictures
from iib.stability import printed, summary
from iib.stability import cases_ice, cases_starts, cases_water  # noqa: F401  (fill CASES)
from iib.stability.map_list import MAPS
from iib.stability.ranges import ranges
from iib.stability.results import Results
from iib.stability.runs import Runner

DESCRIPTION = """Drives water, ice and steam to extremes and holds what comes of it to bounds.

Cases, each with what is expected of it; maps, in which a key is swept over decades across the ends
of its range; the ends of every range; the energy of shipped scenes; long runs of a million steps.
Meaning and figures: doc/stability.md.

Examples:
  scripts/stability                          # all but the long runs
  scripts/stability --case gap_below_a_particle --case GravityThatFlipsEveryFrame
  scripts/stability --map viscosity          # one map, and its picture in the folder --out
  scripts/stability --boundaries             # just inside and just outside the range of every key
  scripts/stability --energy                 # shipped scenes at 2, 8 and 24 substeps
  scripts/stability --long                   # a million steps of two scenes at rest: half an hour
  scripts/stability --long --steps 10000     # the same in half a minute
  scripts/stability --list
  scripts/stability --document               # all but the long runs, and doc/stability.md
  scripts/stability --write out/stability /tmp/long  # runs nothing: doc/stability.md

What is finished is kept in --out and not run again by the same program: a suite that was stopped
goes on.

Exit code: 0 all as expected, 1 bad input, 2 something is not as expected, 130 stopped before the
end.
"""
LONGEST_CASE_S, LONGEST_RUN_S = 900.0, 7 * 24 * 3600.0


class Suite:
    def __init__(self, args):
        self.program = find_run_scene(args.run_scene)
        self.out = pathlib.Path(args.out)
        try:
            self.out.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise Refusal(
                f"--out {self.out} cannot be written: {error.strerror}; name another folder"
            )
        self.args, self.ranges = args, ranges(self.program)
        self.pool = concurrent.futures.ThreadPoolExecutor(args.jobs)
        self.results = Results(self.out, about(self.program, "scripts/stability --document"))

    def run(self, wanted):
        parts = {
            "cases": self.run_cases,
            "boundaries": self.run_boundaries,
            "maps": self.run_maps,
            "energy": self.run_energy,
            "long": self.run_long,
        }
        return [part(wanted[name]) for name, part in parts.items() if wanted.get(name)]

    def runner(self, timeout_s=LONGEST_CASE_S):
        return Runner(self.program, self.out, timeout_s)

    def run_cases(self, names):
        known = [cases.CASES[name] for name in names if name in cases.CASES]
        others = [name for name in names if name not in cases.CASES]
        bar, runner = (
            Progress([one.name for one in known] + ["commands"] * bool(others)),
            self.runner(),
        )

        def measure(one):
            line = cases.measure(one, runner)
            bar.end(one.name, line.wall_s)
            return line

        lines = []
        for line in itertools.chain(self.pool.map(measure, known), self.run_commands(others, bar)):
            bar.close()
            print(printed.case_text(line), flush=True)
            lines.append(line)
        self.results.put("cases", {line.name: dataclasses.asdict(line) for line in lines})
        return all(line.passed() for line in lines)

    def run_commands(self, names, bar):
        if not names:
            return
        program = commands.find_program(self.program, self.args.commands)
        bar.begin("commands")
        yield from commands.measure(program, self.out, names)
        bar.end("commands", 0.0)

    def run_boundaries(self, _):
        bar = Progress(["boundaries"] * len(boundaries.probes(self.ranges)))
        probes = boundaries.measure(self.ranges, self.runner(), self.pool, bar)
        bar.close()
        wrong = [probe for probe in probes if not probe.as_expected()]
        for probe in wrong:
            print(f"FAIL  {probe.key} = {probe.value}: {probe.verdict}, {probe.outcome.message}")
            print(f"      {probe.outcome.reproduce()}")
        print(
            f"{len(probes) - len(wrong)} of {len(probes)} values beside the ends of "
            f"{len(self.ranges)} ranges as expected"
        )
        self.results.put("boundaries", summary.of_probes(probes))
        return not wrong

    def run_maps(self, names):
        chosen = [MAPS[name] for name in names]
        bar = Progress([one.name for one in chosen for _ in maps.places(one, self.ranges)])
        runner = self.runner()
        found = {}
        for one in chosen:
            points = found[one.name] = maps.measure(one, self.ranges, runner, self.pool, bar)
            bar.close()
            print(printed.map_text(one, points), flush=True)
        self.results.put(
            "maps", {one.name: summary.of_map(one, found[one.name], self.ranges) for one in chosen}
        )
        pictures.draw_maps(
            list(self.results.get("maps")[0].values()), self.out / "stability_maps.png"
        )
        print(f"wrote {self.out / 'stability_maps.png'}")
        return all(point.as_expected() for points in found.values() for point in points)

    def run_energy(self, _):
        bar = Progress(["energy"] * len(energy.SCENES) * len(energy.SUBSTEPS))
        lines = energy.measure(self.runner(), self.pool, bar)
        bar.close()
        for line in lines:
            print(printed.energy_text(line))
        self.results.put(
            "energy", {f"{line.scene} {line.substeps}": dataclasses.asdict(line) for line in lines}
        )
        return all(line.lived for line in lines)

    def run_long(self, steps):
        bar = Progress([one.name for one in long_runs.LONG])
        runner = self.runner(LONGEST_RUN_S)

        def measure(one):
            found = long_runs.measure(one, steps, runner)
            bar.end(one.name, found.wall_s)
            return found

        lines = list(self.pool.map(measure, long_runs.LONG))
        bar.close()
        for line in lines:
            print(printed.long_text(line))
        self.results.put("long", {line.name: dataclasses.asdict(line) for line in lines})
        pictures.draw_long(
            [(one, runner.run(long_runs.asked(one, steps))) for one in long_runs.LONG],
            self.out / "stability_long.png",
        )
        return all(line.passed() for line in lines)


def known_cases(args):
    """Names of cases of scenes and of commands."""
    return [
        *cases.CASES,
        *commands.listed(commands.find_program(find_run_scene(args.run_scene), args.commands)),
    ]


def chosen_cases(args):
    """Of scenes alone where that is all that is asked for: they need no program of commands."""
    if set(args.case) <= set(cases.CASES):
        return args.case
    every = known_cases(args)
    for name in args.case:
        if name not in every:
            raise Refusal(f"no case {name}; there are: {', '.join(every)}")
    return args.case


def wanted(args):
    """Parts to run and what of each; without a choice all but the long runs."""
    parts = {}
    if args.case:
        parts["cases"] = chosen_cases(args)
    for name in args.map or ():
        if name not in MAPS:
            raise Refusal(f"no map {name}; there are: {', '.join(MAPS)}")
    if args.map:
        parts["maps"] = args.map
    parts["boundaries"] = args.boundaries
    parts["energy"] = args.energy
    parts["long"] = args.steps if args.long else 0
    if any(parts.values()):
        return parts
    return {"cases": known_cases(args), "boundaries": True, "maps": list(MAPS), "energy": True}


def listed():
    lines = [
        f"{one.name:28}{one.number or '':>3}  {one.title}: {one.expected}"
        for one in cases.CASES.values()
    ]
    lines += [f"{one.name:28}map  {one.title}: {one.what}" for one in MAPS.values()]
    return "\n".join([*lines, *(f"{one.name:28}long {one.title}" for one in long_runs.LONG)])


def parser():
    p = Parser("scripts/stability", DESCRIPTION)
    p.add_argument(
        "--case", action="append", metavar="NAME", help="only this case; may stand several times"
    )
    p.add_argument(
        "--map", action="append", metavar="NAME", help="only this map; may stand several times"
    )
    p.add_argument("--boundaries", action="store_true", help="only the ends of every range")
    p.add_argument("--energy", action="store_true", help="only the energy of shipped scenes")
    p.add_argument("--long", action="store_true", help="only the long runs")
    p.add_argument("--steps", type=int, default=1_000_000, help="substeps of a long run (1000000)")
    p.add_argument(
        "--out",
        default=str(ROOT / "out" / "stability"),
        metavar="FOLDER",
        help="out/stability unless told",
    )
    p.add_argument("--jobs", type=int, default=2, help="runs at a time (2)")
    p.add_run_scene()
    p.add_argument(
        "--commands", metavar="PATH", help="stability_test; that of the same build unless told"
    )
    p.add_argument(
        "--document", action="store_true", help="write the tables and pictures of doc/stability.md"
    )
    p.add_argument(
        "--write",
        nargs="+",
        metavar="FOLDER",
        help="run nothing: write doc/stability.md of the --out "
        "folders of earlier runs; of a part that several hold, the last one counts",
    )
    p.add_argument("--list", action="store_true", help="print the cases, maps and long runs")
    return p


def run(words):
    args = parser().parse_args(words)
    if args.jobs < 1 or args.steps < 1:
        raise Refusal("--jobs and --steps must be 1 or more")
    if args.list:
        print(listed())
        return 0
    if args.write:
        document.write([pathlib.Path(folder) for folder in args.write])
        return 0
    suite = Suite(args)
    good = suite.run(wanted(args))
    if args.document:
        document.write([suite.out])
    return 0 if all(good) else 2


def main():
    return exit_code("scripts/stability", run, "stopped; the same command goes on from there")
