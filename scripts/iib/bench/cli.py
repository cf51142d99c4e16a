"""The command line of scripts/bench."""

import contextlib
import tempfile

from iib.bench import compare, instructions, node_cost, parts, reference, targets
from iib.common.command_line import Parser, exit_code
from iib.common.refusal import Refusal

DESCRIPTION = """Compares what the working tree costs with what a commit costs.

Also measures for doc/performance.md. Both are built the same way in a folder outside of the
repository and run in turn, so that a busy machine disturbs both alike; medians are compared, and a
difference counts only when every run of one lies beyond every run of the other.

Needs scripts/install_dependencies build bench (and run, for --node).
"""

EXAMPLES = """examples:
  scripts/bench                        # the working tree against HEAD
  scripts/bench v0.1 --filter bound --runs 9
  scripts/bench HEAD~3 --keep /tmp/b   # keeps the builds there for the next time
  scripts/bench --count HEAD~3         # instructions in place of time
  scripts/bench --without-ice          # water only, against a build that knows no ice
  scripts/bench --parts                # what each optional part costs
  scripts/bench --targets              # bound, threads, size: the targets of doc/performance.md
  scripts/bench --node                 # the ROS node against run_scene
  scripts/bench --reference            # writes bench/results/<processor>.csv
"""


def parser():
    p = Parser("scripts/bench", DESCRIPTION, epilog=EXAMPLES)
    p.add_argument(
        "commit", nargs="?", default="HEAD", help="what to compare with; HEAD unless told"
    )
    p.add_argument("--count", action="store_true", help="compare instructions, by callgrind")
    p.add_argument(
        "--without-ice",
        action="store_true",
        help="instructions of water only, against a build without springs and temperature",
    )
    p.add_argument(
        "--parts",
        action="store_true",
        help="instructions and bytes of each optional part, on and absent",
    )
    p.add_argument("--targets", action="store_true", help="ratios that have a target")
    p.add_argument("--node", action="store_true", help="what the ROS node costs over run_scene")
    p.add_argument("--reference", action="store_true", help="write bench/results/<processor>.csv")
    p.add_argument(
        "--filter",
        default="n:30000|colliders",
        metavar="REGEX",
        help="which micro-benchmarks to compare (default: %(default)s)",
    )
    p.add_argument("--runs", type=int, default=5, help="runs of each side (default: %(default)s)")
    p.add_argument("--stages", action="store_true", help="show each stage of each scene too")
    p.add_argument("--keep", metavar="DIR", help="build in DIR and leave it there")
    return p


def measure(args, folder):
    if args.without_ice:
        instructions.without_ice(folder)
    elif args.count:
        instructions.compare_counts(folder, args.commit)
    elif args.parts:
        parts.print_parts(folder)
    elif args.targets:
        targets.print_targets(folder, args.runs)
    elif args.node:
        node_cost.print_costs(folder, args.runs)
    elif args.reference:
        reference.write(folder, args.runs)
    else:
        compare.compare(folder, args.commit, args.filter, args.runs, args.stages)


def run(words):
    args = parser().parse_args(words)
    if args.runs < 1:
        raise Refusal(f"--runs = {args.runs} must be at least 1")
    with contextlib.ExitStack() as stack:
        folder = args.keep or stack.enter_context(tempfile.TemporaryDirectory(prefix="iib_bench_"))
        measure(args, folder)


def main():
    return exit_code("scripts/bench", run)
