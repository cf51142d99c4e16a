"""The command line of scripts/leaks."""

import concurrent.futures
import os
import pathlib
import time

from iib.common.command_line import Parser, exit_code
from iib.common.progress import Progress
from iib.common.refusal import Refusal
from iib.common.run_scene import find_built
from iib.leaks import tally, trials

DESCRIPTION = """Moves vessels of water and counts the particles that go through their walls.

Each vessel makes all motions at several spacings. The quality, and whether an open vessel stands in
a closed box that moves along, change from trial to trial. Prints a table, and for each trial that
leaks the command that repeats it.
Meaning and figures: doc/leaks.md.

Examples:
  scripts/leaks                                  # every vessel and motion, about 10 min
  scripts/leaks --quick                          # coarse water only, less than a minute
  scripts/leaks --vessel bottle --motion shaken --motion tumbled
  scripts/leaks --quick --picture leaks.png      # also draw the table
  scripts/leaks --long                           # ten million particle-seconds: hours
  scripts/leaks --list

Exit code: 0 nothing leaked, 1 something leaked or became NaN, or bad input.
"""
SECONDS, QUICK_SECONDS = 1.2, 0.6
LONG_PARTICLE_SECONDS = 1e7


def parser():
    p = Parser("scripts/leaks", DESCRIPTION)
    p.add_argument("--quick", action="store_true", help="coarse water, less than a minute")
    p.add_argument("--long", action="store_true", help="rounds until 10^7 particle-seconds")
    p.add_argument(
        "--seconds",
        type=float,
        metavar="S",
        help=f"simulated seconds of a motion ({SECONDS:g}, with --quick {QUICK_SECONDS:g})",
    )
    p.add_argument("--vessel", action="append", metavar="NAME", help="only this one; repeatable")
    p.add_argument("--motion", action="append", metavar="NAME", help="only this one; repeatable")
    p.add_argument(
        "--spacing",
        action="append",
        type=float,
        metavar="M",
        help=f"only this one, of {', '.join(f'{s:g}' for s in trials.SPACINGS_M)} m; repeatable",
    )
    p.add_argument("--picture", metavar="FILE", help="also draw the table; needs matplotlib")
    p.add_argument("--jobs", type=int, default=os.cpu_count(), help="trials at a time")
    p.add_argument("--list", action="store_true", help="print the vessels and motions")
    p.add_argument(
        "--leak-trial", metavar="PATH", help="program (default: the newest in the build folders)"
    )
    return p


def chosen(wanted, known, noun):
    for name in wanted or []:
        if name not in known:
            raise Refusal(f"no {noun} {name}; there are: {', '.join(known)}")
    return [name for name in known if not wanted or name in wanted]


def checked(args):
    if args.quick and args.long:
        raise Refusal("--quick and --long contradict each other")
    if args.seconds is not None and not 0.01 <= args.seconds <= 1e5:
        raise Refusal(f"--seconds {args.seconds:g} is outside [0.01, 100000]")
    for spacing_m in args.spacing or []:
        if spacing_m not in trials.SPACINGS_M:
            raise Refusal(f"--spacing {spacing_m:g} is none of {trials.SPACINGS_M}")
    if args.jobs < 1:
        raise Refusal("--jobs must be 1 or more")
    folder = pathlib.Path(args.picture or ".").resolve().parent
    if not folder.is_dir():
        raise Refusal(f"--picture {args.picture}: there is no folder {folder}")
    return args


class Bench:
    def __init__(self, args):
        self.args, self.program = args, find_built("leak_trial", args.leak_trial)
        vessels, motions = trials.names(self.program)
        self.vessels = chosen(args.vessel, vessels, "vessel")
        self.motions = chosen(args.motion, motions, "motion")

    def round(self, number):
        usual = trials.QUICK_SPACINGS_M if self.args.quick else trials.SPACINGS_M
        spacings_m = self.args.spacing or usual
        seconds = self.args.seconds or (QUICK_SECONDS if self.args.quick else SECONDS)
        return trials.of_round(
            self.vessels, self.motions, spacings_m, seconds, number, self.args.quick
        )

    def measure_round(self, number):
        """Results of a round."""
        todo, results = self.round(number), []
        bar = Progress([f"{trial.spacing_m:g}" for trial in todo])
        with concurrent.futures.ThreadPoolExecutor(self.args.jobs) as pool:
            running = [pool.submit(self.measure_trial, trial, bar) for trial in todo]
            try:
                for done in concurrent.futures.as_completed(running):
                    results += done.result()
            except BaseException:
                pool.shutdown(cancel_futures=True)
                raise
            finally:
                bar.close()
        return results

    def measure_trial(self, trial, bar):
        start = time.monotonic()
        results = trials.measure(self.program, trial)
        bar.end(f"{trial.spacing_m:g}", time.monotonic() - start)
        failed = [r for r in results if r["through_wall"] or r["nan"]]
        for one in failed:
            bar.close()
            what = f"{one['motion']}: {one['through_wall']} through a wall, {one['nan']} NaN"
            print(f"{what}: {trial.command()}", flush=True)
        return results

    def measure(self):
        results = self.measure_round(0)
        number = 1
        while self.args.long and tally.of(results)[0].particle_seconds < LONG_PARTICLE_SECONDS:
            results += self.measure_round(number)
            number += 1
        return results


def run(words):
    args = checked(parser().parse_args(words))
    bench = Bench(args)
    if args.list:
        print("vessels:", ", ".join(bench.vessels))
        print("motions:", ", ".join(bench.motions))
        return 0
    start = time.monotonic()
    total, pairs = tally.of(bench.measure())
    print(tally.table(bench.vessels, bench.motions, total, pairs))
    print(
        f"{total.particle_seconds:,.0f} particle-seconds in {total.seconds:.0f} s of motion, "
        f"{total.through_wall:,} through a wall, {total.nan:,} NaN, "
        f"{time.monotonic() - start:.0f} s of wall time"
    )
    if args.picture:
        from iib.leaks import picture

        picture.write(args.picture, bench.vessels, bench.motions, total, pairs)
        print(f"wrote {args.picture}")
    return 1 if total.failed() else 0


def main():
    return exit_code("scripts/leaks", run)
