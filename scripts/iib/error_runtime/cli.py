"""Command line of error_vs_runtime."""

import importlib.util
import math
import pathlib
import re
import shlex
import signal

from iib.common.command_line import Parser, exit_code
from iib.common.paths import DOC, ROOT
from iib.common.refusal import Refusal
from iib.common.run_scene import find_run_scene
from iib.error_runtime.campaign import Campaign, measure
from iib.error_runtime.grid import SHORTHANDS, expand, parse_grid
from iib.error_runtime.peers import read_peers
from iib.error_runtime.points import axes_of, table

DESCRIPTION = """Runs a scene over a grid of settings and reports error against run time.

Each point of the grid runs --repeats times, one run at a time, in rounds: every point once, then
every point again. Medians and spread go into --out as points.csv and points.json, pictures as
error.png and metrics.png. Ctrl-C loses only the run under way: the same command goes on where it
stopped. The same folder takes further points of the same scene, so a grid may grow."""

EXAMPLES = """Examples:
  scripts/error_vs_runtime --scene dam_break --substeps 2,4,8,16 --iterations 1,2
  scripts/error_vs_runtime --scene dam_break --substeps 4,8 --grid solver.epsilon=0.01,0.1
  scripts/error_vs_runtime --scene dam_break --substeps 2,4,8 --trajectory 0.5 --peers peers.csv
  scripts/error_vs_runtime --scene freeze_container --duration 3 --preset default,paper
  scripts/error_vs_runtime --report           # measures what is missing, writes the document
  scripts/error_vs_runtime --report --no-run  # only writes it again

Peers' points: a CSV with the columns peer,method,setting,particles,threads,precision,
us_per_particle_per_s,mean_error_percent,max_error_percent.

Exit code: 0 all points ran (unstable and refused ones are marked in the tables), 1 bad input,
2 no point was stable, 130 stopped before the end."""


def parser():
    p = Parser("scripts/error_vs_runtime", DESCRIPTION, epilog=EXAMPLES)
    p.add_argument("--scene", help="name of a scene, or path of a .yaml file")
    grid = p.add_argument_group("axes of the grid, values between commas")
    for name, key in SHORTHANDS.items():
        grid.add_argument("--" + name.replace("_", "-"), metavar="V1,V2", help=key)
    grid.add_argument(
        "--grid",
        action="append",
        default=[],
        metavar="KEY=V1,V2",
        help="any key of config/default.yaml by its dotted name; may stand several times",
    )
    p.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="holds for every point"
    )
    p.add_argument("--duration", type=float, help="simulated seconds; without it the scene's own")
    p.add_argument("--repeats", type=int, default=3, help="runs per point (3)")
    p.add_argument(
        "--timeout", type=float, default=600, help="wall seconds that a run may take (600)"
    )
    p.add_argument(
        "--trajectory",
        type=float,
        default=0,
        metavar="SECONDS",
        help="compare the first seconds with a reference in double, made once",
    )
    p.add_argument(
        "--trajectory-substeps", type=int, default=64, help="substeps of the reference (64)"
    )
    p.add_argument("--peers", metavar="FILE", help="points of other programs, drawn beside these")
    p.add_argument("--out", type=pathlib.Path, help="folder (out/error_vs_runtime/SCENE)")
    p.add_argument("--no-pictures", action="store_true", help="tables only; needs no matplotlib")
    p.add_argument("--fresh", action="store_true", help="forget what the folder holds")
    p.add_argument(
        "--resume", action="store_true", help="go on where it stopped: what happens anyway"
    )
    p.add_run_scene()
    p.add_argument(
        "--report", action="store_true", help="write doc/error_vs_runtime.md and its pictures"
    )
    p.add_argument(
        "--no-run", action="store_true", help="with --report: from what has been measured"
    )
    p.add_argument("--doc", type=pathlib.Path, default=DOC, help="folder of the report (doc)")
    return p


def require(thing, value, low, high):
    if not (math.isfinite(value) and low <= value <= high):
        raise Refusal(f"{thing} = {value:g} is outside the allowed range [{low:g}, {high:g}]")


def check_options(args):
    require("--repeats", args.repeats, 1, 1000)
    require("--timeout", args.timeout, 0.1, 1e6)
    require("--trajectory", args.trajectory, 0, 1e4)
    require("--trajectory-substeps", args.trajectory_substeps, 2, 1000)
    if args.duration is not None:
        require("--duration", args.duration, 1e-4, 1e6)
    if args.no_run and not args.report:
        raise Refusal("--no-run only goes with --report")
    for text in args.set:
        if not re.match(r"[^=]+=.", text):
            raise Refusal(f'--set "{text}" must be key=value, as --set solver.epsilon=0.1')
    if args.fresh and args.resume:
        raise Refusal("--fresh and --resume contradict each other; leave one out")
    if args.scene is None and not args.report:
        raise Refusal("name a scene with --scene; run_scene --list shows them")


def require_modules(*lists):
    """Before anything runs, not after an hour of it."""
    for name in [name for names in lists for name in names]:
        if importlib.util.find_spec(name) is None:
            raise Refusal(f"needs the Python module {name}; run scripts/install_dependencies plot")


def run_grid(args, program, command):
    axes = parse_grid({name: getattr(args, name) for name in SHORTHANDS}, args.grid)
    peers = read_peers(args.peers) if args.peers else []
    out = args.out or ROOT / "out" / "error_vs_runtime" / pathlib.Path(args.scene).stem
    campaign = Campaign(
        args.scene,
        out,
        axes,
        expand(axes),
        args.duration,
        tuple(args.set),
        args.repeats,
        args.timeout,
        args.trajectory,
        args.trajectory_substeps,
    )
    runs = measure(campaign, program, command, args.fresh)
    rows = table(runs)
    if not args.no_pictures:
        from iib.error_runtime.plots import draw  # takes a second, so only where it is needed

        draw(out, rows, axes_of(runs), peers, pathlib.Path(args.scene).stem)
    pictures = "" if args.no_pictures else ", error.png, metrics.png"
    stable = sum(row["status"] == "ok" for row in rows)
    print(f"{len(rows)} points, {stable} stable; {out}/points.csv, points.json" + pictures)
    return 0 if stable else 2


def run(words):
    args = parser().parse_args(words)
    check_options(args)
    require_modules(
        [] if args.no_pictures else ["matplotlib"], ["numpy"] if args.trajectory else []
    )
    command = shlex.join(["scripts/error_vs_runtime", *words])
    if args.report:
        from iib.error_runtime.report import make_report

        return make_report(args, command)
    return run_grid(args, find_run_scene(args.run_scene), command)


def main():
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    stopped = "stopped; what was finished is kept, the same command goes on from there"
    return exit_code("error_vs_runtime", run, stopped)
